"""Files of a run read back as the run."""

from __future__ import annotations

import io
import json
import tomllib
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from app import exports
from app.runner import Run
from tyrecontact import Results, Scenario, Simulation
from tyrecontact.steps import SCALARS


@pytest.fixture
def results(finished: Run) -> Results:
    found = finished.results()
    assert found is not None
    return found


def comments(text: str) -> list[str]:
    return [line.removeprefix("#").strip() for line in text.splitlines() if line.startswith("#")]


def test_netcdf_reads_back_as_the_run(results: Results, small: Scenario) -> None:
    with xr.open_dataset(io.BytesIO(exports.netcdf(results)), engine="scipy") as found:
        xr.testing.assert_identical(found.load(), results.to_xarray())
        assert json.loads(found.attrs["scenario"]) == small.to_dict()


def test_netcdf_of_a_run_whose_maps_are_thinned_reads_back(small: Scenario) -> None:
    small.numerics.field_memory = 10 * 36 * 33
    results = Simulation(small).run()
    with xr.open_dataset(io.BytesIO(exports.netcdf(results)), engine="scipy") as found:
        xr.testing.assert_identical(found.load(), results.to_xarray())


def test_csv_is_read_by_pandas_and_numpy_to_the_last_digit(results: Results) -> None:
    text = exports.csv("default", results)
    table = pd.read_csv(io.StringIO(text), comment="#")
    assert len(table) == len(results)
    # pandas may read a number as its neighbour
    np.testing.assert_allclose(table["contact_force [N]"], results.contact_force, rtol=4e-16)
    np.testing.assert_array_equal(table["converged"], results.converged)
    assert len(table.columns) == len(SCALARS) + 2
    array = np.genfromtxt(io.StringIO(text), delimiter=",", names=True)
    np.testing.assert_array_equal(array["contact_force_N"], results.contact_force)
    np.testing.assert_array_equal(array["step"], np.arange(len(results)))


def test_csv_tells_meanings_and_the_scenario(results: Results, small: Scenario) -> None:
    said = comments(exports.csv("default", results))
    assert "contact_force [N]: Total contact force, positive when pressing" in said
    assert "drive [m]: " + SCALARS["drive"][1] in said
    begin = said.index("The scenario, for tyrecontact run FILE.toml:") + 1
    tables = tomllib.loads("\n".join(said[begin:]))
    assert tables.pop("preset") == "default"
    assert Scenario(**tables).to_dict() == small.to_dict()


def test_a_force_that_is_given_is_in_newton(results: Results) -> None:
    scenario = results.scenario.copy()
    scenario.loading.drive = "force"
    assert "drive [N]" in exports.csv("default", replace(results, scenario=scenario))


def test_a_run_that_was_stopped_before_its_first_step_has_a_head_and_no_rows(
    results: Results,
) -> None:
    none = replace(results, columns={name: c[:0] for name, c in results.columns.items()})
    text = exports.csv("default", none)
    assert text.startswith("step,time [s],indentation [m],")
    assert len(pd.read_csv(io.StringIO(text), comment="#")) == 0
    with xr.open_dataset(io.BytesIO(exports.netcdf(none)), engine="scipy") as found:
        assert found.sizes["time"] == 0


def test_no_folder_of_the_server_is_told(results: Results) -> None:
    scenario = results.scenario.copy()
    scenario.road.file = "/tmp/secret/A12.npy"
    own = replace(results, scenario=scenario)
    assert "secret" not in exports.csv("default", own)
    assert 'file = "A12.npy"' in exports.csv("default", own)
    assert b"secret" not in exports.netcdf(own)
    assert b"A12.npy" in exports.netcdf(own)
    assert own.scenario.road.file == "/tmp/secret/A12.npy"


def test_names_of_files_say_what_and_when() -> None:
    when = datetime(2025, 6, 1, 14, 30, 5, tzinfo=UTC)
    assert exports.file_name("default", "nc", when) == "tyrecontact-default-20250601-143005.nc"
    assert exports.file_name("fig-44/14-N", "csv", when) == (
        "tyrecontact-fig-44-14-N-20250601-143005.csv"
    )
    assert exports.file_name("x/../=y", "toml", when).startswith("tyrecontact-x-y-2025")
    assert exports.file_name("default", "nc").endswith(".nc")
