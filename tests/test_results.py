"""The answer: a labelled data set, a summary, and figures that are None where there are none."""

from __future__ import annotations

import copy
import json
import pickle
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from tyrecontact import Results, Scenario, Simulation
from tyrecontact.contact.bonds import ElementState
from tyrecontact.results import FIELDS, SCALARS, Record

VARIABLES = {
    "indentation": "m",
    "contact_force": "N",
    "drive": "m",
    "iterations": "1",
    "residual": "m",
    "converged": "1",
    "stability_margin": "1",
    "contacts": "1",
    "releases": "1",
    "drive_work": "J",
    "spring_energy": "J",
    "machine_energy": "J",
    "layer_work": "J",
    "released_energy": "J",
    "algorithmic_loss": "J",
    "element_force": "N",
    "compression": "m",
    "displacement": "m",
    "contact_area": "m2",
    "age": "s",
    "state": "1",
}
SUMMARY = {
    "steps", "stop_reason", "failed_at", "max_force", "adherence_force", "final_stiffness",
    "iterations_max", "iterations_mean", "unstable_at", "releases", "largest_avalanche", "energy",
}  # fmt: skip


@pytest.fixture
def results(quick_cycle: Scenario) -> Results:
    return Simulation(quick_cycle).run()


@pytest.fixture
def dataset(results: Results) -> xr.Dataset:
    return results.to_xarray()


def made(scenario: Scenario, **columns: Any) -> Results:
    """Results of 2 x 2 elements with the given columns, zero where not given."""
    steps = len(columns["indentation"])
    full = {"time": np.arange(steps) * 1e-3, "converged": np.ones(steps, np.int8)}
    for name in (*SCALARS, *FIELDS):
        full.setdefault(name, np.zeros((steps, 2, 2) if name in FIELDS else steps))
    return Results(scenario, 1e-3, {**full, **{k: np.asarray(v) for k, v in columns.items()}})


def test_the_data_set_has_the_named_variables_with_unit_and_meaning(dataset: xr.Dataset) -> None:
    assert {str(name): v.attrs["units"] for name, v in dataset.data_vars.items()} == VARIABLES
    assert all(len(v.attrs["long_name"]) > 8 for v in dataset.data_vars.values())


def test_the_data_set_has_dimensions_time_y_x(dataset: xr.Dataset, results: Results) -> None:
    assert dict(dataset.sizes) == {"time": len(results), "y": 6, "x": 6}
    for name in VARIABLES:
        expected = ("time", "y", "x") if name in FIELDS else ("time",)
        assert dataset[name].dims == expected


def test_coordinates_are_times_and_element_centres(dataset: xr.Dataset, results: Results) -> None:
    np.testing.assert_array_equal(dataset["time"], results.time)
    centres = np.array([0.5, 1.5, 2.5, 3.5, 4.5, 5.5]) * 1e-3
    for name, unit in (("time", "s"), ("y", "m"), ("x", "m")):
        assert dataset[name].attrs["units"] == unit
        assert dataset[name].attrs["long_name"]
    np.testing.assert_allclose(dataset["x"], centres, rtol=1e-12)  # a division
    np.testing.assert_allclose(dataset["y"], centres, rtol=1e-12)


def test_scalars_follow_from_the_elements(dataset: xr.Dataset) -> None:
    elements = dataset["element_force"].sum(("y", "x"))
    # sums in another order, of element forces of some N
    np.testing.assert_allclose(dataset["contact_force"], elements, atol=1e-12)
    state = dataset["state"]
    touching = (state == ElementState.COMPRESSED) | (state == ElementState.TENSION)
    np.testing.assert_array_equal(dataset["contacts"], touching.sum(("y", "x")))
    released = (state == ElementState.RELEASED).sum(("y", "x"))
    np.testing.assert_array_equal(dataset["releases"], released)
    assert set(np.unique(state)) == set(ElementState)
    np.testing.assert_array_equal(dataset["element_force"] > 0, state == ElementState.COMPRESSED)
    np.testing.assert_array_equal(dataset["element_force"] < 0, state == ElementState.TENSION)


