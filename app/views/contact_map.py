"""Where road and tread touch now: force on each element, bonds in tension marked apart."""

from __future__ import annotations

import numpy as np
from bokeh.models import ColorBar, ColumnDataSource, LinearColorMapper
from bokeh.palettes import Cividis256
from bokeh.plotting import figure

from tyrecontact.contact.bonds import ElementState
from tyrecontact.results import Record

from .style import ORANGE, VERMILION, hover

#: no force: grey on white and on black, unlike the darkest blue
_APART = "#9AA0A859"


class ContactMapView:
    """Attributes: `root` a Bokeh figure; `image`, `tension` what it draws; `mapper` its scale."""

    def __init__(self) -> None:
        self.image = ColumnDataSource({"force": [], "side": []}, name="map")
        self.tension = ColumnDataSource({"x": [], "y": [], "force": []}, name="tension")
        self.mapper = LinearColorMapper(
            Cividis256, low=0, high=1, nan_color=_APART, high_color=VERMILION
        )
        self.root = figure(
            title="Contact map  (▼ bonded, in tension)",
            x_axis_label="x [mm]", y_axis_label="y [mm]",
            aspect_ratio=0.84, sizing_mode="scale_width", x_range=(0, 20), y_range=(0, 20),
            tools="save", toolbar_location="above", output_backend="canvas", min_border_right=16,
        )  # fmt: skip
        self._style()
        self._cells = self.root.image(
            "force", source=self.image, x=0, y=0, dw="side", dh="side", color_mapper=self.mapper
        )
        self._marks = self.root.scatter(
            "x", "y", source=self.tension, marker="inverted_triangle", size=9,
            fill_color=ORANGE, line_color=VERMILION,
        )  # fmt: skip
        tips = [("tension", "@force{0.000} N")]
        hover(self.root, self._marks, tips, "mouse")
        hover(self.root, self._cells, [("force", "@force{0.000} N")], "mouse")
        bar = ColorBar(color_mapper=self.mapper,
                       title="Force on an element [N]; red: beyond the scale", width="auto",
                       height=12, title_text_font_style="normal",
                       background_fill_alpha=0)  # fmt: skip
        self.root.add_layout(bar, "below")

    def _style(self) -> None:
        self.root.toolbar.logo = None
        self.root.toolbar.autohide = True
        self.root.grid.visible = False
        self.root.title.text_font_size = "14px"
        self.root.xaxis.axis_label_text_font_style = "normal"
        self.root.yaxis.axis_label_text_font_style = "normal"

    def clear(self) -> None:
        """An empty map."""
        self.image.data = {"force": [], "side": []}
        self.tension.data = {"x": [], "y": [], "force": []}

    def reset(self, side: float, elements: int, peak_force: float) -> None:
        """An empty map of a patch of a side [m], with colours to a little above a force [N]."""
        self.clear()
        self.root.x_range.end = self.root.y_range.end = side * 1e3
        self.mapper.high = 1.2 * peak_force or 1.0
        self._marks.glyph.size = max(3.0, 180 / elements)

    def show(self, record: Record, step: int, spacing: float) -> None:
        """Show a step of the record, or the nearest whose fields are kept; elements of side
        `spacing` [m].
        """
        _, fields = record.fields(step)
        force, state = fields["element_force"], fields["state"]
        pressed = np.where(state == ElementState.COMPRESSED, force, np.nan)
        self.image.data = {"force": [pressed], "side": [len(force) * spacing * 1e3]}
        row_index, column_index = np.nonzero(state == ElementState.TENSION)
        self.tension.data = {
            "x": (column_index + 0.5) * spacing * 1e3,
            "y": (row_index + 0.5) * spacing * 1e3,
            "force": -force[row_index, column_index],
        }
