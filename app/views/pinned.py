"""Pinned runs behind the live one: thin lines in its plot of the force."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource
from bokeh.plotting import figure

from ..pinned import Pinned
from .comparison import thinned
from .legend import Entry
from .style import Horizontal, Size

_WIDTH = 1.4
#: Bokeh's names as SVG has them
_DASHES = {"solid": "", "dashed": "6 3", "dotted": "2 3", "dotdash": "2 3 6 3"}


class PinnedCurves:
    """Force curves of pinned runs in a figure.

    A curve that is not needed is hidden and used again: nothing is taken out of the figure.

    Attributes
    ----------
    renderers : of the lines; their columns are time_ms, indentation_um and force.
    """

    def __init__(self, fig: figure) -> None:
        self._fig = fig
        self.renderers: list[Any] = []
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

    def enlarge(self, size: Size) -> None:
        """Set the width of the lines."""
        self._width = _WIDTH * size.line
        for renderer in self.renderers:
            renderer.glyph.line_width = self._width

    def _add(self, axis: Horizontal) -> None:
        source = ColumnDataSource({name: [] for name in ("time_ms", "indentation_um", "force")})
        line = self._fig.line(
            axis.column, "force", source=source, line_width=self._width, visible=False
        )
        self.renderers.append(line)
        self._drawn.append(None)

    def _draw(self, place: int, run: Pinned | None) -> None:
        renderer = self.renderers[place]
        before, self._drawn[place] = self._drawn[place], run
        renderer.visible = run is not None
        if run is None:
            renderer.data_source.data = {name: [] for name in renderer.data_source.data}
            return
        renderer.glyph.update(line_color=run.look.color, line_dash=run.look.dash)
        if before is None or before.results is not run.results:  # not where only its name changed
            renderer.data_source.data = _points(run)


def _points(run: Pinned) -> dict[str, np.ndarray]:
    columns = run.results.columns
    rows, force = thinned(np.arange(run.steps), columns["contact_force"])
    return {
        "time_ms": columns["time"][rows] * 1e3,
        "indentation_um": columns["indentation"][rows] * 1e6,
        "force": force,
    }


def entries(pinned: Sequence[Pinned]) -> list[Entry]:
    """What a legend says of them."""
    return [Entry(run.label, run.look.color, _WIDTH, _DASHES[run.look.dash]) for run in pinned]
