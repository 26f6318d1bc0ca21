"""A fair queue: so many runs at once, the others in the order in which they came."""

from __future__ import annotations

import threading
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager

#: how often who waits looks whether it is still wanted [s]
_LOOK = 0.5


class Ticket:
    """A place in the queue, or a slot.

    Attributes
    ----------
    granted : it holds a slot, and may go on.
    """

    def __init__(self, wake: Callable[[], None]) -> None:
        self.granted = False
        self.wake = wake


class Slots:
    """So many runs at once.

    Parameters
    ----------
    most : number of slots; None for as many as are asked for.
    """

    def __init__(self, most: int | None = None) -> None:
        self._most = most
        self._lock = threading.Lock()
        self._holding: set[Ticket] = set()
        self._queue: list[Ticket] = []

    def enter(self, wake: Callable[[], None], instead_of: Ticket | None = None) -> Ticket:
        """A ticket, at the end of the queue or in the place of one that still waits there.

        Parameters
        ----------
        wake : called without any lock held, on any thread, when the ticket gets a slot, and when
            others begin to wait for the slot that it holds.
        """
        ticket = Ticket(wake)
        with self._lock:
            if instead_of in self._queue:
                self._queue[self._queue.index(instead_of)] = ticket
            else:
                self._queue.append(ticket)
            told = self._grant() | (self._holding if self._queue else set())
        _tell(told - {ticket})
        return ticket

    def leave(self, ticket: Ticket) -> None:
        """Give a slot, or a place in the queue, back; twice does no harm."""
        with self._lock:
            ticket.granted = False
            self._holding.discard(ticket)
            if ticket in self._queue:
                self._queue.remove(ticket)
            told = self._grant()
        _tell(told)

    @contextmanager
    def turn(self, wanted: Callable[[], bool]) -> Iterator[bool]:
        """Wait on this thread for a slot, and hold it; False where it is not wanted any more."""
        called = threading.Event()
        ticket = self.enter(called.set)
        try:
            while wanted() and not ticket.granted:
                called.wait(_LOOK)
            yield ticket.granted and wanted()
        finally:
            self.leave(ticket)

    def place(self, ticket: Ticket) -> int:
        """Where a ticket stands in the queue, 1 for the next one; 0 for one that does not wait."""
        with self._lock:
            return self._queue.index(ticket) + 1 if ticket in self._queue else 0

    @property
    def waiting(self) -> int:
        """Number of those in the queue."""
        return len(self._queue)

    @property
    def held(self) -> int:
        """Number of slots that are taken."""
        return len(self._holding)

    def _grant(self) -> set[Ticket]:
        """Give free slots to those who wait; who got one."""
        free = len(self._queue) if self._most is None else self._most - len(self._holding)
        granted = self._queue[: max(free, 0)]
        del self._queue[: len(granted)]
        for ticket in granted:
            ticket.granted = True
        self._holding.update(granted)
        return set(granted)


def _tell(tickets: set[Ticket]) -> None:
    for ticket in tickets:
        ticket.wake()


class SessionCount:
    """How many visitors are on the page, and whether one more may come.

    Parameters
    ----------
    most : number of visitors; None for no limit.
    """

    def __init__(self, most: int | None = None) -> None:
        self._most = most
        self._lock = threading.Lock()
        self._here: set[Hashable] = set()

    def __len__(self) -> int:
        return len(self._here)

    def enter(self, who: Hashable) -> bool:
        """Let a visitor in, told by anything of their own; False if it is full."""
        with self._lock:
            if who not in self._here and self._most is not None and len(self._here) >= self._most:
                return False
            self._here.add(who)
            return True

    def leave(self, who: Hashable) -> None:
        """A visitor has left; one who was not let in changes nothing."""
        with self._lock:
            self._here.discard(who)
