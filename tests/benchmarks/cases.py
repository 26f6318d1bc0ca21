"""What is timed: runs in their middle, whole runs, and the making of bodies.

A step is timed with a full memory and many contacts. So a window of a run begins with a step at
rest at 0.05 mm, whose forces fill the memory at once (a long hold does that), and goes on at
10 mm/s, to 0.1 mm and back, for as many steps as there are lags: the mean over them counts, since
a method may do more in some steps than in others. The patch is 20 mm wide, however many its
elements.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from tyrecontact import Scenario, Simulation, presets
from tyrecontact.loading import Schedule

SIZES = (20, 64, 128, 256)
LAGS = 256
#: of the lattice of 20 x 20
MANY_LAGS = (64, 128, 256, 512, 1024, 2048)
RATE = 0.01  # m/s
BEGIN, TRAVEL = 5e-5, 5e-5  # m
#: the thesis' kernel blows up deeper than that where elements are small
SHALLOW = 3e-5  # m
KERNELS: dict[str, dict[str, Any]] = {
    "passive": {},
    # interpolated to 257 lags: without that it blows up
    "band-limited": {
        "kernel": "band-limited", "lags": 65, "time_resolution_factor": 4,
        "solver": "thesis", "max_iterations": 50,
    },
}  # fmt: skip
#: windows that take longer end; so do quasi-static runs [s]
LONGEST, STATIC_LONGEST = 100.0, 30.0


@dataclass(frozen=True)
class Window:
    """Timed steps: seconds of each, contacts per element in their middle, margin at the end."""

    seconds: np.ndarray
    share: float
    margin: float

    @property
    def mean(self) -> float:
        return float(self.seconds.mean())


def run(elements: int, kernel: str) -> Simulation:
    """What is timed of a kernel: a window of 256 lags, or a quasi-static run."""
    return quasi_static(elements) if kernel == "static" else window(elements, kernel)


def window(elements: int, kernel: str, lags: int = LAGS) -> Simulation:
    """A run that begins at rest under load and goes on for as many steps as there are lags.

    At least 256, so that all lags see the same motion.
    """
    scenario = _scenario(elements)
    scenario.loading.rate = 0.2e-3 / 0.04  # a kernel must not outlast the loading
    scenario.numerics.lags = lags
    scenario.numerics.param.update(**KERNELS[kernel])
    simulation = Simulation(scenario)
    simulation.patch, simulation.springs = _road(elements)
    count = np.arange(max(lags, LAGS) + 1)
    travelled = RATE * simulation.time_step * count
    begin = SHALLOW if kernel == "band-limited" and elements > 20 else BEGIN
    drive = begin + TRAVEL - np.abs(TRAVEL - travelled % (2 * TRAVEL))
    simulation.schedule = Schedule(simulation.time_step * count, drive, count == 0)
    return simulation


def quasi_static(elements: int, steps: int = 40) -> Simulation:
    """The tread at rest in steps of 5 micrometres, to 0.2 mm."""
    simulation = Simulation(_scenario(elements))
    simulation.patch, simulation.springs = _road(elements)
    return simulation.quasi_static(steps + 1)


def default_run() -> Simulation:
    """The default scenario in 1024 steps, nothing of it made yet."""
    scenario = presets.get("default")
    scenario.loading.rate = RATE
    return Simulation(scenario)


def begun(simulation: Simulation) -> Iterator[Any]:
    """The loop of a simulation after its first step."""
    steps = iter(simulation)
    next(steps)
    return steps


def timed(steps: Iterable[Any], longest: float = np.inf) -> tuple[np.ndarray, list[Any]]:
    """Seconds of each step, and the steps; no more once `longest` [s] have passed."""
    loop, seconds, found = iter(steps), [], []
    begin = time.perf_counter()
    while True:
        start = time.perf_counter()
        step = next(loop, None)
        end = time.perf_counter()
        if step is None:
            return np.array(seconds), found
        seconds.append(end - start)
        found.append(step)
        if end - begin > longest:
            return np.array(seconds), found


def timed_window(steps: Iterator[Any], longest: float) -> Window:
    """Time the steps of a run."""
    seconds, found = timed(steps, longest)
    middle = found[len(found) // 2]
    return Window(seconds, middle.contacts / middle.element_force.size, found[-1].stability_margin)


def _scenario(elements: int) -> Scenario:
    """The default road, tread and springs at that resolution."""
    pixel = 25e-6 if elements == 20 else 20e-3 / 2048
    return Scenario(road={"elements": elements, "pixel": pixel})


@lru_cache(maxsize=1)  # 1.3 GB at 256 x 256
def _road(elements: int) -> tuple[Any, Any]:
    """Patch and springs at a resolution."""
    simulation = Simulation(_scenario(elements))
    return simulation.patch, simulation.springs
