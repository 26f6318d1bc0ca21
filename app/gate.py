"""What a run passes before each step: paused, queued, paced, out of time, or told to end.

The run's thread waits here; any other thread may call the rest. No lock is held while waiting
or while anybody else is woken, so that runs cannot block one another.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from .pace import Pace
from .phase import Phase
from .slots import Slots, Ticket

#: a paused run keeps its slot for so long while others wait for one [s]; then it queues again
PATIENCE = 60.0


class Gate:
    """One run's way through its steps.

    Parameters
    ----------
    say : told the phase that the run is in while it waits, and when it goes on.
    pace : of the steps.
    slots : the queue of runs.
    seconds : that the run may take [s], pauses and waiting not counted; None for no limit.
    paused : it pauses before its first step.
    """

    def __init__(
        self,
        say: Callable[[Phase], None],
        pace: Pace,
        slots: Slots,
        seconds: float | None = None,
        paused: bool = False,
    ) -> None:
        self._say, self._pace, self._slots = say, pace, slots
        self._left, self._since = seconds, 0.0
        self._changed, self._lock = threading.Event(), threading.Lock()
        self._ticket: Ticket | None = None
        self._paused, self._allowed = paused, 0
        self._stopped = False

    @property
    def stopped(self) -> bool:
        return self._stopped

    @property
    def paused(self) -> bool:
        return self._paused

    @property
    def place(self) -> int:
        ticket = self._ticket
        return 0 if ticket is None else self._slots.place(ticket)

    def stop(self) -> None:
        self._stopped = True
        self.wake()

    def pause(self) -> None:
        self._paused = True
        self.wake()

    def resume(self) -> None:
        with self._lock:
            self._paused, self._allowed = False, 0
        self.wake()

    def step(self) -> None:
        with self._lock:
            self._allowed += self._paused
        self.wake()

    def wake(self) -> None:
        """Look again at what is waited for."""
        self._changed.set()

    def queue(self, instead_of: Gate | None = None) -> None:
        """Ask for a slot, in the place of a run that still waits for its own."""
        other = None if instead_of is None else instead_of._ticket
        self._ticket = self._slots.enter(self.wake, other)

    def leave(self) -> None:
        """Give the slot, or the place in the queue, back."""
        if self._ticket is not None:
            self._slots.leave(self._ticket)
            self._ticket = None

    def wait_for(self, ready: Callable[[], bool]) -> bool:
        """Wait until it is so; False if the run is to end instead."""
        while not self._stopped and not ready():
            self._sleep()
        return not self._stopped

    def admits(self) -> bool:
        """Wait for the slot; False if the run is to end instead."""
        ticket = self._ticket
        assert ticket is not None
        if not ticket.granted:
            self._say(Phase.QUEUED)
        admitted = self.wait_for(lambda: ticket.granted)
        self._since = time.monotonic()
        return admitted

    @property
    def is_out_of_time(self) -> bool:
        return self._left is not None and self._remaining(time.monotonic()) <= 0

    @property
    def is_closed(self) -> bool:
        """Whether the run is to end before its next step."""
        return self._stopped or self.is_out_of_time

    def goes_on(self) -> None:
        """Say so; a single step is too short for the controls to show it."""
        self._say(Phase.PAUSED if self._paused else Phase.RUNNING)

    def lets_through(self) -> bool:
        """Wait until the next step is due; False if the run is to end instead."""
        self._pace.end(time.monotonic())
        while not self.is_closed:
            if self._rests:
                self._rest()
                continue
            now = time.monotonic()
            delay = self._pace.delay(now)
            if delay > 0:
                self._sleep(delay if self._left is None else min(delay, self._remaining(now)))
                continue
            with self._lock:
                self._allowed = max(self._allowed - 1, 0)
            self._pace.begin(now)
            return True
        return False

    def _remaining(self, now: float) -> float:
        """Seconds until the run is out of time."""
        assert self._left is not None
        return self._left - (now - self._since)

    @property
    def _rests(self) -> bool:
        return self._paused and not self._allowed

    def _rest(self) -> None:
        """Until the run goes on, or is to end. It may have to wait for a slot again."""
        began = time.monotonic()
        if self._left is not None:
            self._left = self._remaining(began)
        self._pace.rest()
        self._say(Phase.PAUSED)
        while self._rests and not self._stopped:
            rested = time.monotonic() - began
            others = self._ticket is not None and self._slots.waiting > 0
            if others and rested >= PATIENCE:
                self.leave()
            else:
                self._sleep(PATIENCE - rested if others else None)
        if self._ticket is None and not self._stopped:
            self.queue()
            self.admits()
        self._since = time.monotonic()
        self.goes_on()

    def _sleep(self, seconds: float | None = None) -> None:
        """Until something has changed; whoever calls looks again."""
        self._changed.wait(seconds)
        self._changed.clear()
