"""What the form has said before: undo, redo."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

#: changes of one setting that follow each other faster are one change: a drag of a slider [s]
_ONE_DRAG = 0.8
#: changes remembered
_MOST = 200


class Past(NamedTuple):
    """What the form said: the preset and all settings as plain values."""

    preset: str
    settings: dict[str, dict[str, Any]]


class History:
    """States of the form, and which of them is on show."""

    def __init__(self, first: Past) -> None:
        self._states, self._now = [first], 0
        self._last: tuple[str, float] = ("", -1e9)
        self._joining = self._joined = False

    @contextmanager
    def as_one(self) -> Iterator[None]:
        """All changes made meanwhile are one, and undone at once."""
        self._joining, self._joined = True, False
        try:
            yield
        finally:
            self._joining, self._last = False, ("", -1e9)

    @property
    def can_undo(self) -> bool:
        return self._now > 0

    @property
    def can_redo(self) -> bool:
        return self._now + 1 < len(self._states)

    def add(self, state: Past, what: str, now: float | None = None) -> None:
        """Remember a state after a change of `what`, the path of a setting, or empty for all of
        them; what could have been redone is forgotten. `now` is a clock [s]."""
        now = time.monotonic() if now is None else now
        if state == self._states[self._now]:
            return
        del self._states[self._now + (0 if self._goes_on(what, now) else 1) :]
        self._states = [*self._states, state][-_MOST:]
        self._now = len(self._states) - 1
        self._last, self._joined = (what, now), self._joining

    def _goes_on(self, what: str, now: float) -> bool:
        """Whether a change takes the place of the last one."""
        if self._joining:
            return self._joined
        before, then = self._last
        return bool(what) and what == before and now - then < _ONE_DRAG and self._now > 0

    def undo(self) -> Past | None:
        """The state before, or None."""
        return self._go(-1) if self.can_undo else None

    def redo(self) -> Past | None:
        """The state that was undone, or None."""
        return self._go(1) if self.can_redo else None

    def _go(self, by: int) -> Past:
        self._now += by
        self._last = ("", -1e9)
        return self._states[self._now]
