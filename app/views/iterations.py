"""Newton iterations of each step, what is allowed, and the stability margin beside them."""

from __future__ import annotations

from typing import Any

import numpy as np
from bokeh.models import LinearAxis, Range1d, Span

from tyrecontact.results import Record

from .style import (
    DESK,
    GREY,
    LIVE,
    MARGIN_COLOR,
    RUN_COLOR,
    VERMILION,
    Horizontal,
    Size,
    cursor,
    hover,
    plot,
    put_on,
)
from .trace import Trace

#: vertical range at first, if more iterations than that are allowed
_SHOWN = 10
#: of the margin on show; a run that blows up leaves it, and is lost by then
_MARGINS = (-1.0, 1.1)
_LABEL = "Margin (below 0: unstable)"


class IterationsView:
    """Attributes: `root` a Bokeh figure; `source`, `failed`, `margin` what it draws; `cursor`."""

    def __init__(self) -> None:
        self._all = Trace("iterations", "iterations", "iterations")
        self._bad = Trace("iterations", "iterations")
        self._margin = Trace("margin", "stability_margin", "margin")
        self.source, self.failed = self._all.source, self._bad.source
        self.margin = self._margin.source
        self.root = plot("Newton iterations a step, and stability margin", "Iterations", None, 11)
        self.cursor = cursor(self.root)
        self.limit = Span(dimension="width", location=10, line_color=GREY, line_dash="dashed")
        self.root.add_layout(self.limit)
        margin = self._margin_line()
        line = self.root.step(
            "indentation_um", "iterations", source=self.source, mode="center",
            line_color=RUN_COLOR[False], line_width=1.5, level=LIVE,
        )  # fmt: skip
        marks = self.root.scatter(
            "indentation_um", "iterations", source=self.failed, marker="x", size=7,
            line_color=VERMILION, line_width=2, level=LIVE,
        )  # fmt: skip
        self._glyphs = [line, margin, marks]
        place = ("indentation", "@indentation_um{0.0} µm")
        hover(self.root, line, [("iterations", "@iterations"), place], "mouse")
        hover(self.root, margin, [("stability margin", "@margin{0.00}"), place], "mouse")

    def _margin_line(self) -> Any:
        self.root.extra_y_ranges = {"margin": Range1d(*_MARGINS)}
        axis = LinearAxis(y_range_name="margin", axis_label=_LABEL)
        axis.axis_label_text_font_style = "normal"
        axis.ticker.desired_num_ticks = 3
        self.root.min_border_right = 74
        self.root.add_layout(axis, "right")
        self._right = axis
        zero = Span(dimension="width", location=0, line_color=MARGIN_COLOR, line_alpha=0.6,
                    line_dash="dotted", y_range_name="margin")  # fmt: skip
        self.root.add_layout(zero)
        return self.root.line(
            "indentation_um", "margin", source=self.margin, y_range_name="margin",
            line_color=MARGIN_COLOR, line_width=2, line_dash=[6, 3], level=LIVE,
        )  # fmt: skip

    def show_against(self, axis: Horizontal) -> None:
        """Change the horizontal axis."""
        put_on(self.root, self._glyphs, axis)

    def look(self) -> None:
        """Show in full what of a long run the horizontal range has been narrowed to."""
        span, axis = self.root.x_range, self._glyphs[-1].glyph.x
        for points in (self._all, self._margin, self._bad):
            points.look(axis, span.start, span.end)

    def point_at(self, place: float | None) -> None:
        """Mark a place on the horizontal axis, or none."""
        self.cursor.update(location=place or 0.0, visible=place is not None)

    def enlarge(self, size: Size) -> None:
        """Set the type."""
        size.apply(self.root)
        self.root.min_border_left = size.left
        # in large type there is no room for all of it
        self._right.axis_label = _LABEL if size == DESK else "Margin"
        for line in self._glyphs[:2]:
            line.glyph.line_width = 2 * size.line

    def darken(self, dark: bool) -> None:
        """Follow the page's theme."""
        self._glyphs[0].glyph.line_color = RUN_COLOR[dark]

    def reset(self, max_iterations: int) -> None:
        """Show no run; the next one may take so many iterations a step."""
        for points in (self._all, self._margin, self._bad):
            points.clear()
        self.point_at(None)
        self.limit.location = max_iterations
        self.root.y_range.end = 1.1 * min(max_iterations, _SHOWN)

    def update(
        self, record: Record, low: int, high: int, ended: bool = False, still: bool = False
    ) -> None:
        """Add rows low .. high - 1; `ended` where no more will come, `still` where not soon."""
        columns = record.columns
        self._all.update(columns, np.arange(high), ended, still)
        self._margin.update(columns, np.arange(high), ended, still)
        span = self.root.y_range
        most = 1.1 * float(columns["iterations"][low:high].max(initial=0))
        span.end = max(span.end, most)
        bad = np.flatnonzero(columns["converged"][:high] == 0)
        self._bad.update(columns, bad, ended, still)
