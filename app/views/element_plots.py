"""Three plots of one element: its force in time, its spring with the working point, its heights."""

from __future__ import annotations

from typing import Any

import numpy as np
from bokeh.models import ColumnDataSource, DataRange1d, LinearColorMapper, Range1d
from bokeh.models.annotations import ColorBar, Span
from bokeh.palettes import Cividis256
from bokeh.plotting import figure

from tyrecontact.road.springs import Springs

from .map_scale import Scale
from .style import DESK, GREY, LIVE, RUN_COLOR, VERMILION, Horizontal, Size, hover, plot, put_on

HEIGHT = 240
#: side of the heights, which are square, in a plot of that height [px]
_SQUARE = 157
#: points of a spring's curve
_POINTS = 160
#: share of the heights that may lie beyond the scale
_PITS = 0.05
PATH: dict[str, list[float]] = {
    "time_ms": [], "indentation_um": [], "force": [], "compression_um": []
}  # fmt: skip
_CURVE: dict[str, list[float]] = {"compression_um": [], "force": []}
_NO_HEIGHTS: dict[str, list[Any]] = {"height": [], "x": [], "y": [], "side": []}


class ForcePlots:
    """Force against time or indentation, and against compression, with one scale of force.

    Attributes
    ----------
    history, spring : Bokeh figures.
    path, now : the element so far and at the step on show.  curve, bond : of its spring.
    limit : tension that its bond bears.
    """

    def __init__(self) -> None:
        self.path, self.now = ColumnDataSource(PATH), ColumnDataSource(PATH)
        self.curve, self.bond = ColumnDataSource(_CURVE), ColumnDataSource(_CURVE)
        self.history: Any = plot("Its force", "Force [N]", HEIGHT, top=1.0)
        self.spring: Any = plot("Its spring", "Force [N]", HEIGHT, top=1.0)
        self.spring.y_range = self.history.y_range
        self.spring.x_range = Range1d(start=0, end=1)
        self.spring.xaxis.axis_label = "Compression [µm]"
        tips = [("force", "@force{0.000} N"), ("compression", "@compression_um{0.00} µm")]
        self._spring_line(self.curve, "solid", tips)
        self._spring_line(self.bond, "dashed", tips)
        self._lines = [
            fig.line(x, "force", source=self.path, line_width=1.6, level=LIVE)
            for fig, x in ((self.history, "indentation_um"), (self.spring, "compression_um"))
        ]
        dots = [
            fig.scatter(x, "force", source=self.now, size=10, fill_color=VERMILION,
                        line_color="white", level=LIVE)
            for fig, x in ((self.history, "indentation_um"), (self.spring, "compression_um"))
        ]  # fmt: skip
        self._against = [self._lines[0], dots[0]]
        hover(self.history, self._lines[0], [*tips[:1], ("time", "@time_ms{0.000} ms")], "mouse")
        self.limit: Any = Span(dimension="width", location=0.0, line_color=VERMILION,
                          line_dash="dotted", line_width=2)  # fmt: skip
        self.spring.add_layout(self.limit)
        self.darken(False)
        self.clear()

    def _spring_line(self, source: ColumnDataSource, dash: str, tips: list[Any]) -> None:
        line = self.spring.line(
            "compression_um", "force", source=source, line_color=GREY, line_width=5,
            line_alpha=0.55, line_dash=dash,
        )  # fmt: skip
        hover(self.spring, line, tips, "mouse")

    def clear(self) -> None:
        for source, empty in ((self.path, PATH), (self.now, PATH), (self.curve, _CURVE),
                              (self.bond, _CURVE)):  # fmt: skip
            source.data = empty
        self._force, self._depth = Scale(), Scale()
        self._springs: Springs | None = None
        self._sticks = self.limit.visible = False

    def show_spring(
        self, springs: Springs, element: int, limit: float | None, sticks: bool
    ) -> None:
        """Take the spring of an element, and the tension [N] that its bond bears, if known.

        sticks : a bond pulls as the spring pushes.
        """
        self._springs, self._sticks = springs.take(np.array([element])), sticks
        self.limit.visible = bool(limit)
        self.limit.location = -(limit or 0.0)
        more = f"; its bond bears {limit:.3g} N" if limit else ""
        self.spring.title.text = f"On its spring (grey){more}"
        self._fit(0.0, 0.0, 0.0, 1.0)

    def show_path(self, path: dict[str, np.ndarray]) -> None:
        """Draw the element so far."""
        self.path.data = path
        force, depth = path["force"], path["compression_um"]
        depth = depth[np.isfinite(depth)]
        self._fit(force.min(initial=0), force.max(initial=0), depth.min(initial=0),
                  depth.max(initial=0))  # fmt: skip

    def show_now(self, now: dict[str, np.ndarray]) -> None:
        """Put the working point."""
        self.now.data = now
        depth = float(np.nan_to_num(now["compression_um"][0]))
        force = float(now["force"][0])
        self._fit(min(force, 0.0), max(force, 0.0), min(depth, 0.0), max(depth, 0.0))

    def _fit(self, pull: float, push: float, drawn: float, pressed: float) -> None:
        """Make room in leaps: what is on show does not jump with every frame."""
        if pull < 0:
            pull = min(pull, self.limit.location)  # where it would break is worth seeing
        force, depth = self._force.holding(pull, push), self._depth.holding(drawn, pressed)
        if force != self._force:
            self._force = force
            self.history.y_range.update(start=force.low, end=force.high or 1.0)
        if depth != self._depth:
            self._depth = depth
            self.spring.x_range.update(start=depth.low, end=depth.high)
            self._draw_spring()

    def _draw_spring(self) -> None:
        if self._springs is None:
            return
        depth = np.linspace(0, max(self._depth.high, -self._depth.low), _POINTS)
        force = self._springs.force(depth[:, None] * 1e-6)[:, 0]
        self.curve.data = {"compression_um": depth, "force": force}
        mirrored = self._sticks and self._depth.low
        self.bond.data = {"compression_um": -depth, "force": -force} if mirrored else _CURVE

    def show_against(self, axis: Horizontal) -> None:
        put_on(self.history, self._against, axis)

    def darken(self, dark: bool) -> None:
        for line in self._lines:
            line.glyph.line_color = RUN_COLOR[dark]


