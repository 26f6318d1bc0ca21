"""A whole road file with the patch marked on it, before it is used."""

from __future__ import annotations

import numpy as np
import panel as pn
from bokeh.models import BoxAnnotation, ColorBar, ColumnDataSource, LinearColorMapper, Range1d
from bokeh.palettes import Cividis256
from bokeh.plotting import figure

from tyrecontact.parts.road import Road
from tyrecontact.road.overview import Overview

from .style import DESK, GREY, VERMILION, hover

#: of the drawing [px]
HEIGHT = 330
#: of a profile: readable on white and on a dark dialog
_LINE = "#2B8CC4"
#: where nothing was measured
_NOTHING = "#9AA0A859"


class RoadPreview:
    """Heights of a file, in colours or as a curve; the patch moves on them.

    Attributes
    ----------
    root : of Panel, empty until something is shown.
    map, line : what draws a map and a profile; None until one is shown.
    """

    def __init__(self) -> None:
        self.root = pn.Column(sizing_mode="stretch_width", min_height=HEIGHT)
        self.map: MapPreview | None = None
        self.line: LinePreview | None = None
        self._shown: MapPreview | LinePreview | None = None

    def clear(self) -> None:
        """Show nothing."""
        self.root.objects = []
        self._shown = None

    def show(self, view: Overview, road: Road) -> None:
        """Draw a file and mark what the settings take of it."""
        shown: MapPreview | LinePreview
        if view.is_profile:
            shown = self.line = self.line or LinePreview()
        else:
            shown = self.map = self.map or MapPreview()
        shown.show(view)
        shown.mark(road)
        if self._shown is not shown:
            self._shown = shown
            self.root.objects = [shown.pane]

    def mark(self, road: Road) -> None:
        """Move the marks to where other settings want them."""
        if self._shown is not None:
            self._shown.mark(road)


class MapPreview:
    """Attributes: `figure`, its `pane`; `image` and `patch` what it draws; `mapper` its colours."""

    def __init__(self) -> None:
        self.image = ColumnDataSource({name: [] for name in ("height", "x", "y", "dx", "dy")})
        self.patch = ColumnDataSource({"x": [], "y": [], "side": []})
        self.mapper = LinearColorMapper(Cividis256, low=0, high=1, nan_color=_NOTHING)
        self.figure = _figure(
            "Square: the patch that is used", "x from the middle [mm]", "y from the middle [mm]"
        )
        self.figure.match_aspect = True
        self.figure.grid.visible = False
        cells = self.figure.image(
            "height", source=self.image, x="x", y="y", dw="dx", dh="dy", color_mapper=self.mapper
        )
        for color, width in (("white", 5), (VERMILION, 2.5)):  # seen on dark and on bright
            self.figure.rect(
                "x", "y", "side", "side", source=self.patch, fill_color=None, line_color=color,
                line_width=width,
            )  # fmt: skip
        hover(self.figure, cells, [("height", "@height{0.0} µm")], "mouse")
        bar = ColorBar(
            color_mapper=self.mapper, title="Height [µm]", title_text_font_style="normal", width=12,
            background_fill_alpha=0,
        )  # fmt: skip
        self.figure.add_layout(bar, "right")
        self.pane = _pane(self.figure)

    def show(self, view: Overview) -> None:
        """Draw the heights, the middle of the file at 0, 0; 1 % of them beyond the colours."""
        height, width = (length * 1e3 for length in view.extent)
        self.mapper.update(low=view.low * 1e6, high=max(view.high, view.low + 1e-9) * 1e6)
        self.image.data = {
            "height": [(view.heights * 1e6).astype(np.float32)],
            "x": [-width / 2], "y": [-height / 2], "dx": [width], "dy": [height],
        }  # fmt: skip

    def mark(self, road: Road) -> None:
        """The square of the patch."""
        self.patch.data = {
            "x": [road.centre_x * 1e3], "y": [road.centre_y * 1e3], "side": [road.size * 1e3]
        }  # fmt: skip


class LinePreview:
    """Attributes: `figure`, its `pane`; `curve`; the marks `start`, `end` and `patch`."""

    def __init__(self) -> None:
        self.curve = ColumnDataSource({"place": np.empty(0), "height": np.empty(0)})
        self.figure = _figure(
            "Box: what is used; hatched: trimmed off",
            "From the start of the file [mm]",
            "Height [µm]",
        )
        self.figure.y_range = Range1d(0, 1)
        self.figure.line("place", "height", source=self.curve, line_color=_LINE, line_width=1.2)
        off = {"fill_color": GREY, "fill_alpha": 0.25, "hatch_pattern": "/", "hatch_alpha": 0.5,
               "hatch_color": GREY, "line_color": None}  # fmt: skip
        self.start, self.end = BoxAnnotation(**off), BoxAnnotation(**off)
        self.patch = BoxAnnotation(
            fill_color=VERMILION, fill_alpha=0.15, line_color=VERMILION, line_width=2.5
        )
        for box in (self.start, self.end, self.patch):
            self.figure.add_layout(box)
        self._length = 0.0
        self.pane = _pane(self.figure)

    def show(self, view: Overview) -> None:
        """Draw the profile, with gaps where nothing was measured."""
        self._length = view.extent[0] * 1e3
        self.curve.data = {"place": view.place * 1e3, "height": view.heights * 1e6}

    def mark(self, road: Road) -> None:
        """What is trimmed off, and what of the rest the patch takes."""
        first, last = road.trim_start * 1e3, self._length - road.trim_end * 1e3
        self._scale(first, last)
        self.start.update(left=0.0, right=first, visible=first > 0)
        self.end.update(left=last, right=self._length, visible=last < self._length)
        middle, half = (first + last) / 2 + road.centre_x * 1e3, road.size * 5e2
        cut = road.profile_use == "corrugated"
        self.patch.update(
            left=middle - half if cut else first, right=middle + half if cut else last
        )

    def _scale(self, first: float, last: float) -> None:
        """Heights from the lowest to the highest of what is kept: a reference plate is none."""
        place, height = (np.asarray(self.curve.data[name]) for name in ("place", "height"))
        kept = height[(place >= first) & (place <= last) & np.isfinite(height)]
        if kept.size:
            margin = 0.08 * float(np.ptp(kept)) or 1.0
            low, high = float(kept.min()) - margin, float(kept.max()) + margin
            self.figure.y_range.update(start=low, end=high)


def _figure(title: str, x_label: str, y_label: str) -> figure:
    fig = figure(
        title=title, x_axis_label=x_label, y_axis_label=y_label, height=HEIGHT,
        sizing_mode="stretch_width", tools="pan,box_zoom,wheel_zoom,reset,save", active_drag=None,
        active_scroll=None, toolbar_location="above", output_backend="canvas", min_border_left=64,
        min_border_right=16, background_fill_alpha=0, border_fill_alpha=0,
    )  # fmt: skip
    fig.toolbar.logo = None
    fig.toolbar.autohide = True
    fig.axis.axis_label_text_font_style = "normal"
    DESK.apply(fig)
    return fig


def _pane(fig: figure) -> pn.pane.Bokeh:
    return pn.pane.Bokeh(fig, sizing_mode="stretch_width", height=HEIGHT)
