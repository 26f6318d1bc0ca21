"""A run on a thread: it ends once, stops within a step, and keeps what it has."""

from __future__ import annotations

import gc
import threading
import time
import weakref
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from app import gate
from app.limits import Limits
from app.runner import Phase, Run
from tyrecontact import Scenario, Simulation
from tyrecontact.errors import InputError
from tyrecontact.results import Record, Step

Waiting = Callable[[Callable[[], bool]], None]


def test_a_run_gives_the_same_as_the_library(finished: Run, small: Scenario) -> None:
    assert finished.phase is Phase.FINISHED
    alone = Simulation(small).run()
    streamed = finished.results()
    assert streamed is not None
    np.testing.assert_array_equal(streamed.contact_force, alone.contact_force)
    assert streamed.stop_reason == "completed"


def test_a_stopped_run_keeps_its_steps_and_takes_no_more_than_one_after(
    small: Scenario, wait_for: Waiting
) -> None:
    run = Run(small, duration=30.0)
    run.start()
    wait_for(lambda: run.record is not None and run.record.count >= 3)
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


def test_a_duration_spreads_the_steps_evenly(small: Scenario, wait_for: Waiting) -> None:
    run = Run(small, duration=1.5)
    run.start()
    wait_for(lambda: run.phase is Phase.RUNNING)
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


def test_a_run_waits_for_the_one_that_it_supersedes(small: Scenario, wait_for: Waiting) -> None:
    first = Run(small, duration=30.0)
    first.start()
    wait_for(lambda: first.phase is Phase.RUNNING)
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


def test_a_run_that_supersedes_uses_what_the_one_before_has_made(small: Scenario) -> None:
    first = Run(small)
    first.start()
    changed = small.copy()
    changed.adhesion.release_force = 1.0
    between = Run(changed, after=first)  # stopped before, or while, it prepares
    last = Run(changed, after=between)
    first.join(60)
    between.start()
    last.start()
    assert last.join(60)
    assert last.phase is Phase.FINISHED
    assert last.simulation.patch is first.simulation.patch
    assert last.simulation.springs is first.simulation.springs
    np.testing.assert_array_equal(
        last.results().contact_force, Simulation(changed).run().contact_force
    )


def test_a_run_waits_for_whom_its_predecessor_had_to_wait_for(
    small: Scenario, monkeypatch: pytest.MonkeyPatch, wait_for: Waiting
) -> None:
    """A run that is stopped while it waits ends at once, though the one before it is not done."""
    append, go_on = Record.append, threading.Event()

    def held_up(record: Record, step: Step) -> None:
        append(record, step)
        if record is first.record:
            go_on.wait(60)

    first = Run(small, duration=30.0)
    monkeypatch.setattr(Record, "append", held_up)
    first.start()
    wait_for(lambda: first.record is not None and first.record.count == 1)
    between = Run(small, after=first)
    between.start()
    last = Run(small, after=between)
    last.start()
    assert between.join(60)
    assert (between.phase, first.phase) == (Phase.STOPPED, Phase.RUNNING)
    assert last.phase is Phase.WAITING
    go_on.set()
    assert last.join(60)
    assert (first.phase, last.phase) == (Phase.STOPPED, Phase.FINISHED)
    assert first.record.count == 1


def test_a_run_out_of_time_keeps_its_steps_and_is_no_failure(
    small: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    append, clock = Record.append, SimpleNamespace(now=0.0)

    def take_long(record: Record, step: Step) -> None:
        append(record, step)
        clock.now += 100.0

    monkeypatch.setattr(gate, "time", SimpleNamespace(monotonic=lambda: clock.now))
    run = Run(small, baseline_first=False, limits=Limits(seconds=250.0))
    monkeypatch.setattr(Record, "append", take_long)
    run.start()
    assert run.join(60)
    results = run.results()
    assert (run.phase, len(results)) == (Phase.STOPPED, 3)
    assert run.message == "stopped after 250 s, the longest that this server computes"
    assert results.stop_reason == run.message
    assert results.failed_at is None


def test_a_pause_is_not_counted_as_time(
    small: Scenario, monkeypatch: pytest.MonkeyPatch, wait_for: Waiting
) -> None:
    clock = SimpleNamespace(now=0.0)
    monkeypatch.setattr(gate, "time", SimpleNamespace(monotonic=lambda: clock.now))
    run = Run(small, paused=True, limits=Limits(seconds=250.0))
    run.start()
    wait_for(lambda: run.phase is Phase.PAUSED)
    clock.now += 1e6
    run.resume()
    assert run.join(60)
    assert run.phase is Phase.FINISHED


def test_what_is_beyond_the_limits_is_refused(small: Scenario) -> None:
    run = Run(small, limits=Limits(steps=20))
    run.start()
    assert run.join(60)
    assert run.phase is Phase.REFUSED
    assert run.message.startswith("a run must take at most 20 steps on this server, got 52")


def test_progress_and_time_left(small: Scenario, wait_for: Waiting) -> None:
    run = Run(small, duration=1000.0)
    assert (run.progress, run.time_left) == (0.0, None)
    run.start()
    wait_for(lambda: run.record is not None and run.record.count == 1)
    total = len(run.simulation)
    assert run.progress == 1 / total
    assert run.time_left is None  # after one step nobody knows
    run.duration = 30.0
    wait_for(lambda: run.time_left is not None)
    assert 0 < run.time_left < 60
    run.pause()
    wait_for(lambda: run.phase is Phase.PAUSED)
    assert run.time_left is None
    run.duration = 0.0
    run.resume()
    assert run.join(60)
    assert (run.progress, run.time_left) == (1.0, None)


def test_what_is_taken_of_a_run_under_way_says_how_far_it_is(
    small: Scenario, wait_for: Waiting
) -> None:
    run = Run(small, paused=True)
    run.start()
    run.step()
    wait_for(lambda: run.record is not None and run.record.count == 1)
    results = run.results()
    assert results.stop_reason == f"stopped for now, 1 of {len(run.simulation)} steps"
    assert results.failed_at is None
    run.resume()
    assert run.join(60)
    assert run.results().stop_reason == "completed"


@pytest.mark.parametrize("duration", [-1.0, float("nan"), float("inf")])
def test_a_duration_is_a_time(small: Scenario, finished: Run, duration: float) -> None:
    with pytest.raises(InputError, match=r"duration of a run must be 0 or more, got .* s"):
        Run(small, duration)
    with pytest.raises(InputError):
        finished.duration = duration


def test_a_run_starts_once(finished: Run) -> None:
    with pytest.raises(RuntimeError, match="starts only once"):
        finished.start()
    assert finished.phase is Phase.FINISHED


def test_a_run_that_is_kept_keeps_no_other_alive(finished: Run, small: Scenario) -> None:
    later = Run(small, after=finished)
    later.start()
    assert later.join(60)
    gone = weakref.ref(later)
    del later
    gc.collect()
    assert gone() is None