class HeightsPlot:
    """The heights within an element, what touches marked. Attributes: `root` a Bokeh figure;
    `heights`, `touching` what it draws."""

    def __init__(self) -> None:
        self.heights, self.touching = ColumnDataSource(_NO_HEIGHTS), ColumnDataSource(_NO_HEIGHTS)
        ranges: list[Any] = [DataRange1d(range_padding=0) for _ in range(2)]
        self.root: Any = figure(
            title="Its small scale; red touches", x_axis_label="x [mm]", y_axis_label="y [mm]",
            x_range=ranges[0], y_range=ranges[1], frame_width=_SQUARE, frame_height=_SQUARE,
            tools="save", toolbar_location="above",
            output_backend="canvas", outline_line_color=None, min_border_left=64,
        )  # fmt: skip
        self.root.toolbar.logo, self.root.toolbar.autohide = None, True
        self.root.grid.visible = False
        self.mapper = LinearColorMapper(palette=Cividis256, low=-1, high=0)
        self._draw(ranges)
        self.bar = ColorBar(color_mapper=self.mapper, title="µm", width=10, padding=4,
                            background_fill_alpha=0)  # fmt: skip
        self.root.add_layout(self.bar, "right")
        self.clear()

    def _draw(self, ranges: list[Any]) -> None:
        clear = LinearColorMapper(palette=["#00000000", VERMILION], low=0, high=1)
        images = [
            self.root.image("height", source=source, x="x", y="y", dw="side", dh="side",
                            color_mapper=mapper)
            for source, mapper in ((self.heights, self.mapper), (self.touching, clear))
        ]  # fmt: skip
        hover(self.root, images[0], [("below its top", "@height{0.0} µm")], "mouse")
        for data_range in ranges:
            data_range.renderers = images[:1]

    def enlarge(self, size: Size) -> None:
        """Set the type, and the side that goes with it."""
        size.apply(self.root)
        side = round(_SQUARE * size.label / DESK.label)
        self.root.update(frame_width=side, frame_height=side)
        self.bar.major_label_text_font_size = f"{size.tick}px"

    def clear(self) -> None:
        self.heights.data = self.touching.data = _NO_HEIGHTS
        self._place: dict[str, list[float]] = {}
        self._count = -1

    def show(self, below_top: np.ndarray, corner: tuple[float, float], side: float) -> None:
        """Draw heights [m] below the top, shape (ny, nx), of an element of a side [m] whose
        corner is at (x, y) [m].
        """
        height = (below_top * 1e6).astype(np.float32)
        self._place = {"x": [corner[0] * 1e3], "y": [corner[1] * 1e3], "side": [side * 1e3]}
        self._sorted = np.sort(height, axis=None)[::-1]
        # a pit would leave one colour for all the rest: what is deeper has the darkest
        self.mapper.low = float(np.quantile(height, _PITS)) or -1.0
        self.heights.data = {"height": [height], **self._place}
        self._height, self._count = height, -1

    def touch(self, share: float) -> None:
        """Mark the highest share of the area; nothing is sent where it looks the same."""
        count = round(min(max(share, 0.0), 1.0) * self._sorted.size) if self._place else -1
        if count == self._count:
            return
        self._count = count
        least = self._sorted[count - 1] if count else np.inf
        touching = (self._height >= least).astype(np.uint8)
        self.touching.data = {"height": [touching], **self._place}


def enlarge(fig: figure, size: Size) -> None:
    """Set type and height of one of these plots."""
    size.apply(fig)
    fig.height = round(HEIGHT * size.label / DESK.label)
