"""How fast a run goes: when its next step is due, and how long the others will take."""

from __future__ import annotations

import math

from tyrecontact.errors import InputError

#: a run that is late by more than this does not catch up on the remainder [s]
_LATE = 0.1
#: seconds of work over which the time of a step is averaged
_MEMORY = 3.0
#: so many steps, and seconds at the pace asked for, are enough to say how long the others take
_STEPS, _SECONDS = 3, 0.5


class Pace:
    """When the steps of a run are due.

    Times are seconds of one clock that never goes back; the clock is the caller's.

    Parameters
    ----------
    duration : least time of a whole run [s]; 0 is as fast as possible. May change at any time:
        the next step is due by the new one.

    Raises
    ------
    InputError : a duration that is no time.
    """

    def __init__(self, duration: float = 0.0) -> None:
        self.duration = duration
        self.steps = 1  #: of the whole run
        self._due: float | None = None  # when the last step was due; None: after a rest
        self._began: float | None = None
        self._work = self._weight = 0.0
        self._count, self._went = 0, 0.0

    @property
    def duration(self) -> float:
        return self._duration

    @duration.setter
    def duration(self, seconds: float) -> None:
        if not 0 <= seconds < math.inf:
            raise InputError(f"duration of a run must be 0 or more, got {seconds} s")
        self._duration = float(seconds)

    @property
    def interval(self) -> float:
        """Least time from one step to the next [s]."""
        return self._duration / self.steps

    def delay(self, now: float) -> float:
        """Seconds until the next step is due; 0 after a rest: what was missed is not made up."""
        return 0.0 if self._due is None else max(0.0, self._due + self.interval - now)

    def begin(self, now: float) -> None:
        """A step begins."""
        late = now if self._due is None else max(self._due + self.interval, now - _LATE)
        # a step may not wait for a moment that a longer interval has put ahead
        self._due, self._began = min(late, now), now

    def end(self, now: float) -> None:
        """The step that began last is done."""
        if self._began is None:
            return
        work, self._began = now - self._began, None
        kept = math.exp(-work / _MEMORY)
        self._work, self._weight = kept * self._work + work, kept * self._weight + 1
        self._count, self._went = self._count + 1, self._went + max(work, self.interval)

    def rest(self) -> None:
        """The run pauses: the time until its next step does not count."""
        self._due = None

    def time_left(self, count: int) -> float | None:
        """How long the steps after the first `count` will take [s]; None: too early to say."""
        if self._count < _STEPS or self._went < _SECONDS:
            return None
        return (self.steps - count) * max(self._work / self._weight, self.interval)