def test_road_tread_and_springs_fit_together(results: Results) -> None:
    """Indentation and road height are what tread and spring take up, to the residual."""
    tops = Simulation(results.scenario).bodies.tops.reshape(6, 6)
    road = results.indentation[:, None, None] + tops
    gap = np.abs(road - results.displacement - results.compression).max(axis=(1, 2))
    # rounding of lengths of 1e-4 m
    np.testing.assert_allclose(gap, results.residual, atol=1e-18)
    assert gap.max() <= 1e-10 * 100e-6  # tolerance times largest indentation


def held_depth(results: Results) -> np.ndarray:
    """Largest compression of each contact so far [m], nil where there is none."""
    touching = np.isin(results.state, (ElementState.COMPRESSED, ElementState.TENSION))
    depth = np.zeros(results.compression.shape)
    for step in range(1, len(results)):
        reached = np.maximum(depth[step - 1], results.compression[step])
        depth[step] = np.where(touching[step], reached, 0.0)
    return depth


def test_an_adhering_contact_keeps_its_largest_area(results: Results) -> None:
    springs = Simulation(results.scenario).springs
    depth = held_depth(results).reshape(len(results), -1)
    expected = np.pi * np.array([springs.radius(row) for row in depth]) ** 2
    found = results.contact_area.reshape(len(results), -1)
    np.testing.assert_allclose(found, expected, rtol=1e-6)  # single precision
    assert found.max() <= results.spacing**2 * (1 + 1e-6)
    assert np.any(found[results.element_force.reshape(len(results), -1) < 0] > 0)


def test_a_bare_contact_has_the_area_of_its_compression(quick_cycle: Scenario) -> None:
    quick_cycle.adhesion.release_force = 0.0
    run = Simulation(quick_cycle)
    results = run.run()
    depth = np.maximum(results.compression.reshape(len(results), -1), 0.0)
    expected = np.pi * np.array([run.springs.radius(row) for row in depth]) ** 2
    found = results.contact_area.reshape(len(results), -1)
    np.testing.assert_allclose(found, expected, rtol=1e-6)  # single precision
    assert not results.releases.any()


def test_age_is_the_time_since_an_element_came_into_contact(results: Results) -> None:
    touching = np.isin(results.state, (ElementState.COMPRESSED, ElementState.TENSION))
    age, step = np.zeros(touching.shape), results.time[1] - results.time[0]
    for row in range(1, len(results)):
        age[row] = np.where(touching[row], age[row - 1] + step, 0.0)
    np.testing.assert_allclose(results.age, age, rtol=1e-5)  # single precision
    assert results.age.max() > 1e-3


def test_the_account_is_that_of_the_columns(results: Results) -> None:
    account, summary = results.energy, results.summary()
    assert summary["energy"] == account
    assert account["drive_work"] == results.drive_work[-1] > 0
    force, depth = results.contact_force, np.diff(results.indentation, prepend=0.0)
    assert account["drive_work"] == pytest.approx(float(force @ depth), rel=1e-9)  # another order
    assert abs(account["imbalance"]) < 1e-13 * account["drive_work"]  # rounding
    assert summary["releases"] == results.avalanches.sum() == results.releases.sum() > 5
    assert summary["largest_avalanche"] == results.largest_avalanche == results.avalanches.max()


def test_states_can_be_read_by_name(dataset: xr.Dataset) -> None:
    attributes = dataset["state"].attrs
    names = dict(zip(attributes["flag_values"], attributes["flag_meanings"].split(), strict=True))
    assert names == {0: "apart", 1: "compressed", 2: "tension", 3: "released"}


@pytest.mark.parametrize("engine", ["scipy", "netcdf4"])
def test_a_file_gives_back_the_data_and_the_question(
    dataset: xr.Dataset, quick_cycle: Scenario, tmp_path: Path, engine: Any
) -> None:
    if engine == "netcdf4":
        pytest.importorskip("netCDF4")
    dataset.to_netcdf(tmp_path / "run.nc", engine=engine)
    with xr.open_dataset(tmp_path / "run.nc", engine=engine) as found:
        xr.testing.assert_equal(found, dataset)
        assert found["residual"].attrs == dataset["residual"].attrs
        assert found.attrs["stop_reason"] == "completed"
        again = Scenario(**json.loads(found.attrs["scenario"]))
    assert again.to_dict() == quick_cycle.to_dict()


