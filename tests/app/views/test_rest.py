"""Plots of HoloViews in the house style, and drawn again in place."""

from __future__ import annotations

import numpy as np
from bokeh.models import GlyphRenderer
from bokeh.plotting import figure

from app.views.lines import Line, lines
from app.views.rest import Redrawn
from app.views.style import HALL


def element(top: float, labels: str = "ab") -> object:
    x = np.linspace(0, 1, 5)
    parts = [Line(label, x, top * x, "#000000") for label in labels]
    return lines("Title", "x [m]", "y [N]", parts)


def test_other_data_change_the_lines_and_the_ranges_and_nothing_else() -> None:
    shown = Redrawn(element(1.0), HALL)
    model = shown.root.get_root()
    (fig,) = model.select({"type": figure})
    drawn = [part for part in fig.renderers if isinstance(part, GlyphRenderer)]
    width = drawn[0].glyph.line_width
    assert width == 2.0 * HALL.line
    for top in (10.0, 100.0):
        shown.send(element(top))
        assert fig.y_range.end >= top
        assert max(drawn[0].data_source.data["y"]) == top
        assert drawn[0].glyph.line_width == width
    assert fig.toolbar.logo is None
    # a wheel or a finger over a plot scrolls the page
    assert (fig.toolbar.active_drag, fig.toolbar.active_scroll) == (None, None)


def test_only_the_same_layers_are_taken() -> None:
    shown = Redrawn(element(1.0))
    assert shown.takes(element(7.0))
    assert not shown.takes(element(1.0, "abc"))
