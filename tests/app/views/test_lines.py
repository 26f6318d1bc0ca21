"""Lines at rest: their window, and what the pointer is told."""

from __future__ import annotations

import holoviews as hv
import numpy as np

from app.views.lines import Line, lines, tips, window


def test_a_run_that_goes_well_is_shown_in_full() -> None:
    usual = np.array([0.0, 2.0])
    assert window([np.array([-1.0, 3.5, np.nan])], [usual]) is None
    assert window([np.array([5.0])], [np.zeros(0)]) is None


def test_one_that_goes_wild_in_what_is_usual() -> None:
    assert window([np.array([0.0, 50.0])], [np.array([0.0, 2.0])]) == (-0.5, 2.5)
    assert window([np.array([-50.0])], [np.array([1.0, 2.0])]) == (-0.5, 2.5)


def test_the_pointer_is_told_units() -> None:
    assert tips("loading", "Time [ms]", "Force [N]") == [
        ("", "loading"), ("force", "@y{0.[000]} N"), ("time", "@x{0.[000]} ms"),
    ]  # fmt: skip
    assert tips("", "Elements", "Force [N]")[1] == ("elements", "@x{0.[000]}")


def test_long_lines_are_thinned() -> None:
    x = np.arange(50_000.0)
    (curve,) = lines("Title", "x [m]", "y [N]", [Line("a", x, np.sin(x), "#000000")])
    assert len(curve) < 2000
    assert curve.columns()["x"][-1] == x[-1]


def test_braces_in_a_title_are_shown_as_they_are() -> None:
    line = Line("run", np.array([0.0, 1.0]), np.array([0.0, 1.0]), "#000000")
    plot = hv.render(lines("Force less that of “{a} {0}”", "x [m]", "y [N]", [line]))
    assert plot.title.text == "Force less that of “{a} {0}”"
