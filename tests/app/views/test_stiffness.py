"""The stiffness tab: its curves, its sentence, and what it says where there is nothing to see."""

from __future__ import annotations

import re

import numpy as np
import pytest

from app.phase import Phase
from app.runner import Run
from app.views.stiffness import StiffnessView
from tests.app.views.conftest import completed
from tyrecontact import Scenario


def curve(view: StiffnessView, plot: str, label: str) -> dict:
    (found,) = [part for part in view.reading.plots[plot] if part.label == label]
    return found.columns()


def test_before_a_run_it_says_what_will_be_there() -> None:
    view = StiffnessView()
    view.show(None)
    assert "Press Run" in view.reading.sentence
    assert not view.reading.plots


def test_a_ramp_has_one_branch_and_its_final_stiffness(finished: Run) -> None:
    view = StiffnessView()
    view.show(finished)
    loading = curve(view, "by depth", "loading")
    assert loading["x"][-1] == pytest.approx(100, rel=0.01)
    results = finished.results()
    assert results is not None
    assert results.final_stiffness is not None
    late = loading["x"] >= 92
    assert loading["y"][late].mean() == pytest.approx(results.final_stiffness / 1e6, rel=0.05)
    assert not [part for part in view.reading.plots["by depth"] if part.label == "unloading"]
    assert not view.reading.bad
    assert "stiffens" in view.reading.sentence
    assert view.reading.figures["Final stiffness"].endswith("MN/m")


def test_the_difference_is_to_the_quasi_static_run(finished: Run) -> None:
    view = StiffnessView()
    view.show(finished)
    newtons, still = curve(view, "newtons", "loading"), finished.baseline
    assert still is not None
    results = finished.results()
    assert results is not None
    due = np.interp(newtons["x"] * 1e-6, still.indentation, still.contact_force)
    got = np.interp(newtons["x"] * 1e-6, results.indentation, results.contact_force)
    np.testing.assert_allclose(newtons["y"], got - due, atol=1e-9)
    percent = curve(view, "percent", "loading")
    known = np.isfinite(percent["y"])
    assert known.any()
    assert not known.all()  # shares of next to nothing
    np.testing.assert_allclose(percent["y"][known], 100 * (got[known] / due[known] - 1), rtol=1e-6)


def test_unloading_is_told_from_loading(pulled: Run) -> None:
    view = StiffnessView()
    view.show(pulled)
    assert curve(view, "by depth", "unloading")["y"].min() < 0
    assert "where bonds break" in view.reading.sentence
    assert curve(view, "by force", "unloading")["x"].min() < 0


def test_a_quasi_static_run_differs_from_itself_by_nothing(small: Scenario) -> None:
    small.numerics.kernel = "static"
    run = Run(small)
    run.start()
    assert run.join(60)
    view = StiffnessView()
    view.show(run)
    assert "is that of the quasi-static run" in view.reading.sentence


def test_a_run_that_fails_is_shown_as_far_as_it_went_well(wild: Run) -> None:
    results = wild.results()
    assert results is not None
    assert results.failed_at is not None
    view = StiffnessView()
    view.show(wild)
    assert view.reading.bad
    failed = results.indentation[results.failed_at] * 1e6
    named = re.search(r"From ([\d.]+) µm on steps did not converge", view.reading.sentence)
    assert named
    assert float(named[1]) == pytest.approx(failed, rel=0.01)
    assert curve(view, "by depth", "loading")["x"].max() < failed
    assert "Final stiffness" not in view.reading.figures


@pytest.mark.parametrize("phase", [Phase.RUNNING, Phase.COMPARING, Phase.STOPPED, Phase.FINISHED])
def test_a_run_without_a_quasi_static_one_shows_its_own_stiffness(
    finished: Run, phase: Phase
) -> None:
    view = StiffnessView()
    view.show(finished)
    own, compared = curve(view, "by depth", "loading"), view.reading.sentence
    assert {part.label for part in view.reading.plots["by depth"]} == {"quasi-static", "loading"}
    assert "quasi-static run to compare with" not in compared
    finished._computation.baseline, finished.phase = None, phase
    view = StiffnessView()
    view.show(finished)
    assert list(view.reading.plots) == ["by depth", "by force"]
    assert [part.label for part in view.reading.plots["by depth"]] == ["loading"]
    np.testing.assert_array_equal(curve(view, "by depth", "loading")["y"], own["y"])
    comes = "comes after the last step." if not phase.ended else "There is no quasi-static run"
    assert comes in view.reading.sentence
    assert "of the quasi-static run" not in view.reading.sentence


def test_a_run_that_fails_without_a_quasi_static_one_ends_where_it_fails(wild: Run) -> None:
    wild._computation.baseline = None
    view = StiffnessView()
    view.show(wild)
    assert view.reading.bad
    assert "on steps did not converge" in view.reading.sentence
    assert "There is no quasi-static run" in view.reading.sentence
    assert "as high as" not in view.reading.sentence


def test_a_run_that_the_solver_ended_is_no_good_news(finished: Run) -> None:
    finished.record.stop_reason = "unstable at step 51: the tread has given back more energy"
    view = StiffnessView()
    view.show(finished)
    assert view.reading.bad
    assert re.search(r"At [\d.]+ µm the run had to be ended", view.reading.sentence)
    assert "did not converge" not in view.reading.sentence
    assert "Final stiffness" not in view.reading.figures


def test_it_swings_while_unloading_only_where_the_stiffness_says_so(small: Scenario) -> None:
    small.loading.param.update(
        profile="load-hold-unload", max_indentation=60e-6, hold_time=1e-3, unloading_rate=0.05,
        retraction=0.2e-3,
    )  # fmt: skip
    small.adhesion.release_force = 0.02
    run = completed(small)
    first = int(np.flatnonzero(run.record.columns["releases"])[0])
    whole, told = run.record._now, set()
    for count in (first + 1, whole.count):
        run.record._now = type(whole)(count, whole.table, whole.last)
        view = StiffnessView()
        view.show(run)
        falls = bool(curve(view, "by depth", "unloading")["y"].min() < 0)
        assert ("falls below 0" in view.reading.sentence) == falls
        told.add(falls)
    assert told == {True, False}
