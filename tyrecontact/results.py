"""The answer: steps as they come, and all of them together."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from tyrecontact import key_figures
from tyrecontact.dataset import dataset
from tyrecontact.errors import InputError
from tyrecontact.fields import FieldTable, Moment, nearest
from tyrecontact.parts.process import Numerics
from tyrecontact.scenario import Scenario
from tyrecontact.steps import FIELDS, SCALARS, Step

if TYPE_CHECKING:
    import xarray as xr

#: how a run ends that did not fail; who else stops one says "stopped ..." as well, and why
COMPLETED, STOPPED = "completed", "stopped by the user"
#: for the fields of a run, unless its scenario says otherwise [B]
FIELD_MEMORY: float = Numerics().field_memory


class Record:
    """Rows of a run: every number of every step, and fields as far as memory is given for them.

    One thread appends and others may look on: what was recorded at a moment takes the place of
    the moment before in one assignment, after its rows are written.

    Parameters
    ----------
    steps : of the complete run.  shape : of its elements, (ny, nx).
    field_memory : for the fields [B]; a run that has more keeps those of every 2nd, 4th, ...
        step and of the last (see `fields`).

    Attributes
    ----------
    count : number of steps recorded.
    columns : name -> array. Of `time` and `SCALARS` row n is step n; of `FIELDS` it is step
        n x `field_stride`. Rows from `count` on are not written yet.
    field_stride : steps from one row of the fields to the next; 1 as long as all of them fit.
    stop_reason : why the run ended early, or empty.
    """

    def __init__(
        self, steps: int, shape: tuple[int, int], field_memory: float = FIELD_MEMORY
    ) -> None:
        self.stop_reason = ""
        self._numbers = {"time": np.zeros(steps)}
        for name, (_, _, kind) in SCALARS.items():
            self._numbers[name] = np.zeros(steps, kind)
        self._now = Moment(0, FieldTable.empty(steps, shape, field_memory))

    @property
    def count(self) -> int:
        return self._now.count

    @property
    def columns(self) -> dict[str, np.ndarray]:
        return {**self._numbers, **self._now.table.columns}

    @property
    def field_stride(self) -> int:
        return self._now.table.stride

    def append(self, step: Step) -> None:
        now = self._now
        for name, column in self._numbers.items():
            column[now.count] = getattr(step, name)
        self.stop_reason = step.stop_reason
        final = bool(step.stop_reason) or now.count + 1 == len(self._numbers["time"])
        self._now = now.after(step, final)

    def fields(self, step: int) -> tuple[int, dict[str, np.ndarray]]:
        """Fields of a step, or of the nearest one kept: its number; name -> shape (ny, nx).

        -1 is the last step, whose fields are always there. IndexError : no such step.
        """
        return self._now.near(step)

    def history(self, name: str, row: int, column: int) -> tuple[np.ndarray, np.ndarray]:
        """One element through the run: numbers of the steps whose fields are kept, the last one
        included, and the values of a field there; shape (rows,) each.
        """
        return self._now.history(name, row, column)

    def maps(self) -> dict[str, np.ndarray]:
        """Name -> all maps kept, shape (rows, ny, nx), not copied; the last may be missing."""
        now = self._now
        rows = len(now.table.steps(now.count))
        return {name: column[:rows] for name, column in now.table.columns.items()}

    def results(self, scenario: Scenario, spacing: float, stop_reason: str = "") -> Results:
        """What was recorded so far; later rows do not reach it."""
        now = self._now  # once: a thread may be replacing it
        columns = {name: column[: now.count] for name, column in self._numbers.items()}
        columns.update(now.columns())
        reason = stop_reason or self.stop_reason or COMPLETED
        kept = None if now.table.stride == 1 else now.steps()
        return Results(scenario, spacing, columns, reason, kept)


@dataclass(frozen=True)
class Results:
    """A run, complete or as far as it came.

    Attributes
    ----------
    scenario : what was asked.
    spacing : side of an element [m].
    columns : name -> array with the steps first: `time` [s], `SCALARS` and `FIELDS`.
    stop_reason : `COMPLETED`, `STOPPED`, or why the run had to end early.
    kept : numbers of the steps that the rows of `FIELDS` belong to, shape (rows,), in a run that
        has more fields than `numerics.field_memory` takes; None where each step has its row.
        `fields(step)` finds the row.
    """

    scenario: Scenario
    spacing: float
    columns: dict[str, np.ndarray]
    stop_reason: str = COMPLETED
    kept: np.ndarray | None = None

    def __getattr__(self, name: str) -> np.ndarray:
        try:
            column: np.ndarray = self.__dict__["columns"][name]
        except KeyError:
            raise AttributeError(f"Results has no {name!r}") from None
        if name in FIELDS and self.kept is not None:
            # row n is not step n, which nobody would see from the numbers
            raise InputError(
                f"results.{name} must have a map for every step, got {len(column)} of "
                f"{len(self)}: ask results.fields(step), take results.columns[{name!r}] with "
                "results.field_steps, or raise numerics.field_memory"
            )
        return column

    def __len__(self) -> int:
        return len(self.columns["time"])

    @property
    def field_steps(self) -> np.ndarray:
        """Numbers of the steps whose fields are kept, shape (rows,)."""
        return np.arange(len(self)) if self.kept is None else self.kept

    def fields(self, step: int) -> tuple[int, dict[str, np.ndarray]]:
        """Fields of a step, or of the nearest one kept: its number; name -> shape (ny, nx).

        -1 is the last step, whose fields are always there. IndexError : no such step.
        """
        row, number = nearest(self.field_steps, step, len(self))
        return number, {name: self.columns[name][row] for name in FIELDS}

    @property
    def failed_at(self) -> int | None:
        """Number of the first step that did not converge or that ended the run, or None."""
        failed = np.flatnonzero(self.columns["converged"] == 0)
        if failed.size:
            return int(failed[0])
        ended_well = self.stop_reason.startswith((COMPLETED, "stopped "))
        return None if ended_well else len(self) - 1

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
        """Dataset with dimensions time, y, x; units and long_name on every variable.

        Fields that are not kept of all steps have the dimension field_time in the place of time,
        and `field_step` numbers their steps: nothing is filled up with what was not kept.
        """
        found = dataset(self.columns, self.spacing, self.kept).assign_attrs(
            stop_reason=self.stop_reason, scenario=json.dumps(self.scenario.to_dict())
        )
        found["drive"].attrs["units"] = "N" if self.scenario.loading.drive == "force" else "m"
        return found
