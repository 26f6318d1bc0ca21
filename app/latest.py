"""Work for one screen on a thread: of several questions only the last is answered.

It knows no screen. The thread lives while there is something to do; whoever asked is woken, and
takes the answer when it suits.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from functools import partial
from typing import Any

from tyrecontact.errors import TyreContactError

from .limits import preparing
from .slots import Slots

_LOG = logging.getLogger(__name__)
#: does the work, told at its leisure whether it is still wanted
Job = Callable[[Callable[[], bool]], Any]


class Latest:
    """Answers the last question asked.

    Parameters
    ----------
    wake : called on the thread when there is an answer to be taken.
    slots : a job is done when it gets one; those of the server where none are given.
    """

    def __init__(self, wake: Callable[[], None], slots: Slots | None = None) -> None:
        self._wake, self._slots = wake, slots or preparing()
        self._lock = threading.Lock()
        self._asked = 0
        self._waiting: tuple[int, Job] | None = None
        self._answer: tuple[Any, str] | None = None
        self._thread: threading.Thread | None = None
        self._closed = False

    def ask(self, job: Job) -> None:
        """Have a job done; what was asked before is not wanted any more."""
        with self._lock:
            if self._closed:
                return
            self._asked += 1
            self._waiting, self._answer = (self._asked, job), None
            if self._thread is None:
                thread = threading.Thread(target=self._work, name="tyrecontact-latest", daemon=True)
                thread.start()  # fails where there are no more threads: the next question tries
                self._thread = thread

    def take(self) -> tuple[Any, str] | None:
        """What the job gave and "", or None and why it was refused; None while there is none."""
        with self._lock:
            answer, self._answer = self._answer, None
        return answer

    def drop(self) -> None:
        """What was asked so far is not wanted any more."""
        with self._lock:
            self._asked += 1
            self._waiting = self._answer = None

    def close(self) -> None:
        """Nothing is wanted any more: the thread ends after what it is in the midst of."""
        self._closed = True
        self.drop()

    def join(self, timeout: float | None = None) -> bool:
        """Wait until there is nothing to do; True if so."""
        thread = self._thread
        if thread is not None:
            thread.join(timeout)
        return thread is None or not thread.is_alive()

    def _work(self) -> None:
        while True:
            with self._lock:
                task, self._waiting = self._waiting, None
                if task is None:
                    self._thread = None
                    return
            number, job = task
            wants = partial(self._wants, number)
            with self._slots.turn(wants) as granted:
                answer = _answer(job, wants) if granted else (None, "")
            with self._lock:
                wanted = number == self._asked
                if wanted:
                    self._answer = answer
            if wanted:
                self._tell()

    def _tell(self) -> None:
        try:
            self._wake()
        except Exception:  # the thread goes on: there may be another question
            _LOG.exception("nobody could be told of an answer")

    def _wants(self, number: int) -> bool:
        return number == self._asked


def _answer(job: Job, wanted: Callable[[], bool]) -> tuple[Any, str]:
    try:
        return job(wanted), ""
    except TyreContactError as error:
        return None, str(error)
    except MemoryError as error:
        return None, str(error) or "not enough memory to prepare this"
    except Exception as error:  # said on the page, where a thread's end would be silence
        _LOG.exception("a question could not be answered")
        return None, f"an error that should not be, {error!r}"
