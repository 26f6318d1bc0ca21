"""A solved time step: what is kept of it, with units and meanings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: name -> (unit, meaning, type) of what is kept of each step
SCALARS = {
    "indentation": ("m", "Indentation of the road into the tread", float),
    "contact_force": ("N", "Total contact force, positive when pressing", float),
    "drive": ("m or N", "Position of the machine's end, or its force where that is given", float),
    "iterations": ("1", "Newton iterations of the step", np.int32),
    "residual": ("m", "Largest residual of the contact equation", float),
    "converged": ("1", "Whether the step converged (1) or not (0)", np.int8),
    "stability_margin": ("1", "Margin of the time stepping: 1 safe, below 0 it may blow up", float),
    "contacts": ("1", "Number of elements in contact, bonded ones in tension included", np.int32),
    "releases": ("1", "Number of bonds that broke in the step", np.int32),
    "drive_work": ("J", "Work done by the drive since the start", float),
    "spring_energy": ("J", "Energy held by the roughness springs", float),
    "machine_energy": ("J", "Energy held by the machine's spring and mass", float),
    "layer_work": ("J", "Net energy passed into the tread", float),
    "released_energy": ("J", "Energy lost when bonds broke and contacts receded", float),
    "algorithmic_loss": ("J", "Energy taken by the time stepping", float),
}
FIELDS = {
    "element_force": ("N", "Force on each element, positive when pressing", float),
    "compression": ("m", "Compression of each roughness spring", float),
    "displacement": ("m", "Displacement of the tread under each element", float),
    "contact_area": ("m2", "Area of contact within each element", np.float32),
    "age": ("s", "Time since each element came into contact", np.float32),
    "state": ("1", "State of each element", np.int8),
}


@dataclass(frozen=True)
class Step:
    """One solved time step; it belongs to whoever receives it.

    Attributes
    ----------
    index, time : number of the step and its time [s].
    indentation [m] .. algorithmic_loss [J] : one number each, as in `SCALARS`.
    element_force [N] .. state : shape (ny, nx), as in `FIELDS`; state is an `ElementState`.
    stop_reason : why the run ends with this step although steps remain, or empty.
    """

    index: int
    time: float
    indentation: float
    contact_force: float
    drive: float
    iterations: int
    residual: float
    converged: bool
    stability_margin: float
    contacts: int
    releases: int
    drive_work: float
    spring_energy: float
    machine_energy: float
    layer_work: float
    released_energy: float
    algorithmic_loss: float
    element_force: np.ndarray
    compression: np.ndarray
    displacement: np.ndarray
    contact_area: np.ndarray
    age: np.ndarray
    state: np.ndarray
    stop_reason: str = ""