def test_the_summary_has_its_keys_and_is_plain(results: Results) -> None:
    summary = results.summary()
    assert set(summary) == SUMMARY
    assert json.loads(json.dumps(summary, allow_nan=False)) == summary
    assert summary["steps"] == len(results) == len(results.time)
    assert (summary["stop_reason"], summary["failed_at"]) == ("completed", None)
    assert summary["max_force"] == results.contact_force.max()
    assert summary["iterations_max"] == results.iterations.max()
    assert summary["iterations_mean"] == pytest.approx(results.iterations.mean(), rel=1e-12)


def test_failed_at_is_the_first_step_that_did_not_converge(quick: Scenario) -> None:
    found = made(quick, indentation=[0, 1e-6, 2e-6, 3e-6], converged=[1, 1, 0, 0])
    assert found.failed_at == 2
    assert found.summary()["failed_at"] == {"step": 2, "time": 2e-3, "indentation": 2e-6}


def test_adherence_is_the_least_force_of_a_run_that_ends_apart(quick: Scenario) -> None:
    path = {"indentation": [0, 1e-6, 0, -1e-6], "contact_force": [0, 5.0, -3.0, 0]}
    assert made(quick, **path, contacts=[0, 2, 1, 0]).adherence_force == 3
    assert made(quick, **path, contacts=[0, 2, 1, 1]).adherence_force is None
    assert made(quick, **path, contacts=[0, 0, 0, 0]).adherence_force is None
    unsolved = made(quick, **path, contacts=[0, 2, 1, 0], converged=[1, 0, 1, 1])
    assert unsolved.adherence_force is None


def test_no_adherence_is_not_minus_zero(quick: Scenario) -> None:
    path = {"indentation": [0, 1e-6, 0], "contact_force": [0, 5.0, 0], "contacts": [0, 2, 0]}
    assert json.dumps(made(quick, **path).adherence_force) == "0.0"


def test_final_stiffness_is_the_slope_at_the_end_of_the_loading(quick: Scenario) -> None:
    depth = np.concatenate([np.linspace(0, 1e-4, 101), np.linspace(1e-4, 0, 51)])
    force = np.where(depth > 0.9e-4 - 1e-12, 2e6 * (depth - 0.9e-4) + 50, 0.0)
    force[101:] = 0  # unloading must not count
    found = made(quick, indentation=depth, contact_force=force)
    assert found.final_stiffness == pytest.approx(2e6, rel=1e-9)  # a fit of exact points
    unsolved = np.ones(depth.size)
    unsolved[95] = 0
    bad = made(quick, indentation=depth, contact_force=force, converged=unsolved)
    assert bad.final_stiffness is None
    assert made(quick, indentation=[0, 1e-4]).final_stiffness is None


@pytest.mark.parametrize("steps", [0, 1, 2])
def test_a_run_stopped_at_its_beginning_has_a_summary_and_a_data_set(
    quick: Scenario, steps: int
) -> None:
    run = Simulation(quick)
    record = Record(len(run), run.bodies.kernel.shape)
    for step in islice(run, steps):
        record.append(step)
    found = run.collect(record, "stopped by the user")
    assert found.summary()["steps"] == found.to_xarray().sizes["time"] == steps
    assert found.summary()["final_stiffness"] is None
    assert found.failed_at is None
    json.dumps(found.summary(), allow_nan=False)


def test_rows_are_readable_while_the_run_goes_on(quick: Scenario) -> None:
    run = Simulation(quick)
    record = Record(len(run), run.bodies.kernel.shape)
    kept = []
    for step in islice(run, 10):
        record.append(step)
        assert record.columns["contact_force"][record.count - 1] == step.contact_force
        kept.append(run.collect(record))
    for count, results in enumerate(kept, 1):  # later steps did not reach them
        np.testing.assert_array_equal(results.contact_force, kept[-1].contact_force[:count])


def test_results_are_copied_and_pickled_and_know_their_names(results: Results) -> None:
    for other in (copy.deepcopy(results), pickle.loads(pickle.dumps(results))):
        assert other.summary() == results.summary()
        xr.testing.assert_identical(other.to_xarray(), results.to_xarray())
    with pytest.raises(AttributeError, match="'forces'"):
        _ = results.forces
