"""Figures that show a kernel or springs and need no run (thesis, Figs. 22 and 39)."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from tyrecontact import figures
from tyrecontact.contact.adhesion import table_limits
from tyrecontact.simulation import Simulation

if TYPE_CHECKING:
    import xarray as xr

#: of the kernel that is shown [s]
_SHOWN = 0.5e-3
#: springs that are shown: from the softest to the stiffest at a compression [m]
_QUANTILES, _RANKED_AT = (0.1, 0.35, 0.65, 0.9), 5e-6


def kernels() -> xr.Dataset:
    """Displacement per impulse against time, of the loaded element and its neighbour (Fig. 22)."""
    import xarray as xr

    dataset = xr.Dataset()
    for label, scenario in figures.find("fig-22").family().items():
        kernel = Simulation(scenario).kernel
        time = np.arange(kernel.lags) * kernel.time_step
        shown = time <= _SHOWN
        name = label.replace(" ", "_")
        for place, column in (("self", 0), ("neighbour", 1)):
            values = kernel.values[shown, 0, column] / kernel.time_step
            dataset[f"{place}_{name}"] = (f"time_{name}", values, {"units": "m/(N s)"})
        dataset = dataset.assign_coords(
            {f"time_{name}": (f"time_{name}", time[shown], {"units": "s"})}
        )
    return dataset


def springs() -> xr.Dataset:
    """Force and stiffness of four springs that pull as they press (Fig. 39)."""
    import xarray as xr

    scenario = figures.member("fig-39", "0.6 N")
    law = Simulation(scenario).springs
    adhesion = scenario.adhesion
    limits = np.full(law.count, adhesion.release_force)
    if adhesion.table_step:
        limits = table_limits(law, adhesion.release_force, adhesion.table_step)
    ranking = np.argsort(law.force(np.full(law.count, _RANKED_AT)))
    chosen = ranking[[round(share * (law.count - 1)) for share in _QUANTILES]]
    depth = np.linspace(-20e-6, 20e-6, 401)
    force, stiffness = np.empty((2, chosen.size, depth.size))
    for column, compression in enumerate(depth):
        pressed = np.full(law.count, abs(compression))
        f, k = law.respond(pressed, np.ones(law.count, bool))[:2]
        holds = (compression >= 0) | (f <= limits)
        force[:, column] = np.where(holds, np.sign(compression) * f, 0.0)[chosen]
        stiffness[:, column] = np.where(holds, k, 0.0)[chosen]
    return xr.Dataset(
        {
            "force": (("spring", "compression"), force, {"units": "N"}),
            "stiffness": (("spring", "compression"), stiffness, {"units": "N/m"}),
        },
        coords={"compression": ("compression", depth, {"units": "m"})},
    )


#: figure -> what is drawn
CURVES: dict[str, Callable[[], xr.Dataset]] = {"fig-22": kernels, "fig-39": springs}
