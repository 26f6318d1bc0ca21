"""Contact force against indentation or time, with the quasi-static run in grey."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource

from tyrecontact.results import Record

from ..runner import Baseline
from .style import GREY, LIVE, RUN_COLOR, VERMILION, Horizontal, Size, cursor, hover, plot, put_on
from .trace import Trace

_COLUMNS = ("time_ms", "indentation_um", "force")
#: vertical range before the first run [N]
_TOP = 500.0
#: of steps that have not converged
_FADED = 0.35


class ForceView:
    """Attributes: `root` a Bokeh figure; `source`, `failed`, `baseline` what it draws; `cursor`."""

    def __init__(self) -> None:
        self._all = Trace("force", "contact_force", "force")
        self._sound, self._bad = Trace("force", "contact_force"), Trace("force", "contact_force")
        self.source, self.failed = self._all.source, self._bad.source
        self.baseline = ColumnDataSource({name: [] for name in _COLUMNS})
        self.root = plot("Contact force", "Force [N]", None, top=_TOP)
        self.cursor = cursor(self.root)
        self._glyphs = []
        self._line(self.baseline, GREY, 5, alpha=0.55, level="glyph")
        line = self._run = self._line(self.source, RUN_COLOR[False], 2)
        self._over = self._line(self._sound.source, RUN_COLOR[False], 2)
        marks = self.root.scatter(
            "indentation_um", "force", source=self.failed, marker="x", size=7,
            line_color=VERMILION, line_width=2, level=LIVE,
        )  # fmt: skip
        self._glyphs.append(marks)
        tips = [("force", "@force{0.0} N"), ("indentation", "@indentation_um{0.0} µm")]
        hover(self.root, line, [*tips, ("time", "@time_ms{0.000} ms")], "mouse")
        self.root.min_border_right = 74  # as the plot below, whose second axis stands there

    def _line(
        self,
        source: ColumnDataSource,
        color: str,
        width: float,
        alpha: float = 1.0,
        level: str = LIVE,
    ) -> Any:
        line = self.root.line(
            "indentation_um", "force", source=source, line_color=color, line_width=width,
            line_alpha=alpha, level=level,
        )  # fmt: skip
        self._glyphs.append(line)
        return line

    def show_against(self, axis: Horizontal) -> None:
        """Change the horizontal axis."""
        put_on(self.root, self._glyphs, axis)

    def look(self) -> None:
        """Show in full what of a long run the horizontal range has been narrowed to."""
        span, axis = self.root.x_range, self._glyphs[-1].glyph.x
        for points in (self._all, self._sound, self._bad):
            points.look(axis, span.start, span.end)

    def point_at(self, place: float | None) -> None:
        """Mark a place on the horizontal axis, or none."""
        self.cursor.update(location=place or 0.0, visible=place is not None)

    def enlarge(self, size: Size) -> None:
        """Set the type."""
        size.apply(self.root)
        self.root.min_border_left = size.left
        for line in (self._run, self._over):
            line.glyph.line_width = 2 * size.line

    def darken(self, dark: bool) -> None:
        """Follow the page's theme."""
        for line in (self._run, self._over):
            line.glyph.line_color = RUN_COLOR[dark]

    def reset(self) -> None:
        """Show no run."""
        for points in (self._all, self._sound, self._bad):
            points.clear()
        self._run.glyph.line_alpha = 1.0
        self.point_at(None)
        self.baseline.data = {name: [] for name in _COLUMNS}

    def compare_with(self, baseline: Baseline, fit: bool = True) -> None:
        """Draw the quasi-static run, and fit the vertical axis to it."""
        self.baseline.data = {
            "time_ms": baseline.time * 1e3,
            "indentation_um": baseline.indentation * 1e6,
            "force": baseline.contact_force,
        }
        force, span = baseline.contact_force, self.root.y_range
        if fit:
            span.update(start=1.1 * min(force.min(), 0.0), end=1.1 * force.max() or 1.0)

    def make_room_for(self, force: np.ndarray) -> None:
        """Widen the vertical axis in leaps where a force [N], shape (steps,), leaves it; it never
        shrinks in a run.
        """
        span = self.root.y_range
        if force.max(initial=span.end) > span.end:
            span.end = 1.5 * float(force.max())
        if force.min(initial=span.start) < span.start:
            span.start = 1.5 * float(force.min())

    def update(
        self, record: Record, low: int, high: int, ended: bool = False, still: bool = False
    ) -> None:
        """Add rows low .. high - 1; `ended` where no more will come, `still` where not soon."""
        columns = record.columns
        self._all.update(columns, np.arange(high), ended, still)
        self.make_room_for(columns["contact_force"][low:high])
        bad = np.flatnonzero(columns["converged"][:high] == 0)
        self._bad.update(columns, bad, ended, still)
        if bad.size:
            self._fade(columns, high, ended, still)

    def _fade(self, columns: Mapping[str, np.ndarray], high: int, ended: bool, still: bool) -> None:
        """Fade the line of the run, and draw over it what has converged."""
        if self._run.glyph.line_alpha != _FADED:
            self._run.glyph.line_alpha = _FADED
        sound = np.where(columns["converged"] == 0, np.nan, columns["contact_force"])
        self._sound.update({**columns, "contact_force": sound}, np.arange(high), ended, still)
