"""Where a run stands."""

from __future__ import annotations

from enum import Enum


class Phase(Enum):
    """Where a run stands; the last four are ends."""

    WAITING = "waiting"  #: for its start, or for the run that it supersedes
    QUEUED = "queued"  #: for a slot, where a server lets only so many runs go on at once
    PREPARING = "preparing"
    RUNNING = "running"
    PAUSED = "paused"
    COMPARING = "comparing"  #: all steps are done; the run that they are compared with is made
    FINISHED = "finished"
    STOPPED = "stopped"
    REFUSED = "refused"  #: before the first step
    FAILED = "failed"  #: after it: what was computed stays

    @property
    def ended(self) -> bool:
        return self in _ENDS


_ENDS = frozenset({Phase.FINISHED, Phase.STOPPED, Phase.REFUSED, Phase.FAILED})
