"""How far a run goes on the horizontal axis of its plots, as far as that is known."""

from __future__ import annotations

import numpy as np

from .runner import Run
from .views.map_scale import Scale
from .views.style import EMPTY


class Reach:
    """Time and indentation that a run reaches.

    Before its quasi-static run is there no one knows how deep a force will press: then it is what
    has been reached, in leaps.
    """

    def __init__(self) -> None:
        self._depths = Scale()

    def clear(self) -> None:
        """Another run comes."""
        self._depths = Scale()

    def widen(self, run: Run, low: int, high: int) -> bool:
        """Take steps low .. high - 1 of a run; whether it reaches further than was known."""
        if run.record is None or run.baseline is not None or not _forced(run):
            return False
        columns, before = run.record.columns, self._depths
        touching = columns["contact_force"][low:high] != 0  # what is torn off flies far away
        depth = 1e6 * columns["indentation"][low:high][touching]
        self._depths = before.holding(depth.min(initial=0.0), depth.max(initial=0.0))
        return self._depths != before

    def of(self, run: Run | None) -> tuple[np.ndarray, np.ndarray]:
        """Time [s] and indentation [m] that there are, or may be; shape (points,) each."""
        if run is None or run.simulation is None:
            return EMPTY
        schedule = run.simulation.schedule
        if run.baseline is not None:
            return schedule.time, run.baseline.met
        if not _forced(run):
            return schedule.time, schedule.drive
        depths = 1e-6 * np.array([self._depths.low, self._depths.high])
        return schedule.time, depths if depths.any() else EMPTY[1]


def _forced(run: Run) -> bool:
    return bool(run.scenario.loading.drive == "force")
