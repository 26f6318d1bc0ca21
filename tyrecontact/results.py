"""The answer: steps as they come, and all of them together."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from tyrecontact import key_figures
from tyrecontact.contact.bonds import ElementState
from tyrecontact.errors import InputError
from tyrecontact.scenario import Scenario

if TYPE_CHECKING:
    import xarray as xr

#: how a run ends that did not fail
COMPLETED, STOPPED = "completed", "stopped by the user"
#: a run that keeps more than this is refused before it starts
MAX_BYTES = 4_000_000_000

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


class Record:
    """Rows of a run in preallocated arrays; `count` is raised last, so that readers may look on.

    Attributes
    ----------
    count : number of steps recorded.
    columns : name -> array, first axis the steps; rows from `count` on are not written yet.
    stop_reason : why the run ended early, or empty.

    Raises
    ------
    InputError : more than `MAX_BYTES` would have to be kept.
    """

    def __init__(self, steps: int, shape: tuple[int, int]) -> None:
        size = (
            steps
            * shape[0]
            * shape[1]
            * sum(np.dtype(kind).itemsize for *_, kind in FIELDS.values())
        )
        if size > MAX_BYTES:
            raise InputError(
                f"a run must keep at most {MAX_BYTES / 1e9:.0f} GB of fields, got "
                f"{size / 1e9:.1f} GB ({steps} steps of {shape[0]} x {shape[1]} elements)"
            )
        self.count = 0
        self.stop_reason = ""
        self.columns = {"time": np.zeros(steps)}
        for name, (_, _, kind) in SCALARS.items():
            self.columns[name] = np.zeros(steps, kind)
        for name, (_, _, kind) in FIELDS.items():
            self.columns[name] = np.zeros((steps, *shape), kind)

    def append(self, step: Step) -> None:
        for name, column in self.columns.items():
            column[self.count] = getattr(step, name)
        self.stop_reason = step.stop_reason
        self.count += 1

    def results(self, scenario: Scenario, spacing: float, stop_reason: str = "") -> Results:
        """What was recorded so far; later rows do not reach it."""
        count = self.count  # once: a thread may be raising it
        columns = {name: column[:count] for name, column in self.columns.items()}
        reason = stop_reason or self.stop_reason or COMPLETED
        return Results(scenario, spacing, columns, reason)


@dataclass(frozen=True)
class Results:
    """A run, complete or as far as it came.

    Attributes
    ----------
    scenario : what was asked.
    spacing : side of an element [m].
    columns : name -> array with the steps first: `time` [s], `SCALARS` and `FIELDS`.
    stop_reason : `COMPLETED`, `STOPPED`, or why the run had to end early.
    """

    scenario: Scenario
    spacing: float
    columns: dict[str, np.ndarray]
    stop_reason: str = COMPLETED

    def __getattr__(self, name: str) -> np.ndarray:
        try:
            return self.__dict__["columns"][name]
        except KeyError:
            raise AttributeError(f"Results has no {name!r}") from None

    def __len__(self) -> int:
        return len(self.columns["time"])

    @property
    def failed_at(self) -> int | None:
        """Number of the first step that did not converge or that ended the run, or None."""
        failed = np.flatnonzero(self.columns["converged"] == 0)
        if failed.size:
            return int(failed[0])
        return len(self) - 1 if self.stop_reason not in (COMPLETED, STOPPED) else None

    @property
    def adherence_force(self) -> float | None:
        """Force at complete separation minus the least force [N]; None without, or in failure."""
        return None if self.failed_at is not None else key_figures.adherence_force(self.columns)

    @property
    def final_stiffness(self) -> float | None:
        """dF/dd [N/m] over the last tenth of the loading; None if it is too short or failed."""
        top, failed = key_figures.turn(self.columns), self.failed_at
        if top is None or (failed is not None and failed <= top):
            return None
        return key_figures.final_stiffness(self.columns)

    @property
    def avalanches(self) -> np.ndarray:
        """Number of bonds that broke in each event, shape (events,) (see `key_figures`)."""
        return key_figures.avalanches(self.columns)

    @property
    def largest_avalanche(self) -> int:
        """Number of bonds that broke in the largest event."""
        return int(self.avalanches.max(initial=0))

    @property
    def energy(self) -> dict[str, float]:
        """The energy account at the end [J]: work of the drive, where it went, the imbalance."""
        return key_figures.energy_account(self.columns)

    def summary(self) -> dict[str, Any]:
        """The headline figures, SI, as plain values."""
        failed, iterations = self.failed_at, self.columns["iterations"]
        where = None
        if failed is not None:
            where = {
                "step": failed,
                "time": float(self.columns["time"][failed]),
                "indentation": float(self.columns["indentation"][failed]),
            }
        return {
            "steps": len(self),
            "stop_reason": self.stop_reason,
            "failed_at": where,
            "max_force": float(self.columns["contact_force"].max(initial=0.0)),
            "adherence_force": self.adherence_force,
            "final_stiffness": self.final_stiffness,
            "releases": int(self.columns["releases"].sum()),
            "largest_avalanche": self.largest_avalanche,
            "energy": self.energy,
            "iterations_max": int(iterations.max(initial=0)),
            "iterations_mean": float(iterations.mean()) if len(self) else 0.0,
        }

    def to_xarray(self) -> xr.Dataset:
        """Dataset with dimensions time, y, x; units and long_name on every variable."""
        import xarray as xr  # a third of a second that a run without files need not wait for

        ny, nx = self.columns["element_force"].shape[1:]
        middle = {
            "y": (np.arange(ny) + 0.5) * self.spacing,
            "x": (np.arange(nx) + 0.5) * self.spacing,
        }
        dataset = xr.Dataset(
            coords={
                "time": ("time", self.columns["time"], {"units": "s", "long_name": "Time"}),
                "y": ("y", middle["y"], {"units": "m", "long_name": "Element centre, y"}),
                "x": ("x", middle["x"], {"units": "m", "long_name": "Element centre, x"}),
            },
            attrs={
                "title": "tyrecontact run",
                "stop_reason": self.stop_reason,
                "scenario": json.dumps(self.scenario.to_dict()),
            },
        )
        for name, (unit, meaning, _) in {**SCALARS, **FIELDS}.items():
            dimensions = ("time", "y", "x")[: self.columns[name].ndim]
            attributes = {"units": unit, "long_name": meaning}
            dataset[name] = (dimensions, self.columns[name], attributes)
        dataset["state"].attrs["flag_values"] = np.array(list(ElementState), np.int8)
        dataset["state"].attrs["flag_meanings"] = " ".join(s.name.lower() for s in ElementState)
        return dataset
