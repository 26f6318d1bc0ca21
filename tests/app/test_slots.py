"""The queue: first come, first served, nothing lost; and runs that wait in it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from app import gate
from app.runner import Phase, Run
from app.slots import SessionCount, Slots, Ticket
from tyrecontact import Scenario

Waiting = Callable[[Callable[[], bool]], None]


def _nothing() -> None:
    pass


def _places(slots: Slots, *tickets: Ticket) -> list[int]:
    return [slots.place(ticket) for ticket in tickets]


def test_slots_are_given_in_the_order_of_coming() -> None:
    slots, woken = Slots(2), []
    a, b, c, d = (slots.enter(lambda name=name: woken.append(name)) for name in "abcd")
    assert _places(slots, a, b, c, d) == [0, 0, 1, 2]
    woken.clear()
    slots.leave(b)
    assert (c.granted, woken, _places(slots, c, d)) == (True, ["c"], [0, 1])
    slots.leave(d)
    slots.leave(a)
    slots.leave(c)
    assert (slots.held, slots.waiting) == (0, 0)


def test_to_leave_twice_gives_one_slot_back() -> None:
    slots = Slots(1)
    a, b, c = (slots.enter(_nothing) for _ in range(3))
    slots.leave(a)
    slots.leave(a)
    assert (b.granted, c.granted, slots.held) == (True, False, 1)


def test_who_holds_a_slot_is_told_that_others_wait() -> None:
    slots, told = Slots(1), []
    slots.enter(lambda: told.append("holder"))
    assert told == []
    slots.enter(_nothing)
    assert told == ["holder"]


def test_a_place_is_handed_on_but_not_a_slot() -> None:
    slots = Slots(1)
    holder, a, b = (slots.enter(_nothing) for _ in range(3))
    instead = slots.enter(_nothing, instead_of=a)
    assert _places(slots, a, instead, b) == [0, 1, 2]
    again = slots.enter(_nothing, instead_of=holder)
    assert _places(slots, instead, b, again) == [1, 2, 3]
    slots.leave(a)  # it is not there any more
    assert slots.waiting == 3


def test_without_a_limit_nobody_waits() -> None:
    slots = Slots()
    assert all(slots.enter(_nothing).granted for _ in range(100))


def test_visitors_are_counted_once_each() -> None:
    sessions = SessionCount(2)
    assert [sessions.enter(who) for who in ("a", "b", "a", "c")] == [True, True, True, False]
    sessions.leave("c")
    assert len(sessions) == 2
    sessions.leave("a")
    sessions.leave("a")
    assert sessions.enter("c")
    assert len(sessions) == 2


def test_without_a_limit_every_visitor_is_let_in() -> None:
    sessions = SessionCount()
    assert all(sessions.enter(who) for who in range(100))


def _holder(small: Scenario, slots: Slots, wait_for: Waiting) -> Run:
    """A run that has the only slot, and pauses."""
    run = Run(small, paused=True, slots=slots)
    run.start()
    wait_for(lambda: run.phase is Phase.PAUSED)
    return run


def test_runs_queue_and_know_their_place(small: Scenario, wait_for: Waiting) -> None:
    slots = Slots(1)
    holder = _holder(small, slots, wait_for)
    first, second = Run(small, slots=slots), Run(small, slots=slots)
    for run in (first, second):
        run.start()
        wait_for(lambda run=run: run.phase is Phase.QUEUED)
    assert (holder.place, first.place, second.place) == (0, 1, 2)
    first.stop()  # out of the queue at once
    assert first.join(60)
    assert (first.phase, second.place) == (Phase.STOPPED, 1)
    holder.stop()
    assert second.join(60)
    assert second.phase is Phase.FINISHED
    assert (slots.held, slots.waiting) == (0, 0)


def test_a_run_takes_the_place_of_the_one_that_it_supersedes(
    small: Scenario, wait_for: Waiting
) -> None:
    slots = Slots(1)
    holder = _holder(small, slots, wait_for)
    first, second = Run(small, slots=slots), Run(small, slots=slots)
    first.start()
    second.start()
    instead = Run(small, after=first, slots=slots)
    instead.start()
    assert (instead.place, second.place) == (1, 2)
    assert first.join(60)
    wait_for(lambda: instead.phase is Phase.QUEUED)
    # who has had its slot queues again
    again = Run(small, after=holder, slots=slots)
    again.start()
    assert all(run.join(60) for run in (holder, instead, second, again))
    assert [run.phase for run in (holder, first)] == 2 * [Phase.STOPPED]
    assert [run.phase for run in (instead, second, again)] == 3 * [Phase.FINISHED]
    assert (slots.held, slots.waiting) == (0, 0)


def test_a_slot_comes_back_from_a_run_that_is_refused_or_breaks_off(
    small: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    slots, bad = Slots(1), small.copy()
    bad.springs.exchange_count = 100  # of 36 springs
    runs = [Run(bad, slots=slots), Run(small, slots=slots)]
    for run in runs:
        run.start()
    assert all(run.join(60) for run in runs)
    assert [run.phase for run in runs] == [Phase.REFUSED, Phase.FINISHED]
    assert (slots.held, slots.waiting) == (0, 0)


def test_a_pause_that_is_too_long_lets_others_go_first(
    small: Scenario, monkeypatch: pytest.MonkeyPatch, wait_for: Waiting
) -> None:
    monkeypatch.setattr(gate, "PATIENCE", 0.0)
    slots = Slots(1)
    patient = _holder(small, slots, wait_for)
    other = Run(small, slots=slots)
    other.start()
    assert other.join(60)
    assert other.phase is Phase.FINISHED
    blocking = _holder(small, slots, wait_for)
    patient.resume()  # it queues again, and gets the slot of one that pauses
    assert patient.join(60)
    assert patient.phase is Phase.FINISHED
    blocking.stop()
    assert blocking.join(60)
    assert (slots.held, slots.waiting) == (0, 0)


def test_a_pause_keeps_its_slot_for_a_while(small: Scenario, wait_for: Waiting) -> None:
    slots = Slots(1)
    holder = _holder(small, slots, wait_for)
    other = Run(small, slots=slots)
    other.start()
    wait_for(lambda: other.phase is Phase.QUEUED)
    holder.resume()
    assert holder.join(60)
    assert other.join(60)
    assert (holder.phase, other.phase) == (Phase.FINISHED, Phase.FINISHED)
