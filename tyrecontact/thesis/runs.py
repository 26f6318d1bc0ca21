"""One run of the campaign: only the numbers of each step, and no step more than is needed."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tyrecontact.results import Record, Results
from tyrecontact.scenario import Scenario
from tyrecontact.simulation import Simulation
from tyrecontact.steps import SCALARS, Step

if TYPE_CHECKING:
    import xarray as xr

#: what the figures and the findings need of each step, beside the time
KEPT = (
    "indentation",
    "contact_force",
    "iterations",
    "residual",
    "converged",
    "stability_margin",
    "contacts",
    "releases",
)
#: steps of a run that go on after the first that failed: enough to see the force shoot up
AFTER_FAILURE = 300


def run(settings: Mapping[str, Any]) -> Results:
    """Results, without fields, of the scenario with these settings (`Scenario.to_dict`)."""
    simulation = Simulation(Scenario(**settings))
    record = Record(len(simulation), simulation.bodies.kernel.shape, field_memory=0.0)
    for step in _needed(simulation):
        record.append(step)
    whole = simulation.collect(record)
    columns = {name: whole.columns[name] for name in ("time", *KEPT)}
    return Results(whole.scenario, whole.spacing, columns, whole.stop_reason)


def _needed(simulation: Simulation) -> Iterator[Step]:
    """Steps until road and tread have parted, or until the failure has been seen."""
    touched, failed = False, 0
    for step in simulation:
        yield step
        touched = touched or step.contacts > 0
        failed += bool(failed or not step.converged)
        if failed > AFTER_FAILURE or (touched and step.contacts == 0):
            return


def to_dataset(results: Results) -> xr.Dataset:
    """The run as a dataset along time, with units."""
    import xarray as xr  # a third of a second that importing the package need not take

    time = ("time", results.time, {"units": "s", "long_name": "Time"})
    attributes = {
        "title": "tyrecontact run",
        "stop_reason": results.stop_reason,
        "scenario": json.dumps(results.scenario.to_dict()),
        "spacing": results.spacing,
    }
    dataset = xr.Dataset(coords={"time": time}, attrs=attributes)
    for name in KEPT:
        unit, meaning, kind = SCALARS[name]
        column = results.columns[name].astype(kind)
        dataset[name] = ("time", column, {"units": unit, "long_name": meaning})
    return dataset


def read(path: Path) -> Results:
    """A run that was written as netCDF."""
    import xarray as xr

    with xr.open_dataset(path) as dataset:
        columns = {name: dataset[name].to_numpy() for name in ("time", *KEPT)}
        scenario = Scenario(**json.loads(dataset.attrs["scenario"]))
        spacing, reason = float(dataset.attrs["spacing"]), str(dataset.attrs["stop_reason"])
    return Results(scenario, spacing, columns, reason)
