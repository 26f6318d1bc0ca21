"""A run on a thread: it ends once, stops within a step, and keeps what it has."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest

from app import baseline
from app.runner import Phase, Run
from tyrecontact import Scenario, Simulation
from tyrecontact.results import Record, Step


def _wait_for(condition, seconds: float = 60.0) -> None:
    limit = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < limit, "waited too long"
        time.sleep(0.002)


def test_a_run_gives_the_same_as_the_library(finished: Run, small: Scenario) -> None:
    assert finished.phase is Phase.FINISHED
    alone = Simulation(small).run()
    streamed = finished.results()
    assert streamed is not None
    np.testing.assert_array_equal(streamed.contact_force, alone.contact_force)
    assert streamed.stop_reason == "completed"


def test_a_stopped_run_keeps_its_steps_and_takes_no_more_than_one_after(small: Scenario) -> None:
    run = Run(small, duration=30.0)
    run.start()
    _wait_for(lambda: run.record is not None and run.record.count >= 3)
    run.stop()
    at_stop = run.record.count
    assert run.join(5)
    assert run.phase is Phase.STOPPED
    assert at_stop <= run.record.count <= at_stop + 1
    results = run.results()
    assert results is not None
    assert len(results) == run.record.count
    assert results.stop_reason == "stopped by the user"


def test_a_run_that_has_finished_is_not_called_stopped_afterwards(finished: Run) -> None:
    finished.stop()
    assert finished.phase is Phase.FINISHED
    assert finished.results().stop_reason == "completed"


def test_a_run_stopped_before_it_starts_computes_nothing(small: Scenario) -> None:
    run = Run(small)
    run.stop()
    run.start()
    assert run.join(60)
    assert run.phase is Phase.STOPPED
    assert run.results() is None


def test_a_duration_spreads_the_steps_evenly(small: Scenario) -> None:
    run = Run(small, duration=1.5)
    run.start()
    _wait_for(lambda: run.phase is Phase.RUNNING)
    began = time.monotonic()
    assert run.join(60)
    # never faster than asked for; how much slower is the machine's business
    assert time.monotonic() - began > 1.3


def test_what_cannot_be_run_is_refused_in_one_sentence(small: Scenario) -> None:
    small.road.file = "/no/such/road.npy"
    small.road.pitch, small.road.height_unit = 1e-5, "mm"
    run = Run(small)
    run.start()
    assert run.join(60)
    assert run.phase is Phase.REFUSED
    assert "road.npy" in run.message
    assert "\n" not in run.message


def test_later_changes_of_the_scenario_do_not_reach_the_run(small: Scenario) -> None:
    run = Run(small)
    small.loading.max_indentation = 20e-6
    run.start()
    assert run.join(60)
    assert run.results().indentation[-1] == pytest.approx(100e-6)


def test_the_baseline_is_the_run_at_rest_and_is_kept(small: Scenario) -> None:
    baseline._baselines.clear()
    runs = [Run(small), Run(small)]
    for run in runs:
        run.start()
        assert run.join(60)
    first, second = (run.baseline for run in runs)
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
    ],
)
def test_the_baseline_is_kept_for_what_does_not_change_it(
    small: Scenario, change: tuple[str, object], kept: bool
) -> None:
    made = []
    for scenario in (small, small.copy()):
        if made:
            scenario.set(*change)
        run = Run(scenario)
        run.start()
        assert run.join(60)
        made.append(run.baseline)
    assert (made[0] is made[1]) is kept


def test_a_run_that_breaks_off_keeps_its_steps_and_says_so(
    small: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    append = Record.append

    def break_at_ten(record: Record, step: Step) -> None:
        if record.count == 10 and len(record.columns["time"]) == len(Simulation(small)):
            raise MemoryError("no more")
        append(record, step)

    small.loading.rate = 0.02  # more steps than the baseline has
    monkeypatch.setattr(Record, "append", break_at_ten)
    run = Run(small)
    run.start()
    assert run.join(60)
    assert run.phase is Phase.FAILED
    assert len(run.results()) == 10
    assert run.results().stop_reason == "no more"


def test_a_run_waits_for_the_one_that_it_supersedes(small: Scenario) -> None:
    first = Run(small, duration=30.0)
    first.start()
    _wait_for(lambda: first.phase is Phase.RUNNING)
    second = Run(small, after=first)
    second.start()
    assert second.join(30)
    assert first.phase is Phase.STOPPED
    assert second.phase is Phase.FINISHED


def test_no_thread_is_left_behind(small: Scenario) -> None:
    before = threading.active_count()
    for _ in range(3):
        run = Run(small, duration=20.0)
        run.start()
        run.stop()
        assert run.join(60)
    assert threading.active_count() == before
