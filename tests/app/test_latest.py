"""Of several questions only the last is answered, and a thread ends with them."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from app.latest import Latest
from app.slots import Slots
from tyrecontact.errors import InputError


class Slow:
    """A job that has begun, and goes on when it may."""

    def __init__(self) -> None:
        self.begun, self.go = threading.Event(), threading.Event()
        self.told: list[bool] = []

    def __call__(self, wanted: Callable[[], bool]) -> str:
        self.begun.set()
        assert self.go.wait(10)
        self.told.append(wanted())
        return "done"


def test_the_answer_is_there_when_it_is_taken() -> None:
    woken = threading.Event()
    latest = Latest(woken.set)
    assert latest.take() is None
    latest.ask(lambda _: 7)
    assert latest.join(10)
    assert woken.is_set()
    assert latest.take() == (7, "")
    assert latest.take() is None


def test_a_later_question_takes_the_place_of_those_before() -> None:
    slow, answered = Slow(), []
    latest = Latest(lambda: answered.append(1))
    latest.ask(slow)
    assert slow.begun.wait(10)
    latest.ask(lambda _: "second")
    latest.ask(lambda _: "third")
    slow.go.set()
    assert latest.join(10)
    assert latest.take() == ("third", "")
    assert len(answered) == 1


def test_a_refusal_is_one_sentence() -> None:
    latest = Latest(lambda: None)

    def refused(_: Callable[[], bool]) -> None:
        raise InputError("pitch must be positive, got 0 m")

    def broken(_: Callable[[], bool]) -> None:
        raise RuntimeError("lost")

    latest.ask(refused)
    latest.join(10)
    assert latest.take() == (None, "pitch must be positive, got 0 m")
    latest.ask(broken)
    latest.join(10)
    answer = latest.take()
    assert answer is not None
    assert "RuntimeError('lost')" in answer[1]


def test_after_the_close_nobody_is_woken_and_nothing_begins() -> None:
    slow, woken = Slow(), []
    latest = Latest(lambda: woken.append(1))
    latest.ask(slow)
    assert slow.begun.wait(10)
    latest.close()
    slow.go.set()
    assert latest.join(10)
    latest.ask(slow)
    assert latest.join(10)
    assert (woken, slow.told, latest.take()) == ([], [False], None)


def test_what_was_dropped_is_not_answered_even_if_the_answer_is_there() -> None:
    latest = Latest(lambda: None)
    latest.ask(lambda _: 7)
    assert latest.join(10)
    latest.drop()
    assert latest.take() is None
    latest.ask(lambda _: 8)
    assert latest.join(10)
    assert latest.take() == (8, "")


def test_one_who_cannot_be_woken_may_ask_again() -> None:
    woken: list[int] = []

    def wake() -> None:
        woken.append(1)
        if len(woken) == 1:
            raise RuntimeError("the page is gone")

    latest = Latest(wake)
    for answer in (1, 2):
        latest.ask(lambda _, answer=answer: answer)
        assert latest.join(10)
    assert (len(woken), latest.take()) == (2, (2, ""))


def test_a_thread_that_could_not_be_had_is_asked_for_again(monkeypatch: pytest.MonkeyPatch) -> None:
    latest = Latest(lambda: None)

    def none_left(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    with monkeypatch.context() as without:
        without.setattr(threading.Thread, "start", none_left)
        with pytest.raises(RuntimeError, match="new thread"):
            latest.ask(lambda _: 1)
    latest.ask(lambda _: 2)
    assert latest.join(10)
    assert latest.take() == (2, "")


def test_jobs_of_many_screens_take_turns_and_who_is_gone_waits_no_longer() -> None:
    slots, slow = Slots(1), Slow()
    first, second, third = (Latest(lambda: None, slots) for _ in range(3))
    first.ask(slow)
    assert slow.begun.wait(10)
    second.ask(lambda _: "second")
    third.ask(lambda _: "third")
    second.close()
    assert second.join(10)
    assert third.take() is None
    assert (slots.held, slots.waiting) == (1, 1)
    slow.go.set()
    assert all(latest.join(10) for latest in (first, third))
    assert [latest.take() for latest in (first, second, third)] == [
        ("done", ""), None, ("third", "")
    ]  # fmt: skip
    assert (slots.held, slots.waiting) == (0, 0)
