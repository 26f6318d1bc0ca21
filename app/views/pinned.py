"""Pinned runs behind the live one: thin lines in its plot of the force."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource
from bokeh.models.annotations import LegendItem
from bokeh.plotting import figure

from ..pinned import Pinned
from .comparison import thinned
from .style import Horizontal, Size

_WIDTH = 1.4
#: entries of a legend that stand below each other; more of them take another column
_HIGH = 6
#: characters of a label that a legend has room for on a phone
_ROOM = 18


class PinnedCurves:
    """Force curves of pinned runs in a figure that has a legend.

    A curve that is not needed is hidden and used again: nothing is taken out of the figure.

    Attributes
    ----------
    renderers : of the lines; their columns are time_ms, indentation_um and force.
    """

    def __init__(self, fig: figure) -> None:
        self._fig = fig
        self.renderers: list[Any] = []
        self._entries: list[LegendItem] = []
        self._drawn: list[Pinned | None] = []
        self._width = _WIDTH

    def show(self, pinned: Sequence[Pinned], axis: Horizontal) -> None:
        """Draw these runs against a horizontal axis, and no others; ranges stay as they are."""
        while len(self.renderers) < len(pinned):
            self._add(axis)
        for place, renderer in enumerate(self.renderers):
            run = pinned[place] if place < len(pinned) else None
            if run is not self._drawn[place]:
                self._draw(place, run)
            if renderer.glyph.x != axis.column:
                renderer.glyph.x = axis.column
        legend = self._fig.legend[0]
        shown = sum(isinstance(entry, LegendItem) and bool(entry.visible) for entry in legend.items)
        legend.ncols = max(1, -(-shown // _HIGH))

    def enlarge(self, size: Size) -> None:
        """Set the width of the lines."""
        self._width = _WIDTH * size.line
        for renderer in self.renderers:
            renderer.glyph.line_width = self._width

    def _add(self, axis: Horizontal) -> None:
        line: Any
        entry: Any
        source = ColumnDataSource({name: [] for name in ("time_ms", "indentation_um", "force")})
        line = self._fig.line(
            axis.column, "force", source=source, line_width=self._width, visible=False
        )
        entry = LegendItem(label="", renderers=[line], visible=False)
        self._fig.legend[0].items.append(entry)
        self.renderers.append(line)
        self._entries.append(entry)
        self._drawn.append(None)

    def _draw(self, place: int, run: Pinned | None) -> None:
        renderer, entry = self.renderers[place], self._entries[place]
        before, self._drawn[place] = self._drawn[place], run
        renderer.visible = entry.visible = run is not None
        if run is None:
            renderer.data_source.data = {name: [] for name in renderer.data_source.data}
            return
        renderer.glyph.update(line_color=run.look.color, line_dash=run.look.dash)
        entry.label = {"value": _short(run.label)}
        if before is None or before.results is not run.results:  # not where only its name changed
            renderer.data_source.data = _points(run)


def _short(label: str) -> str:
    return label if len(label) <= _ROOM else f"{label[: _ROOM - 1].rstrip()}…"


def _points(run: Pinned) -> dict[str, np.ndarray]:
    columns = run.results.columns
    rows, force = thinned(np.arange(run.steps), columns["contact_force"])
    return {
        "time_ms": columns["time"][rows] * 1e3,
        "indentation_um": columns["indentation"][rows] * 1e6,
        "force": force,
    }
