"""Fields of a long run: bounded memory, an even stride, both ends, and readers undisturbed."""

from __future__ import annotations

import json
import sys
import threading
import tracemalloc
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from tyrecontact import Scenario, Simulation
from tyrecontact.errors import InputError
from tyrecontact.fields import FieldTable, nearest
from tyrecontact.results import FIELDS, SCALARS, Record, Results
from tyrecontact.steps import Step

SHAPE = (4, 5)
#: bytes of the fields of one step: 33 B an element
ROW = 33 * 4 * 5


def step(index: int) -> Step:
    """A step all of whose numbers and maps tell its own number."""
    numbers = dict.fromkeys(SCALARS, index)
    numbers["converged"] = 1
    maps = {name: np.full(SHAPE, index % 100, kind) for name, (*_, kind) in FIELDS.items()}
    for name in ("element_force", "compression"):
        maps[name] = np.full(SHAPE, float(index))
    return Step(index=index, time=index * 1e-3, **numbers, **maps)  # type: ignore[arg-type]


def recorded(steps: int, rows: int, of: int | None = None) -> Record:
    """A record of some steps `of` a run, with memory for some rows of fields."""
    record = Record(of or steps, SHAPE, rows * ROW)
    for index in range(steps):
        record.append(step(index))
    return record


def collected(record: Record) -> Results:
    return record.results(Scenario(), 1e-3)


@pytest.fixture
def thin(quick_cycle: Scenario) -> Results:
    """The quick cycle with memory for the fields of 50 of its 211 steps."""
    quick_cycle.numerics.field_memory = 50 * 36 * 33.0
    return Simulation(quick_cycle).run()


@pytest.mark.parametrize("rows", [2, 3, 7, 8])
def test_at_every_moment_first_and_last_are_there_at_an_even_stride(rows: int) -> None:
    record = Record(100, SHAPE, rows * ROW)
    for index in range(100):
        record.append(step(index))
        found = collected(record)
        kept = found.field_steps
        assert (kept[0], kept[-1]) == (0, index)
        assert len(set(np.diff(kept[:-1]))) <= 1
        # never fewer than half of what fits, the last one beside them
        assert min(index + 1, rows / 2) <= len(kept) <= rows + 1
        np.testing.assert_array_equal(found.columns["element_force"][:, 0, 0], kept)
        np.testing.assert_array_equal(found.columns["compression"][:, 3, 4], kept)
        np.testing.assert_array_equal(found.columns["state"][:, 1, 2], kept % 100)
        np.testing.assert_array_equal(found.contact_force, np.arange(index + 1))


def test_what_fits_is_kept_as_it_is_without_a_copy() -> None:
    record = recorded(8, 8)
    found = collected(record)
    assert found.kept is None
    assert record.field_stride == 1
    np.testing.assert_array_equal(found.field_steps, np.arange(8))
    for name in FIELDS:
        assert found.columns[name].shape == (8, *SHAPE)
        assert np.shares_memory(found.columns[name], record.columns[name])


@pytest.mark.parametrize("rows", [2, 3, 7, 8])
@pytest.mark.parametrize("steps", [9, 15, 16, 17, 31, 50])
def test_a_run_at_its_end_is_handed_out_without_a_copy(rows: int, steps: int) -> None:
    whole = recorded(steps, rows)
    broken = Record(100, SHAPE, rows * ROW)
    for index in range(steps):
        broken.append(replace(step(index), stop_reason="broken" if index == steps - 1 else ""))
    for record in (whole, broken):
        found = collected(record)
        assert np.shares_memory(found.columns["age"], record.columns["age"])
        assert found.field_steps[-1] == steps - 1
        np.testing.assert_array_equal(found.columns["element_force"][:, 0, 0], found.field_steps)
        assert record.fields(-1)[0] == steps - 1
        assert np.all(record.fields(-1)[1]["element_force"] == steps - 1)
    left = recorded(steps, rows, of=100)  # more might come
    np.testing.assert_array_equal(collected(left).field_steps, collected(whole).field_steps)
    np.testing.assert_array_equal(collected(left).columns["age"], collected(whole).columns["age"])


