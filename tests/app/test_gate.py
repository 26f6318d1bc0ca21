"""Pause, step, go on: each run stands where it is told to, and can be ended there."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from app.runner import Phase, Run
from app.slots import Slots
from tyrecontact import Scenario

Waiting = Callable[[Callable[[], bool]], None]


def _paused(small: Scenario, wait_for: Waiting) -> Run:
    run = Run(small, paused=True)
    assert run.paused
    run.start()
    wait_for(lambda: run.phase is Phase.PAUSED)
    return run


def _steps(run: Run) -> int:
    return 0 if run.record is None else run.record.count


def test_a_run_may_begin_with_a_pause_and_be_stepped(small: Scenario, wait_for: Waiting) -> None:
    run = _paused(small, wait_for)
    assert (_steps(run), run.results()) == (0, None)
    run.step()
    wait_for(lambda: _steps(run) == 1)
    assert run.phase is Phase.PAUSED
    run.step()
    run.step()
    wait_for(lambda: _steps(run) == 3)
    run.stop()
    assert run.join(60)
    assert (run.phase, _steps(run)) == (Phase.STOPPED, 3)


def test_a_step_asked_for_before_the_run_is_ready_is_taken(
    small: Scenario, wait_for: Waiting
) -> None:
    run = Run(small, paused=True)
    run.step()
    run.start()
    wait_for(lambda: _steps(run) == 1)
    run.stop()
    assert run.join(60)
    assert _steps(run) == 1


def test_a_run_is_paused_within_a_step_and_goes_on(small: Scenario, wait_for: Waiting) -> None:
    run = Run(small, duration=1000.0)
    run.start()
    wait_for(lambda: _steps(run) == 1)
    run.step()  # it does not pause: nothing to do
    run.pause()
    assert run.paused
    wait_for(lambda: run.phase is Phase.PAUSED)
    assert _steps(run) == 1
    run.resume()
    wait_for(lambda: run.phase is Phase.RUNNING)
    run.duration = 0.0
    assert run.join(60)
    assert (run.phase, run.paused, _steps(run)) == (Phase.FINISHED, False, len(run.simulation))


def test_the_last_step_by_step_is_the_end(small: Scenario, wait_for: Waiting) -> None:
    run = _paused(small, wait_for)
    for _ in range(len(run.simulation)):
        run.step()
    assert run.join(60)
    assert run.phase is Phase.FINISHED


def test_steps_left_over_are_forgotten_when_it_goes_on(small: Scenario, wait_for: Waiting) -> None:
    run = Run(small, duration=1000.0, paused=True)
    run.step()
    run.resume()
    run.pause()
    run.start()
    wait_for(lambda: run.phase is Phase.PAUSED)
    run.stop()
    assert run.join(60)
    assert _steps(run) == 0


@pytest.mark.parametrize("ask", [Run.stop, Run.pause, Run.resume, Run.step])
def test_what_is_asked_of_a_run_that_has_ended_changes_nothing(
    finished: Run, ask: Callable[[Run], None]
) -> None:
    ask(finished)
    assert finished.phase is Phase.FINISHED
    assert not finished.stopping
    assert not finished.paused
    assert finished.results().stop_reason == "completed"


def test_runs_that_call_on_one_another_do_not_block(small: Scenario) -> None:
    """Pauses, steps, stops and successors from two sides at once: all runs end, no slot is lost."""
    slots, before = Slots(2), threading.active_count()
    runs = []

    def visit() -> None:
        run = None
        for number in range(6):
            run = Run(small, after=run, slots=slots, paused=number % 3 == 1, baseline_first=False)
            runs.append(run)
            run.start()
            run.step()
            run.pause()
            run.resume()
        assert run.join(60)

    visitors = [threading.Thread(target=visit) for _ in range(4)]
    for visitor in visitors:
        visitor.start()
    for visitor in visitors:
        visitor.join(60)
    assert all(run.join(60) for run in runs)
    ends = [run.phase for run in runs]
    assert ends.count(Phase.FINISHED) >= 4
    assert set(ends) <= {Phase.FINISHED, Phase.STOPPED}
    assert (slots.held, slots.waiting) == (0, 0)
    assert threading.active_count() == before
