"""What all plots share: colours that survive colour-blindness, and quiet figures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from bokeh.models import CustomJS, HoverTool, Range1d, Span
from bokeh.plotting import figure

#: Okabe and Ito's palette
BLUE, VERMILION, ORANGE = "#0072B2", "#D55E00", "#E69F00"
GREY = "#8A8F98"
#: of the stability margin: Okabe and Ito's purple
MARGIN_COLOR = "#CC79A7"
#: line of a run: readable on white and on black
RUN_COLOR = {False: BLUE, True: "#56B4E9"}

#: level of what changes with every frame: on a canvas of its own, without the axes
LIVE = "overlay"


@dataclass(frozen=True)
class Size:
    """Type and lines of a figure [px]: one scale for a desk, one for a lecture hall.

    Attributes
    ----------
    left : room for an axis up to thousands, so that plots above each other stay in line.
    """

    title: int
    label: int
    tick: int
    line: float = 1.0
    left: int = 72

    def apply(self, fig: figure) -> None:
        """Set the type of a figure, and of its legends."""
        keep(fig.title, text_font_size=f"{self.title}px")
        for axis in fig.axis:
            keep(
                axis,
                axis_label_text_font_size=f"{self.label}px",
                major_label_text_font_size=f"{self.tick}px",
            )
        for legend in fig.legend:
            # as wide as shows a dash
            keep(legend, label_text_font_size=f"{self.label}px", glyph_width=2 * self.label)


#: the page's theme sets not only colours but sizes, in the browser: they are set back
_SET_BACK = "cb_obj.setv(cb_obj.tags[0])"


def keep(model: Any, **values: Any) -> None:
    """Set properties of a model of Bokeh so that they stay, whatever the page's theme says."""
    model.update(tags=[values], **values)
    for name in values:
        # once, however often it is set
        if not model.js_property_callbacks.get(f"change:{name}"):
            model.js_on_change(name, CustomJS(code=_SET_BACK))


DESK, HALL = Size(14, 13, 12), Size(20, 19, 17, 1.8, 96)


#: time [s] and indentation [m] of plots before the first run
EMPTY = np.array([0.0, 1e-2]), np.array([0.0, 2e-4])


@dataclass(frozen=True)
class Horizontal:
    """A choice of horizontal axis: the column, its label, and its range for a run."""

    column: str
    label: str
    span: tuple[float, float]


def horizontal(name: str, time: np.ndarray, indentation: np.ndarray) -> Horizontal:
    """The axis "indentation" or "time" for a run whose steps are at time [s], indentation [m]."""
    if name == "time":
        return Horizontal("time_ms", "Time [ms]", (0.0, float(time[-1]) * 1e3))
    span = float(indentation.min()) * 1e6, float(indentation.max()) * 1e6
    return Horizontal("indentation_um", "Indentation [µm]", span)


def put_on(fig: figure, renderers: list[Any], axis: Horizontal) -> None:
    """Draw renderers against a horizontal axis."""
    for renderer in renderers:
        if renderer.glyph.x != axis.column:
            renderer.glyph.x = axis.column
    fig.xaxis.axis_label = axis.label
    fig.x_range.update(start=axis.span[0], end=axis.span[1])


def plot(title: str, y_label: str, height: int | None, top: float) -> figure:
    """A figure in the house style, its vertical axis from 0 to `top`; without a height [px] it is
    as high as its place.
    """
    fig = figure(
        title=title,
        x_axis_label="Indentation [µm]",
        y_axis_label=y_label,
        x_range=Range1d(0, 200),
        y_range=Range1d(0, top),
        height=height,
        sizing_mode="stretch_both" if height is None else "stretch_width",
        tools="pan,box_zoom,wheel_zoom,reset,save",
        active_drag=None,
        active_scroll=None,
        toolbar_location="above",
        output_backend="canvas",
        min_border_left=DESK.left,
        min_border_right=16,
    )
    fig.toolbar.logo = None
    fig.toolbar.autohide = True
    fig.xaxis.axis_label_text_font_style = "normal"
    fig.yaxis.axis_label_text_font_style = "normal"
    DESK.apply(fig)
    return fig


def cursor(fig: figure) -> Span:
    """A vertical line at the step on show, for plots that are scrubbed; hidden at first."""
    line = Span(
        dimension="height",
        line_color=GREY,
        line_dash="dotted",
        line_width=2,
        visible=False,
        level=LIVE,
    )
    fig.add_layout(line)
    return line


def hover(fig: figure, renderer: Any, tooltips: list[tuple[str, str]], mode: str) -> None:
    """Show values at the pointer, for one renderer alone."""
    fig.add_tools(HoverTool(renderers=[renderer], tooltips=tooltips, mode=mode))
