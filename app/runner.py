"""One run on a thread of its own: one object, one end. It knows no screen.

The thread writes, everybody else reads: rows of `record` up to `record.count`, `baseline`, and
`phase`, which is written last when a run ends.
"""

from __future__ import annotations

import json
import threading
import time
from collections import OrderedDict
from dataclasses import dataclass
from enum import Enum

import numpy as np

from tyrecontact import Results, Scenario, Simulation
from tyrecontact.errors import TyreContactError
from tyrecontact.results import STOPPED, Record

#: steps of the quasi-static run that a dynamic one is compared with
BASELINE_STEPS = 160
_KEPT_BASELINES = 16


class Phase(Enum):
    """Where a run stands; the last four are ends."""

    WAITING = "waiting"
    PREPARING = "preparing"
    RUNNING = "running"
    FINISHED = "finished"
    STOPPED = "stopped"
    REFUSED = "refused"  #: before the first step
    FAILED = "failed"  #: after it: what was computed stays

    @property
    def ended(self) -> bool:
        return self not in (Phase.WAITING, Phase.PREPARING, Phase.RUNNING)


@dataclass(frozen=True)
class Baseline:
    """The same scenario with the tread at rest in every step, on few steps.

    Attributes
    ----------
    time [s], indentation [m], contact_force [N] : shape (steps,).
    peak_element_force : largest force on an element [N].
    """

    time: np.ndarray
    indentation: np.ndarray
    contact_force: np.ndarray
    peak_element_force: float

    @property
    def met(self) -> np.ndarray:
        """Indentations [m], but for those far from where road and tread meet.

        A road that a force has torn off flies away for millimetres.
        """
        touching = np.flatnonzero(self.contact_force)
        if not touching.size:
            return self.indentation
        near = self.indentation[: touching[-1] + 1]
        return self.indentation.clip(near.min() - np.ptp(near), None)


class Run:
    """A scenario being run on a thread.

    Parameters
    ----------
    scenario : is copied.
    duration : least wall-clock time of the whole run [s], so that it can be watched; 0 is as
        fast as possible.
    after : a run that this one supersedes: it is stopped, and waited for.

    Attributes
    ----------
    phase : where the run stands.
    simulation, record, baseline : None until they are made; `record` grows while running.
    message : why the run was refused or failed, or empty.
    """

    def __init__(self, scenario: Scenario, duration: float = 0.0, after: Run | None = None) -> None:
        self.scenario = scenario.copy()
        self.phase = Phase.WAITING
        self.simulation: Simulation | None = None
        self.record: Record | None = None
        self.baseline: Baseline | None = None
        self.message = ""
        self._duration = duration
        self._after = after
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name="tyrecontact-run", daemon=True)

    @property
    def stopping(self) -> bool:
        """Asked to end, and not at its end yet."""
        return self._stop.is_set() and not self.phase.ended

    def start(self) -> None:
        if self._after is not None:
            self._after.stop()
        self._thread.start()

    def stop(self) -> None:
        """Ask the run to end; it does so before its next step and keeps what it has."""
        self._stop.set()

    def join(self, timeout: float | None = None) -> bool:
        """Wait for the end; True if it has come."""
        self._thread.join(timeout)
        return not self._thread.is_alive()

    def results(self) -> Results | None:
        """What has been computed so far, or None if nothing has."""
        if self.simulation is None or self.record is None:
            return None
        reason = {Phase.STOPPED: STOPPED, Phase.FAILED: self.message}
        return self.simulation.collect(self.record, reason.get(self.phase, ""))

    def _work(self) -> None:
        if self._after is not None:
            self._after.join()
            self._after = None
        try:
            self.phase = Phase.PREPARING
            complete = self._prepare() and self._solve()
            self.phase = Phase.FINISHED if complete else Phase.STOPPED
        except (TyreContactError, MemoryError) as error:
            self._end_in(str(error) or "not enough memory for this run")
        except BaseException as error:
            self._end_in(f"an error that should not be, {error!r}")
            raise

    def _end_in(self, message: str) -> None:
        self.message = message
        begun = self.record is not None and self.record.count > 0
        self.phase = Phase.FAILED if begun else Phase.REFUSED

    def _prepare(self) -> bool:
        """Make what the loop needs; False where the run was stopped meanwhile."""
        simulation = Simulation(self.scenario)
        for part in ("patch", "springs", "kernel", "bodies"):
            if self._stop.is_set():
                return False
            getattr(simulation, part)
        baseline = _baseline(simulation, self._stop)
        if baseline is None:
            return False
        memory = simulation.scenario.numerics.field_memory
        self.record = Record(len(simulation), simulation.bodies.kernel.shape, memory)
        self.baseline = baseline
        self.simulation = simulation
        return True

    def _solve(self) -> bool:
        """The loop; False where the run was stopped before its end."""
        assert self.simulation is not None
        assert self.record is not None
        self.phase = Phase.RUNNING
        began, steps = time.monotonic(), len(self.simulation)
        for step in self.simulation:
            self.record.append(step)
            if step.stop_reason or self.record.count == steps:
                break
            due = began + self._duration * self.record.count / steps
            if self._stop.is_set() or self._stop.wait(max(0.0, due - time.monotonic())):
                return False
        return True


_baselines: OrderedDict[str, Baseline] = OrderedDict()
_baselines_lock = threading.Lock()


def _baseline(simulation: Simulation, stop: threading.Event) -> Baseline | None:
    """The quasi-static run of a scenario, or None if stopped; kept, as few settings change it."""
    parts = simulation.scenario.to_dict()
    del parts["numerics"]
    key = json.dumps([parts, simulation.time_step])
    with _baselines_lock:
        if key in _baselines:
            _baselines.move_to_end(key)
            return _baselines[key]
    made = _run_at_rest(simulation, stop)
    if made is not None and not simulation.scenario.road.file:  # a file may change under its name
        with _baselines_lock:
            _baselines[key] = made
            while len(_baselines) > _KEPT_BASELINES:
                _baselines.popitem(last=False)
    return made


def _run_at_rest(simulation: Simulation, stop: threading.Event) -> Baseline | None:
    still = simulation.quasi_static(BASELINE_STEPS)
    record, peak = Record(len(still), simulation.bodies.kernel.shape, field_memory=0.0), 0.0
    for step in still:
        if stop.is_set():
            return None
        record.append(step)
        peak = max(peak, float(step.element_force.max()))
    results = still.collect(record)
    return Baseline(results.time, results.indentation, results.contact_force, peak)
