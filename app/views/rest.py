"""What is looked at at rest is drawn by HoloViews, in the house style."""

from __future__ import annotations

from typing import Any

import holoviews as hv
import holoviews.plotting.bokeh  # registers the backend
import panel as pn
from bokeh.models import Line, Step
from holoviews.streams import Pipe

from .style import DESK, Size

hv.Store.set_current_backend("bokeh")

#: of a plot with a title [px]
HEIGHT = 320


def pane(element: Any, size: Size = DESK, height: int = HEIGHT) -> pn.pane.HoloViews:
    """A plot as wide as there is room.

    Parameters
    ----------
    element : of HoloViews, with its labels ("Force [N]") and, in an overlay, its legend.
    size : of type and lines.
    height : of the plot [px].
    """
    drawn = element.opts(
        responsive=True, height=height, toolbar="above", hooks=[_house(size)], backend="bokeh"
    )
    return pn.pane.HoloViews(
        drawn, sizing_mode="stretch_width", height=height, margin=(4, 6), linked_axes=False
    )


class Redrawn:
    """A plot whose data change in place, at a quarter of the cost of a new one.

    Attributes
    ----------
    root : the pane.
    """

    def __init__(self, element: Any, size: Size = DESK, height: int = HEIGHT) -> None:
        self._layers = _layers(element)
        self._pipe = Pipe(data=element)
        self.root = pane(hv.DynamicMap(lambda data: data, streams=[self._pipe]), size, height)

    def takes(self, element: Any) -> bool:
        """Whether an element has the same layers as the one shown."""
        return _layers(element) == self._layers

    def send(self, element: Any) -> None:
        """Show an element with the same layers, other data and other ranges."""
        self._pipe.send(element)


def _layers(element: Any) -> list[tuple[type, str]]:
    parts = element if isinstance(element, hv.Overlay) else [element]
    return [(type(part), part.label) for part in parts]


def _house(size: Size) -> Any:
    def finish(plot: Any, _element: Any) -> None:
        fig = plot.state
        fig.toolbar.logo, fig.toolbar.autohide = None, True
        # a wheel or a finger over a plot scrolls the page, until a tool is chosen
        fig.toolbar.update(active_drag=None, active_scroll=None)
        fig.update(min_border_left=64, min_border_right=16, output_backend="canvas")
        fig.axis.axis_label_text_font_style = "normal"
        for legend in fig.legend:
            legend.update(border_line_alpha=0, background_fill_alpha=0, padding=4, margin=0)
        size.apply(fig)
        for drawn in fig.renderers:
            glyph = drawn.glyph
            # as wide as the element says, whenever it is drawn: HoloViews sets that first
            if isinstance(glyph, Line | Step):
                glyph.line_width = glyph.line_width * size.line

    return finish
