"""Newton iterations of each step, the steps that failed, and the most that is allowed."""

from __future__ import annotations

import numpy as np
from bokeh.models import Span

from tyrecontact.results import Record

from .style import GREY, RUN_COLOR, VERMILION, Horizontal, hover, plot, put_on
from .trace import Trace

#: vertical range at first, if more iterations than that are allowed
_SHOWN = 10


class IterationsView:
    """Attributes: `root` a Bokeh figure; `source`, `failed` what it draws."""

    def __init__(self) -> None:
        self._all = Trace("iterations", "iterations", "iterations")
        self._bad = Trace("iterations", "iterations")
        self.source, self.failed = self._all.source, self._bad.source
        self.root = plot("Newton iterations a step", "Iterations", height=230, top=11)
        self.limit = Span(dimension="width", location=10, line_color=GREY, line_dash="dashed")
        self.root.add_layout(self.limit)
        line = self.root.step(
            "indentation_um", "iterations", source=self.source, mode="center",
            line_color=RUN_COLOR[False],
            line_width=1.5,
        )  # fmt: skip
        marks = self.root.scatter(
            "indentation_um", "iterations", source=self.failed, marker="x", size=7,
            line_color=VERMILION, line_width=2,
        )  # fmt: skip
        self._glyphs = [line, marks]
        tips = [("iterations", "@iterations"), ("indentation", "@indentation_um{0.0} µm")]
        hover(self.root, line, tips, "mouse")

    def show_against(self, axis: Horizontal) -> None:
        """Change the horizontal axis."""
        put_on(self.root, self._glyphs, axis)

    def look(self) -> None:
        """Show in full what of a long run the horizontal range has been narrowed to."""
        span, axis = self.root.x_range, self._glyphs[-1].glyph.x
        for points in (self._all, self._bad):
            points.look(axis, span.start, span.end)

    def darken(self, dark: bool) -> None:
        """Follow the page's theme."""
        self._glyphs[0].glyph.line_color = RUN_COLOR[dark]

    def reset(self, max_iterations: int) -> None:
        self._all.clear()
        self._bad.clear()
        self.limit.location = max_iterations
        self.root.y_range.end = 1.1 * min(max_iterations, _SHOWN)

    def update(self, record: Record, low: int, high: int, ended: bool = False) -> None:
        """Add rows low .. high - 1; `ended` where no more will come."""
        columns = record.columns
        self._all.update(columns, np.arange(high), ended)
        span = self.root.y_range
        span.end = max(span.end, 1.1 * columns["iterations"][low:high].max(initial=0))
        self._bad.update(columns, np.flatnonzero(columns["converged"][:high] == 0), ended)
