"""Views without a browser: built, fed with a run, and their sources read."""

from __future__ import annotations

import numpy as np
import pytest

from app.runner import Run
from app.views.force import ForceView
from app.views.headline import HeadlineView, describe, three_digits
from app.views.iterations import IterationsView
from app.views.style import horizontal


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


def test_steps_that_did_not_converge_are_marked_in_force_and_iterations(finished: Run) -> None:
    record = finished.record
    record.columns["converged"][[5, 9]] = 0
    force, iterations = ForceView(), IterationsView()
    iterations.reset(max_iterations=7)
    force.update(record, 0, record.count)
    iterations.update(record, 0, record.count)
    expected = record.columns["indentation"][[5, 9]] * 1e6
    np.testing.assert_allclose(force.failed.data["indentation_um"], expected)
    np.testing.assert_allclose(iterations.failed.data["indentation_um"], expected)
    assert iterations.limit.location == 7
    assert iterations.root.y_range.end > 7


def test_the_force_axis_makes_room_for_a_force_that_shoots_up(finished: Run) -> None:
    view, record = ForceView(), finished.record
    view.compare_with(finished.baseline)
    top = view.root.y_range.end
    record.columns["contact_force"][30] = 20 * top
    record.columns["contact_force"][31] = -5 * top
    view.update(record, 0, record.count)
    assert view.root.y_range.end > 20 * top
    assert view.root.y_range.start < -5 * top


def test_both_plots_change_axis_with_label_and_range(finished: Run) -> None:
    simulation = finished.simulation
    for view in (ForceView(), IterationsView()):
        for name, label in (("time", "Time [ms]"), ("indentation", "Indentation [µm]")):
            axis = horizontal(name, simulation.schedule.time, simulation.schedule.drive)
            view.show_against(axis)
            assert view.root.xaxis[0].axis_label == label
            assert {glyph.glyph.x for glyph in view._glyphs} == {axis.column}
            assert view.root.x_range.end == pytest.approx(axis.span[1])


def test_the_headline_gives_figures_with_units_and_a_sentence(finished: Run) -> None:
    view = HeadlineView()
    assert "Run" in view.sentence
    view.update(finished)
    results = finished.results()
    assert view.figures["Peak force"] == (three_digits(results.contact_force.max()), "N")
    assert view.figures["Indentation"] == ("100.0", "µm")
    assert view.figures["Final stiffness"][1] == "MN/m"
    assert view.sentence == f"Complete, {len(results)} steps: all converged."
    view.refuse("pitch must be given")
    assert view.notice == "Not accepted: pitch must be given."
    assert view.sentence.startswith("Complete")
    view.update(finished)
    assert "pitch must be given" in view.root.object
    view.accept()
    assert "pitch must be given" not in view.root.object
    assert view.figures["Peak force"][0] != "–"


def test_what_the_headline_says_cannot_carry_markup() -> None:
    view = HeadlineView()
    view.refuse("<script>alert(1)</script>")
    assert "<script>" not in view.root.object


def test_what_is_coming_is_said_before_it_comes(finished: Run) -> None:
    assert "all converged" in describe(finished)[0]
    finished.record.columns["stability_margin"][20] = -0.3
    sentence, bad = describe(finished)
    assert not bad
    place = finished.record.columns["indentation"][20] * 1e6
    assert f"from {place:.1f} µm on the springs are too stiff" in sentence


def test_a_failed_step_is_described_with_place_size_and_advice(finished: Run) -> None:
    finished.record.columns["converged"][10] = 0
    finished.scenario.numerics.kernel = "band-limited"
    sentence, bad = describe(finished)
    assert bad
    assert "1 not converged, the first at step 10 and " in sentence
    assert "residual" in sentence
    assert "passive kernel" in sentence


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (0.0, "0"),
        (203.79, "204"),
        (2234.9, "2230"),
        (0.6042, "0.604"),
        (35.0, "35.0"),
        (2.9, "2.90"),
        (1e-9, "1.00e-09"),
    ],
)
def test_numbers_have_three_significant_digits(value: float, shown: str) -> None:
    assert three_digits(value) == shown
