"""The iterations view without a browser: iterations, the limit, and the margin beside them."""

from __future__ import annotations

import numpy as np
import pytest

from app.runner import Run
from app.views.iterations import IterationsView
from app.views.style import horizontal


def test_iterations_and_margin_have_a_point_for_each_step(finished: Run) -> None:
    view, record = IterationsView(), finished.record
    view.reset(50)
    for low, high in ((0, 7), (7, record.count)):
        view.update(record, low, high)
    np.testing.assert_array_equal(view.source.data["iterations"], record.columns["iterations"])
    np.testing.assert_array_equal(view.margin.data["margin"], record.columns["stability_margin"])


def test_failed_steps_are_marked_and_the_limit_is_drawn(finished: Run) -> None:
    record = finished.record
    record.columns["converged"][[5, 9]] = 0
    view = IterationsView()
    view.reset(max_iterations=7)
    view.update(record, 0, record.count)
    expected = record.columns["indentation"][[5, 9]] * 1e6
    np.testing.assert_allclose(view.failed.data["indentation_um"], expected)
    assert view.limit.location == 7
    assert view.root.y_range.end > 7
    view.reset(7)
    assert len(view.margin.data["margin"]) == 0


def test_the_margin_has_an_axis_of_its_own_which_stays(finished: Run) -> None:
    view, record = IterationsView(), finished.record
    record.columns["stability_margin"][20] = -80.0
    record.columns["iterations"][20] = 40
    view.reset(50)
    view.update(record, 0, record.count)
    margins = view.root.extra_y_ranges["margin"]
    assert (margins.start, margins.end) == (-1.0, 1.1)
    assert view.root.y_range.end == pytest.approx(44.0)


def test_the_axis_changes_for_all_that_is_drawn(finished: Run) -> None:
    view, schedule = IterationsView(), finished.simulation.schedule
    view.show_against(horizontal("time", schedule.time, schedule.drive))
    assert {glyph.glyph.x for glyph in view._glyphs} == {"time_ms"}
    assert view.root.xaxis[0].axis_label == "Time [ms]"
