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
from tyrecontact.steps import FIELDS, SCALARS, Step

if TYPE_CHECKING:
    import xarray as xr

#: how a run ends that did not fail
COMPLETED, STOPPED = "completed", "stopped by the user"
#: a run that keeps more than this is refused before it starts
MAX_BYTES = 4_000_000_000


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
    def unstable_at(self) -> int | None:
        """Number of the first step from which the time stepping may blow up, or None."""
        return key_figures.first_unstable(self.columns)

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
        iterations = self.columns["iterations"]
        return {
            "steps": len(self),
            "stop_reason": self.stop_reason,
            "failed_at": self._place(self.failed_at),
            "unstable_at": self._place(self.unstable_at),
            "max_force": float(self.columns["contact_force"].max(initial=0.0)),
            "adherence_force": self.adherence_force,
            "final_stiffness": self.final_stiffness,
            "releases": int(self.columns["releases"].sum()),
            "largest_avalanche": self.largest_avalanche,
            "energy": self.energy,
            "iterations_max": int(iterations.max(initial=0)),
            "iterations_mean": float(iterations.mean()) if len(self) else 0.0,
        }

    def _place(self, step: int | None) -> dict[str, Any] | None:
        if step is None:
            return None
        found = {name: float(self.columns[name][step]) for name in ("time", "indentation")}
        return {"step": step, **found}

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
        dataset["drive"].attrs["units"] = "N" if self.scenario.loading.drive == "force" else "m"
        dataset["state"].attrs["flag_values"] = np.array(list(ElementState), np.int8)
        dataset["state"].attrs["flag_meanings"] = " ".join(s.name.lower() for s in ElementState)
        return dataset
