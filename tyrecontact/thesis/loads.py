"""Which indentation gives a preload, and how far back the road must go to take it off.

`python -m tyrecontact.thesis.loads` prints `LOADS` of figures/base.py for the default road.
"""

from __future__ import annotations

import numpy as np

from tyrecontact import figures
from tyrecontact.scenario import Scenario
from tyrecontact.simulation import Simulation

#: preloads of the thesis' chapter 5 [N]; of Fig. 42 it says only that it was above 100 N
PRELOADS = (14, 62, 110, 150)
_STEPS = 120


def measured(preload: float) -> tuple[float, float]:
    """Indentation of a preload [m], and the way back to no force per newton [m/N].

    Quasi-statically, with the adhesion of the thesis' runs.
    """
    loading = Scenario()
    depth, force = _path(Simulation(loading).quasi_static(_STEPS))
    indentation = float(np.interp(preload, force, depth))
    cycle = figures.sticky()
    cycle.loading.param.update(max_indentation=indentation, hold_time=0.0)
    depth, force = _path(Simulation(cycle).quasi_static(_STEPS))
    top = int(depth.argmax())
    free = top + int(np.flatnonzero(force[top:] <= 0)[0])
    return indentation, (depth[top] - depth[free]) / force[top]


def _path(simulation: Simulation) -> tuple[np.ndarray, np.ndarray]:
    """Indentation [m] and force [N] of all steps."""
    depth, force = zip(*((s.indentation, s.contact_force) for s in simulation), strict=True)
    return np.array(depth), np.array(force)


if __name__ == "__main__":
    for newtons in PRELOADS:
        deep, way = measured(newtons)
        print(f"    {newtons}: ({deep * 1e6:.1f}e-6, {way * 1e6:.3f}e-6),")
