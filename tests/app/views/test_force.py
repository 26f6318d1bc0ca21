"""The force view without a browser: fed with a run, its sources read."""

from __future__ import annotations

import numpy as np
import pytest

from app.runner import Run
from app.views.force import ForceView
from app.views.style import DESK, HALL, horizontal


def test_force_draws_every_row_once_and_the_baseline(finished: Run) -> None:
    view, record = ForceView(), finished.record
    view.compare_with(finished.baseline)
    for low, high in ((0, 7), (7, 20), (20, record.count)):
        view.update(record, low, high)
    np.testing.assert_array_equal(view.source.data["force"], record.columns["contact_force"])
    np.testing.assert_allclose(view.source.data["time_ms"], record.columns["time"] * 1e3)
    np.testing.assert_array_equal(view.baseline.data["force"], finished.baseline.contact_force)
    assert len(view.failed.data["force"]) == 0
    view.reset()
    assert len(view.source.data["force"]) == 0


def test_the_force_axis_makes_room_for_a_force_that_shoots_up(finished: Run) -> None:
    view, record = ForceView(), finished.record
    view.compare_with(finished.baseline)
    top = view.root.y_range.end
    record.columns["contact_force"][30] = 20 * top
    record.columns["contact_force"][31] = -5 * top
    view.update(record, 0, record.count)
    assert view.root.y_range.end > 20 * top
    assert view.root.y_range.start < -5 * top


def test_steps_that_did_not_converge_are_marked(finished: Run) -> None:
    record = finished.record
    record.columns["converged"][[5, 9]] = 0
    view = ForceView()
    view.update(record, 0, record.count)
    expected = record.columns["indentation"][[5, 9]] * 1e6
    np.testing.assert_allclose(view.failed.data["indentation_um"], expected)
    # the line is faded, and what has converged is drawn over it
    drawn = np.asarray(view._sound.source.data["force"])
    assert list(np.flatnonzero(np.isnan(drawn))) == [5, 9]
    assert view._run.glyph.line_alpha < 0.5
    view.reset()
    assert view._run.glyph.line_alpha == 1.0
    assert len(view._sound.source.data["force"]) == 0


def test_the_axis_changes_with_label_and_range(finished: Run) -> None:
    view, schedule = ForceView(), finished.simulation.schedule
    for name, label in (("time", "Time [ms]"), ("indentation", "Indentation [µm]")):
        axis = horizontal(name, schedule.time, schedule.drive)
        view.show_against(axis)
        assert view.root.xaxis[0].axis_label == label
        assert {glyph.glyph.x for glyph in view._glyphs} == {axis.column}
        assert view.root.x_range.end == pytest.approx(axis.span[1])


def test_the_step_on_show_is_marked_where_it_is_and_not_when_it_is_the_newest() -> None:
    view = ForceView()
    assert not view.cursor.visible
    view.point_at(42.0)
    assert (view.cursor.location, view.cursor.visible) == (42.0, True)
    view.point_at(None)
    assert not view.cursor.visible


def test_a_lecture_hall_gets_larger_type() -> None:
    view = ForceView()
    view.enlarge(HALL)
    assert view.root.title.text_font_size == f"{HALL.title}px"
    assert view.root.xaxis[0].major_label_text_font_size == f"{HALL.tick}px"
    view.enlarge(DESK)
    assert view.root.title.text_font_size == f"{DESK.title}px"


def test_the_scale_of_the_run_before_can_stay(finished: Run) -> None:
    view = ForceView()
    view.compare_with(finished.baseline)
    top = view.root.y_range.end
    view.root.y_range.end = 2 * top
    view.compare_with(finished.baseline, fit=False)
    assert view.root.y_range.end == 2 * top
