"""One question at a time, and only the latest is answered."""

from __future__ import annotations

import threading

from app.latest import Latest


class Document:
    """Keeps what is to be done in the session's loop."""

    def __init__(self) -> None:
        self.next: list = []

    def add_next_tick_callback(self, callback: object) -> None:
        self.next.append(callback)


def test_an_answer_comes_in_the_loop_and_the_thread_ends() -> None:
    document, answers = Document(), []
    work = Latest(document)
    work.ask(lambda: 7, answers.append)
    assert work.join(10)
    assert not answers
    document.next[0]()
    assert answers == [7]


def test_a_question_replaces_those_that_wait() -> None:
    asked, answers, free = [], [], threading.Event()
    work = Latest(None)
    work.ask(lambda: free.wait(10), lambda _: answers.append("first"))
    for number in range(3):
        work.ask(lambda number=number: asked.append(number), lambda _: answers.append("last"))
    free.set()
    assert work.join(10)
    assert asked == [2]
    assert answers == ["last"]


def test_what_was_dropped_is_not_answered_even_if_it_was_on_its_way() -> None:
    document, answers = Document(), []
    work = Latest(document)
    work.ask(lambda: 7, answers.append)
    assert work.join(10)
    work.drop()
    document.next[0]()
    assert not answers
