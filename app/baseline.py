"""The quasi-static run that a dynamic one is compared with. It knows no screen."""

from __future__ import annotations

import json
import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256

import numpy as np

from tyrecontact import Simulation
from tyrecontact.results import Record

#: steps of the quasi-static run
STEPS = 160
_KEPT = 16
#: what the band-limited kernel of the tread at rest depends on
_OF_STATICS = ("lags", "sampling_frequency", "time_resolution_factor", "refinement")


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


_baselines: OrderedDict[str, Baseline] = OrderedDict()
_lock = threading.Lock()


def kept(simulation: Simulation) -> Baseline | None:
    """The baseline of a scenario where it has been made before; it is the same for many."""
    key = _key(simulation)
    with _lock:
        if key in _baselines:
            _baselines.move_to_end(key)
        return _baselines.get(key)


def made(simulation: Simulation, stopped: Callable[[], bool]) -> Baseline | None:
    """The baseline of a scenario, made now and kept; None if it was `stopped` meanwhile."""
    key = _key(simulation)
    found = _run_at_rest(simulation, stopped)
    if found is not None:
        with _lock:
            _baselines[key] = found
            while len(_baselines) > _KEPT:
                _baselines.popitem(last=False)
    return found


def _key(simulation: Simulation) -> str:
    """All that a baseline depends on."""
    parts, schedule = simulation.scenario.to_dict(), simulation.schedule
    numerics = parts.pop("numerics")
    # the tread's own statics know no time step
    own = numerics["statics"] == "exact"
    at_rest = [] if own else [numerics[name] for name in _OF_STATICS]
    steps = sha256(schedule.time.tobytes() + schedule.drive.tobytes()).hexdigest()
    # a file may change under its name
    return json.dumps([parts, at_rest, steps, simulation.stamps])


def _run_at_rest(simulation: Simulation, stopped: Callable[[], bool]) -> Baseline | None:
    still = simulation.quasi_static(STEPS)
    record, peak = Record(len(still), simulation.bodies.kernel.shape, field_memory=0.0), 0.0
    for step in still:
        if stopped():
            return None
        record.append(step)
        peak = max(peak, float(step.element_force.max()))
    results = still.collect(record)
    return Baseline(results.time, results.indentation, results.contact_force, peak)
