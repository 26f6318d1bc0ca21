"""Work off the page's loop: one thread, the latest question wins, answers come in the loop."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

Job = Callable[[], Any]
Answer = Callable[[Any], None]


class Latest:
    """Asks one question at a time on a thread that lives only as long as there is one.

    A question that is asked while another is worked on waits for it, and replaces any that waits.
    Only the answer to the latest is given.

    Parameters
    ----------
    document : of the session, into whose loop answers are brought; None: they are given on the
        thread, as in tests.
    """

    def __init__(self, document: Any) -> None:
        self._document = document
        self._lock = threading.Lock()
        self._waiting: tuple[int, Job, Answer] | None = None
        self._number = 0
        self._thread: threading.Thread | None = None

    def ask(self, job: Job, answer: Answer) -> None:
        """Have `answer(job())` called once the thread is free; `job` handles its own errors."""
        with self._lock:
            self._number += 1
            self._waiting = (self._number, job, answer)
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name="road-file", daemon=True)
                self._thread.start()

    def drop(self) -> None:
        """Give no answer to what was asked so far."""
        with self._lock:
            self._number += 1
            self._waiting = None

    def join(self, timeout: float) -> bool:
        """Wait until the thread has nothing to do [s]; whether it has."""
        thread = self._thread
        if thread is not None:
            thread.join(timeout)
        return self._thread is None

    def _next(self) -> tuple[int, Job, Answer] | None:
        with self._lock:
            task, self._waiting = self._waiting, None
            if task is None:
                self._thread = None
            return task

    def _work(self) -> None:
        while (task := self._next()) is not None:
            number, job, answer = task
            self._give(number, answer, job())

    def _give(self, number: int, answer: Answer, found: Any) -> None:
        def give() -> None:
            if number == self._number:
                answer(found)

        if number != self._number:  # nobody waits for it, perhaps there is no document any more
            return
        if self._document is None:
            give()
        else:
            self._document.add_next_tick_callback(give)