@pytest.mark.parametrize("memory", [0.0, 1.0, 2 * ROW])
def test_without_memory_the_first_and_the_last_are_kept(memory: float) -> None:
    record = Record(1000, SHAPE, memory)
    for index in range(777):
        record.append(step(index))
    found = collected(record)
    assert {0, 776} <= set(found.field_steps)
    assert len(found.field_steps) <= 3
    assert len(found.time) == 777


def test_memory_does_not_grow_with_the_length_of_a_run() -> None:
    budget, steps = 1_000_000, 20_000
    made = step(0)
    tracemalloc.start()
    record = Record(steps, SHAPE, budget)
    for _ in range(steps):
        record.append(made)
    results = collected(record)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    fields = sum(record.columns[name].nbytes for name in FIELDS)
    numbers = sum(record.columns[name].nbytes for name in ("time", *SCALARS))
    # of 13 MB that there were; a row for the last step beside them
    assert fields <= budget + ROW < steps * ROW / 10
    # old and new rows while they are thinned, or rows and what was collected of them
    assert peak < 2 * budget + numbers + 100_000
    assert sum(results.columns[name].nbytes for name in FIELDS) <= budget + ROW


def test_what_was_collected_is_not_changed_by_later_steps() -> None:
    record, kept = Record(300, SHAPE, 8 * ROW), []
    for index in range(300):
        record.append(step(index))
        kept.append(collected(record))
    for index, found in enumerate(kept):
        assert len(found) == index + 1
        np.testing.assert_array_equal(found.columns["element_force"][:, 0, 0], found.field_steps)


@pytest.fixture
def _switching_often() -> Iterator[None]:
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


@pytest.mark.usefixtures("_switching_often")
def test_a_reader_never_sees_rows_half_thinned() -> None:
    steps = [step(index) for index in range(3000)]
    record, wrong, looks = Record(len(steps), SHAPE, 8 * ROW), [], 0
    record.append(steps[0])

    def write() -> None:
        for made in steps[1:]:
            record.append(made)

    writer = threading.Thread(target=write)
    writer.start()
    while writer.is_alive():
        wanted = record.count // 2
        number, fields = record.fields(wanted)
        _, last = record.fields(-1)
        found = collected(record)
        good = (
            np.all(fields["element_force"] == number)
            and np.ptp(last["element_force"]) == 0
            and last["element_force"][0, 0] >= wanted
            and np.array_equal(found.columns["element_force"][:, 0, 0], found.field_steps)
            and np.array_equal(found.columns["compression"][:, 3, 4], found.field_steps)
            and np.array_equal(found.contact_force, np.arange(len(found)))
            and found.field_steps[-1] == len(found) - 1
        )
        looks += 1
        if not good:
            wrong.append((wanted, number))
    writer.join()
    assert looks > 3
    assert wrong == []


def test_the_fields_of_a_step_are_those_of_the_nearest_kept() -> None:
    record = recorded(30, 8)  # of the steps 0, 4, .. 28, and 29
    for source in (record, collected(record)):
        for wanted, number in ((0, 0), (9, 8), (11, 12), (28, 28), (29, 29), (-1, 29), (-30, 0)):
            found, fields = source.fields(wanted)
            assert found == number
            assert set(fields) == set(FIELDS)
            assert np.all(fields["element_force"] == number)
        with pytest.raises(IndexError):
            source.fields(30)
    with pytest.raises(IndexError):
        Record(3, SHAPE).fields(-1)
    assert nearest(np.array([0, 4, 5]), 2, 6) == (0, 0)


