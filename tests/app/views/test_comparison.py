"""Curves of several runs: what is thinned away, and how they are told apart."""

from __future__ import annotations

import numpy as np
import pytest

from app.figure_panels import PANELS, kernel_panels, spring_panels
from app.views.comparison import BEHIND, Curve, Panel, Style, draw, styles, thinned
from tyrecontact import figures
from tyrecontact.thesis import curves


def test_thinning_keeps_the_ends_and_the_extremes() -> None:
    x = np.arange(100_000.0)
    y = np.sin(x / 3000)
    y[[31_234, 77_777]] = 5, -7
    few_x, few_y = thinned(x, y, 500)
    assert few_x.size <= 502
    assert (few_y.max(), few_y.min()) == (5, -7)
    assert (few_x[0], few_x[-1]) == (x[0], x[-1])
    assert np.all(np.diff(few_x) > 0)
    np.testing.assert_array_equal(thinned(x[:500], y[:500], 500)[0], x[:500])


def test_what_others_are_compared_with_lies_behind_them() -> None:
    found = styles(["quasi-static", "a", "b"], behind="quasi-static")
    assert found["quasi-static"] is BEHIND
    assert len({BEHIND.color, found["a"].color, found["b"].color}) == 3
    assert BEHIND not in styles(["factor 1", "factor 2"]).values()
    assert len(styles([str(number) for number in range(9)])) == 9


def test_a_panel_is_drawn_in_its_ranges() -> None:
    curve = Curve("a", np.array([0.0, 1, 2]), np.array([0.0, np.nan, 4]), Style("#000000"))
    fig = draw(Panel("Title", "x [m]", "y [N]", [curve]))
    assert (fig.x_range.start, fig.x_range.end) == (0, 2)
    assert (fig.y_range.start, fig.y_range.end) == pytest.approx((-0.2, 4.2))
    assert fig.xaxis.axis_label == "x [m]"
    assert not fig.legend
    empty = draw(Panel("Title", "x [m]", "y [N]", []))
    assert empty.y_range.start < empty.y_range.end


def test_every_figure_is_drawn() -> None:
    drawn = {*PANELS, *curves.CURVES}
    assert drawn == set(figures.FIGURES)
    assert [panel.title for panel in kernel_panels(curves.kernels())] == [
        "Kernel, loaded element",
        "Kernel, neighbour",
    ]
    assert len(spring_panels(curves.springs())) == 2
