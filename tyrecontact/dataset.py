"""Columns of a run as an xarray data set: dimensions, coordinates, units and meanings."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tyrecontact.contact.bonds import ElementState
from tyrecontact.steps import FIELDS, SCALARS

if TYPE_CHECKING:
    import xarray as xr


def dataset(
    columns: Mapping[str, np.ndarray], spacing: float, kept: np.ndarray | None
) -> xr.Dataset:
    """Data set of the columns of `Results`.

    Parameters
    ----------
    columns : `time` [s], `SCALARS` and `FIELDS`, the steps first.
    spacing : side of an element [m].
    kept : numbers of the steps that the rows of `FIELDS` belong to, or None: to each its own.
    """
    import xarray as xr  # a third of a second that a run without files need not wait for

    made = xr.Dataset(coords=_coordinates(columns, spacing), attrs={"title": "tyrecontact run"})
    if kept is not None:
        made = made.assign_coords(_field_times(columns["time"], kept))
    at = "time" if kept is None else "field_time"
    for name, (unit, meaning, _) in {**SCALARS, **FIELDS}.items():
        dimensions = (at, "y", "x") if name in FIELDS else ("time",)
        made[name] = (dimensions, columns[name], {"units": unit, "long_name": meaning})
    made["state"].attrs["flag_values"] = np.array(list(ElementState), np.int8)
    made["state"].attrs["flag_meanings"] = " ".join(s.name.lower() for s in ElementState)
    return made


def _coordinates(columns: Mapping[str, np.ndarray], spacing: float) -> dict[str, Any]:
    found: dict[str, Any] = {"time": ("time", columns["time"], {"units": "s", "long_name": "Time"})}
    for axis, count in zip("yx", columns["element_force"].shape[1:], strict=True):
        middle, meaning = (np.arange(count) + 0.5) * spacing, f"Element centre, {axis}"
        found[axis] = (axis, middle, {"units": "m", "long_name": meaning})
    return found


def _field_times(time: np.ndarray, kept: np.ndarray) -> dict[str, Any]:
    number, meaning = kept.astype(np.int32), "Time, where fields were kept"
    return {
        "field_time": ("field_time", time[kept], {"units": "s", "long_name": meaning}),
        "field_step": (
            "field_time", number, {"units": "1", "long_name": "Number of the step, from 0"}
        ),
    }  # fmt: skip
