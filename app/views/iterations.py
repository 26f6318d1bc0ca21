"""Newton iterations of each step, the steps that failed, and the most that is allowed."""

from __future__ import annotations

from bokeh.models import ColumnDataSource, Span

from tyrecontact.results import Record

from .style import GREY, RUN_COLOR, VERMILION, Horizontal, hover, plot, put_on

_COLUMNS = ("time_ms", "indentation_um", "iterations")
#: vertical range at first, if more iterations than that are allowed
_SHOWN = 10


class IterationsView:
    """Attributes: `root` a Bokeh figure; `source`, `failed` what it draws."""

    def __init__(self) -> None:
        self.source = ColumnDataSource({name: [] for name in _COLUMNS}, name="iterations")
        self.failed = ColumnDataSource({name: [] for name in _COLUMNS})
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

    def darken(self, dark: bool) -> None:
        """Follow the page's theme."""
        self._glyphs[0].glyph.line_color = RUN_COLOR[dark]

    def reset(self, max_iterations: int) -> None:
        for source in (self.source, self.failed):
            source.data = {name: [] for name in _COLUMNS}
        self.limit.location = max_iterations
        self.root.y_range.end = 1.1 * min(max_iterations, _SHOWN)

    def update(self, record: Record, low: int, high: int) -> None:
        """Add rows low .. high - 1."""
        columns = record.columns
        rows = {
            "time_ms": columns["time"][low:high] * 1e3,
            "indentation_um": columns["indentation"][low:high] * 1e6,
            "iterations": columns["iterations"][low:high],
        }
        self.source.stream(rows)
        self.root.y_range.end = max(self.root.y_range.end, 1.1 * rows["iterations"].max())
        bad = columns["converged"][low:high] == 0
        if bad.any():
            self.failed.stream({name: values[bad] for name, values in rows.items()})
