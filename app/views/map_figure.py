"""The figure of the contact map: image, marks, frame, colour bar and what the pointer is told."""

from __future__ import annotations

from typing import Any

import numpy as np
from bokeh.models import (
    ColumnDataSource,
    CustomJSHover,
    DataRange1d,
    FixedTicker,
    HoverTool,
    LinearColorMapper,
)
from bokeh.models.annotations import ColorBar
from bokeh.plotting import figure

from .map_modes import STATES
from .map_scale import Scale
from .style import LIVE, Size

#: not in contact: grey on white and on black, unlike the darkest blue and unlike white
APART = "#8A8F9866"
#: of no map in use, so that it says "beyond the scale"
BEYOND = "#D81B7A"
NO_MARKS: dict[str, list[Any]] = {"x": [], "y": [], "marker": []}
NO_FRAME: dict[str, list[Any]] = {"x": [], "y": [], "side": []}

_WHERE = "const at = special_vars.image_index; return `row ${at.j}, column ${at.i}`"
# what is no number would be written as NaN before it could be told otherwise
_STATE = """
const known = image.data.value[0][special_vars.image_index.flat_index]
const digits = String(Number(Number(known).toPrecision(3))).replaceAll("-", "−")
const said = Number.isFinite(known) ? `, ${digits} ${unit}` : ""
return names[value] + said
"""


def no_image(side: float) -> dict[str, list[Any]]:
    """A patch of a side [mm] on which nothing touches."""
    return {
        "shown": [np.full((1, 1), np.nan, np.float32)], "value": [np.full((1, 1), np.nan)],
        "state": [np.zeros((1, 1), np.int8)], "side": [side], "corner": [0.0],
    }  # fmt: skip


class MapFigure:
    """Attributes: `root` a Bokeh figure; `image`, `marks`, `frame` its sources; `mapper`, `bar`
    its colours; `unit` of the value at the pointer."""

    def __init__(self) -> None:
        self.image = ColumnDataSource(no_image(20.0), name="map")
        self.marks = ColumnDataSource(NO_MARKS, name="tension")
        self.frame = ColumnDataSource(NO_FRAME, name="followed")
        self.mapper = LinearColorMapper(
            palette=Scale().palette, low=0, high=1, nan_color=APART, high_color=BEYOND
        )
        # ranges that follow what is drawn keep the cells square at any width
        ranges: list[Any] = [DataRange1d(range_padding=0) for _ in range(2)]
        self.root: Any = figure(
            x_axis_label="x [mm]; grey: not in contact", y_axis_label="y [mm]",
            x_range=ranges[0], y_range=ranges[1],
            match_aspect=True, sizing_mode="scale_width", tools="save", toolbar_location="above",
            output_backend="canvas", min_border_right=40, outline_line_color=None,
        )  # fmt: skip
        self._draw()
        for data_range in ranges:
            data_range.renderers = [self._image]
        self._add_bar()
        self._add_hover()
        self._style()

    @property
    def unit(self) -> str:
        return str(self._formatter.args["unit"])

    @unit.setter
    def unit(self, unit: str) -> None:
        if unit != self.unit:
            self._formatter.args = {**self._formatter.args, "unit": unit}

    def colour(self, palette: tuple[str, ...], low: float, high: float) -> None:
        """Colour what is between two values."""
        if tuple(self.mapper.palette) != tuple(palette):
            self.mapper.palette = palette
        self.mapper.update(low=low, high=high)

    def label(self, ticks: dict[float, str]) -> None:
        """Label the colour bar: value -> text."""
        # the ticker stays: for another model all of the page's would be looked through
        self.bar.ticker.ticks = list(ticks)
        self.bar.major_label_overrides = ticks

    def mark_for(self, elements: int) -> None:
        """Size of the marks where there are so many elements along a side."""
        self._marks.glyph.size = max(3.0, 120 / elements)

    def enlarge(self, size: Size, lines: int) -> None:
        """Set the type, and a shape of which the map, with a title of so many lines, takes all at
        440 px."""
        size.apply(self.root)
        self.bar.major_label_text_font_size = f"{size.tick}px"
        wide = 52 + 1.2 * size.label + 1.2 * size.tick
        high = 50 + 1.2 * (lines * size.title + size.label + 2 * size.tick)
        self.root.aspect_ratio = 440 / (440 - wide + high)

    def _draw(self) -> None:
        self._image = self.root.image(
            "shown", source=self.image, x="corner", y="corner", dw="side", dh="side",
            color_mapper=self.mapper, level=LIVE,
        )  # fmt: skip
        self._marks = self.root.scatter(
            "x", "y", source=self.marks, marker="marker", size=6, fill_color="white",
            line_color="black", line_width=1, level=LIVE,
        )  # fmt: skip
        for color, width in (("white", 5), ("black", 2)):
            self.root.rect(
                "x", "y", "side", "side", source=self.frame, fill_color=None, line_color=color,
                line_width=width, level=LIVE,
            )  # fmt: skip

    def _add_bar(self) -> None:
        self.bar = ColorBar(
            color_mapper=self.mapper, ticker=FixedTicker(ticks=[]), width="auto", height=12,
            padding=4, margin=0,
            label_standoff=5, background_fill_alpha=0, major_tick_line_color=None,
        )  # fmt: skip
        self.root.add_layout(self.bar, "below")

    def _add_hover(self) -> None:
        args = {"names": list(STATES), "image": self.image, "unit": ""}
        self._formatter = CustomJSHover(code=_STATE, args=args)
        formatters: dict[str, Any] = {
            "$x": CustomJSHover(code=_WHERE),
            "@state": self._formatter,
        }
        tips = [("element", "$x{custom}"), ("state", "@state{custom}")]
        self.root.add_tools(
            HoverTool(renderers=[self._image], tooltips=tips, formatters=formatters)
        )

    def _style(self) -> None:
        self.root.toolbar.logo = None
        self.root.toolbar.autohide = True
        self.root.grid.visible = False
        self.root.axis.axis_label_text_font_style = "normal"
