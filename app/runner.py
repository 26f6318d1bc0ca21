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
from tyrecontact.results import Record

#: steps of the quasi-static run that a dynamic one is compared with
BASELINE_STEPS = 96
_KEPT_BASELINES = 16


class Phase(Enum):
    """Where a run stands; the last three are ends."""

    WAITING = "waiting"
    PREPARING = "preparing"
    RUNNING = "running"
    FINISHED = "finished"
    STOPPED = "stopped"
    REFUSED = "refused"

    @property
    def ended(self) -> bool:
        return self in (Phase.FINISHED, Phase.STOPPED, Phase.REFUSED)


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


class Run:
    """A scenario being run on a thread.

    Parameters
    ----------
    scenario : is copied.
    duration : least wall-clock time of the whole run [s], so that it can be watched; 0 is as
        fast as possible.

    Attributes
    ----------
    phase : where the run stands.
    simulation, record, baseline : None until they are made; `record` grows while running.
    message : why the run was refused, or empty.
    """

    def __init__(self, scenario: Scenario, duration: float = 0.0) -> None:
        self.scenario = scenario.copy()
        self.phase = Phase.WAITING
        self.simulation: Simulation | None = None
        self.record: Record | None = None
        self.baseline: Baseline | None = None
        self.message = ""
        self._duration = duration
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name="tyrecontact-run", daemon=True)

    def start(self) -> None:
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
        reason = "stopped by the user" if self.phase is Phase.STOPPED else ""
        return self.simulation.collect(self.record, reason)

    def _work(self) -> None:
        try:
            self.phase = Phase.PREPARING
            self._prepare()
            if not self._stop.is_set():
                self.phase = Phase.RUNNING
                self._solve()
            self.phase = Phase.STOPPED if self._stop.is_set() else Phase.FINISHED
        except (TyreContactError, MemoryError) as error:
            self.message = str(error) or "not enough memory for this run"
            self.phase = Phase.REFUSED
        except BaseException as error:
            self.message = f"the run failed: {error!r}"
            self.phase = Phase.REFUSED
            raise

    def _prepare(self) -> None:
        simulation = Simulation(self.scenario)
        bodies = simulation.bodies
        if self._stop.is_set():
            return
        self.baseline = _baseline(simulation)
        self.record = Record(len(simulation), bodies.kernel.shape)
        self.simulation = simulation

    def _solve(self) -> None:
        assert self.simulation is not None
        assert self.record is not None
        began, steps = time.monotonic(), len(self.simulation)
        for step in self.simulation:
            self.record.append(step)
            due = began + self._duration * self.record.count / steps
            if self._stop.is_set() or self._stop.wait(max(0.0, due - time.monotonic())):
                return


_baselines: OrderedDict[str, Baseline] = OrderedDict()
_baselines_lock = threading.Lock()


def _baseline(simulation: Simulation) -> Baseline:
    """The quasi-static run of a scenario; kept, since numerics do not change it."""
    parts = simulation.scenario.to_dict()
    del parts["numerics"]
    key = json.dumps(parts)
    with _baselines_lock:
        if key in _baselines:
            _baselines.move_to_end(key)
            return _baselines[key]
    made = _run_at_rest(simulation)
    if not simulation.scenario.road.file:  # a file may change under its name
        with _baselines_lock:
            _baselines[key] = made
            while len(_baselines) > _KEPT_BASELINES:
                _baselines.popitem(last=False)
    return made


def _run_at_rest(simulation: Simulation) -> Baseline:
    results = simulation.quasi_static(BASELINE_STEPS).run()
    peak = float(results.element_force.max(initial=0.0))
    return Baseline(results.time, results.indentation, results.contact_force, peak)