def test_the_history_of_an_element_goes_to_the_last_step() -> None:
    for steps, kept in ((30, [0, 4, 8, 12, 16, 20, 24, 28, 29]), (29, list(range(0, 29, 4)))):
        for record in (recorded(steps, 8), recorded(steps, 8, of=100)):
            numbers, force = record.history("element_force", 3, 1)
            np.testing.assert_array_equal(numbers, kept)
            np.testing.assert_array_equal(force, kept)
    numbers, age = Record(3, SHAPE).history("age", 0, 0)
    assert (numbers.size, age.size) == (0, 0)


def test_all_maps_kept_are_handed_out_without_a_copy() -> None:
    record = recorded(29, 8, of=100)
    maps = record.maps()
    np.testing.assert_array_equal(maps["element_force"][:, 2, 2], np.arange(0, 29, 4))
    assert np.shares_memory(maps["age"], record.maps()["age"])
    assert all(len(kept) == 0 for kept in Record(3, SHAPE).maps().values())


def test_numbers_and_key_figures_do_not_know_that_fields_were_thinned(
    thin: Results, quick_cycle: Scenario
) -> None:
    quick_cycle.numerics.field_memory = 100e6
    whole = Simulation(quick_cycle).run()
    assert whole.kept is None
    assert thin.summary() == whole.summary()
    assert thin.releases.sum() > 5
    kept = thin.field_steps
    assert 25 <= len(kept) <= 51
    for name in FIELDS:
        np.testing.assert_array_equal(thin.columns[name], whole.columns[name][kept])
    for name in ("time", *SCALARS):
        np.testing.assert_array_equal(thin.columns[name], whole.columns[name])


def test_the_data_set_has_its_own_times_for_fields(thin: Results) -> None:
    dataset = thin.to_xarray()
    kept = thin.field_steps
    assert dict(dataset.sizes) == {"time": len(thin), "field_time": len(kept), "y": 6, "x": 6}
    np.testing.assert_array_equal(dataset["field_time"], thin.time[kept])
    np.testing.assert_array_equal(dataset["field_step"], kept)
    for name in FIELDS:
        assert dataset[name].dims == ("field_time", "y", "x")
        assert not dataset[name].isnull().any()
    for name in SCALARS:
        assert dataset[name].dims == ("time",)
    total = dataset["element_force"].sum(("y", "x"))
    there = dataset["contact_force"].sel(time=dataset["field_time"].to_numpy())
    # sums in another order, of element forces of some N
    np.testing.assert_allclose(total, there, atol=1e-12)
    for coordinate in ("field_time", "field_step"):
        assert {"units", "long_name"} <= set(dataset[coordinate].attrs)


def test_a_map_is_not_taken_for_that_of_another_step(thin: Results) -> None:
    """Row n of thinned fields is not step n."""
    with pytest.raises(InputError, match=r"results\.element_force must have a map for every step"):
        _ = thin.element_force
    assert thin.columns["element_force"].shape[0] == thin.field_steps.size < len(thin)


@pytest.mark.parametrize("engine", ["scipy", "netcdf4"])
def test_a_file_gives_back_thinned_fields(thin: Results, tmp_path: Path, engine: str) -> None:
    if engine == "netcdf4":
        pytest.importorskip("netCDF4")
    dataset = thin.to_xarray()
    dataset.to_netcdf(tmp_path / "run.nc", engine=engine)  # type: ignore[call-overload]
    with xr.open_dataset(tmp_path / "run.nc", engine=engine) as found:
        xr.testing.assert_equal(found, dataset)
        assert found["field_step"].attrs == dataset["field_step"].attrs
        asked = json.loads(found.attrs["scenario"])
    assert asked["numerics"]["field_memory"] == thin.scenario.numerics.field_memory


def test_a_table_takes_no_memory_that_it_has_no_use_for() -> None:
    assert len(FieldTable.empty(10, SHAPE, 1e9).columns["age"]) == 10
    assert len(FieldTable.empty(10_000, SHAPE, 100.5 * ROW).columns["age"]) == 100 + 1
    bytes_of_a_row = sum(c.nbytes for c in FieldTable.empty(1, SHAPE, 1e9).columns.values())
    assert bytes_of_a_row == ROW
