"""The quasi-static run to compare with: made once, kept, and out of the way of the first step."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from app import baseline
from app.runner import Phase, Run
from tyrecontact import Scenario, Simulation


@pytest.fixture(autouse=True)
def _none_kept() -> None:
    baseline._baselines.clear()


def _done(scenario: Scenario, baseline_first: bool = True) -> Run:
    run = Run(scenario, baseline_first=baseline_first)
    run.start()
    assert run.join(60)
    assert run.phase is Phase.FINISHED
    return run


def test_the_baseline_is_the_run_at_rest_and_is_kept(small: Scenario) -> None:
    first, second = (_done(small).baseline for _ in range(2))
    assert first is second
    still = small.copy()
    still.numerics.kernel = "static"
    alone = Simulation(still).run()
    expected = np.interp(first.indentation, alone.indentation, alone.contact_force)
    # interpolation between the steps of the run it is compared with
    np.testing.assert_allclose(first.contact_force, expected, atol=2e-3 * expected.max())


@pytest.mark.parametrize(
    ("change", "kept"),
    [
        (("numerics.kernel", "band-limited"), True),
        (("numerics.time_resolution_factor", 2), False),  # other steps of the road to compare with
        (("road.seed", 2), False),
        (("numerics.statics", "band-limited"), False),  # another tread at rest
    ],
)
def test_the_baseline_is_kept_for_what_does_not_change_it(
    small: Scenario, change: tuple[str, object], kept: bool
) -> None:
    changed = small.copy()
    changed.set(*change)
    assert (_done(small).baseline is _done(changed).baseline) is kept


def test_of_many_only_the_latest_are_kept(small: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(baseline, "_KEPT", 2)
    simulations = []
    for force in (0.1, 0.2, 0.3):
        small.adhesion.release_force = force
        simulations.append(Simulation(small))
        assert baseline.made(simulations[-1], lambda: False) is not None
    assert [baseline.kept(made) is not None for made in simulations] == [False, True, True]


def test_the_baseline_may_come_after_the_last_step(
    small: Scenario, wait_for: Callable[[Callable[[], bool]], None]
) -> None:
    run = Run(small, paused=True, baseline_first=False)
    run.start()
    run.step()
    wait_for(lambda: run.record is not None and run.record.count == 1)
    assert run.baseline is None
    run.resume()
    assert run.join(60)
    assert run.phase is Phase.FINISHED
    before = run.baseline
    baseline._baselines.clear()
    np.testing.assert_array_equal(before.contact_force, _done(small).baseline.contact_force)


def test_a_baseline_that_is_there_is_taken_at_once(
    small: Scenario, wait_for: Callable[[Callable[[], bool]], None]
) -> None:
    there = _done(small).baseline
    run = Run(small, paused=True, baseline_first=False)
    run.start()
    wait_for(lambda: run.phase is Phase.PAUSED)
    assert run.baseline is there
    run.stop()
    assert run.join(60)


def test_a_run_superseded_while_it_compares_is_complete_without(
    small: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    make, phases = baseline.made, []

    def stop_and_make(simulation: Simulation, stopped: Callable[[], bool]) -> object:
        phases.append(run.phase)
        run.stop()
        return make(simulation, stopped)

    monkeypatch.setattr(baseline, "made", stop_and_make)
    run = Run(small, baseline_first=False)
    run.start()
    assert run.join(60)
    assert phases == [Phase.COMPARING]
    assert (run.phase, run.baseline) == (Phase.FINISHED, None)
    assert run.results().stop_reason == "completed"


def test_a_run_that_is_stopped_makes_no_baseline(small: Scenario) -> None:
    run = Run(small, paused=True, baseline_first=False)
    run.start()
    run.step()
    run.stop()
    assert run.join(60)
    assert (run.phase, run.baseline) == (Phase.STOPPED, None)


def test_a_baseline_that_cannot_be_made_leaves_the_run_as_it_is(
    small: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise MemoryError("no more")

    monkeypatch.setattr(baseline, "made", fail)
    run = _done(small, baseline_first=False)
    assert run.message == "no quasi-static run to compare with: no more"
    assert run.results().stop_reason == "completed"
