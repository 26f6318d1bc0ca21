"""Pinned runs: what is kept, how they are called, and what differs between them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from app.runner import Run
from app.setting_words import label, preset_of, with_unit
from app.shelf import LOOKS, MOST, THIS_RUN, Shelf
from tyrecontact import Scenario, presets
from tyrecontact.errors import InputError
from tyrecontact.steps import FIELDS

Make = Callable[..., Run]


@pytest.fixture
def make(small: Scenario) -> Make:
    """A run of the small scenario with other settings, ended."""

    def made(**settings: object) -> Run:
        scenario = small.copy()
        for path, value in settings.items():
            scenario.set(path.replace("__", "."), value)
        run = Run(scenario)
        run.start()
        assert run.join(60)
        return run

    return made


def test_numbers_are_kept_and_maps_are_not(finished: Run) -> None:
    pin = Shelf().pin(finished, "a run")
    assert finished.record is not None
    assert pin.steps == pin.total == finished.record.count
    assert pin.remark == ""
    assert not set(FIELDS) & set(pin.results.columns)
    force = finished.record.columns["contact_force"]
    assert np.array_equal(pin.results.contact_force, force)
    assert not np.shares_memory(pin.results.contact_force, force)


def test_a_run_that_goes_on_is_pinned_as_far_as_it_has_come(
    small: Scenario, wait_for: Callable
) -> None:
    run, shelf = Run(small, paused=True), Shelf()
    run.start()
    wait_for(lambda: run.paused and run.record is not None)
    with pytest.raises(InputError, match="must have a step, got none"):
        shelf.pin(run)
    for steps in (1, 2):
        run.step()
        wait_for(lambda steps=steps: run.record.count == steps)
    pin = shelf.pin(run, "early")
    assert pin.remark == "so far 2 of 52 steps"
    assert not pin.ended
    run.resume()
    assert run.join(60)
    assert pin.steps == 2
    again = shelf.pin(run)
    assert (again.label, again.look, again.remark) == ("early", pin.look, "")
    assert shelf.pinned == (again,)


def test_a_run_that_was_stopped_says_where(small: Scenario, wait_for: Callable) -> None:
    run = Run(small, paused=True)
    run.start()
    wait_for(lambda: run.paused and run.record is not None)
    run.step()
    wait_for(lambda: run.record.count == 1)
    run.stop()
    assert run.join(60)
    assert Shelf().pin(run).remark == "ended after 1 of 52 steps"


def test_labels_say_what_differs_from_the_first(make: Make) -> None:
    shelf = Shelf()
    first = shelf.pin(make(), "base")
    assert first.label == "base"
    assert shelf.pin(make(adhesion__release_force=0.3)).label == "0.3 N"
    assert shelf.pin(make(numerics__time_resolution_factor=2)).label == "factor 2"
    assert shelf.pin(make(loading__rate=0.2, road__seed=2)).label == "Seed 2, 200 mm/s"
    assert shelf.pin(make(springs__exchange_count=3), " 0.3  N ").label == "0.3 N (2)"


def test_a_preset_is_called_by_its_name() -> None:
    assert label(presets.get("adhesion"), presets.get("default")) == "adhesion"
    assert preset_of(presets.get("thesis-factor-2")) == "thesis-factor-2"
    sticky = presets.get("adhesion")
    sticky.adhesion.release_force = 0.3
    assert preset_of(sticky) == ""
    assert label(sticky, presets.get("default")) == "adhesion, 0.3 N"
    assert label(presets.get("thesis-factor-4"), presets.get("thesis-instability")) == "factor 4"


@pytest.mark.parametrize(
    ("path", "value", "shown"),
    [
        ("loading.max_indentation", 0.2e-3, "0.2 mm"),
        ("loading.acceleration", 9.0, "9 m/s²"),
        ("numerics.tolerance", 1e-10, "1e−10"),
        ("springs.exchange_count", 80, "80 springs"),
        ("road.file", "/srv/private/scan.npy", "scan.npy"),
        ("tread.layers", [], "none"),
    ],
)
def test_values_have_their_unit(path: str, value: object, shown: str) -> None:
    assert with_unit(Scenario().find(path)[1], value) == shown


def test_only_what_differs_is_listed(make: Make) -> None:
    shelf = Shelf()
    shelf.pin(make(), "a")
    shelf.pin(make(adhesion__release_force=0.3), "b")
    (row,) = shelf.differences()
    assert (row.name, row.values) == ("Adhesion: Release criterion", ("0.6 N", "0.3 N"))
    rows = shelf.differences(make(loading__rate=0.2))
    assert [row.values for row in rows] == [
        ("100 mm/s", "100 mm/s", "200 mm/s"), ("0.6 N", "0.3 N", "0.6 N"),
    ]  # fmt: skip


def test_a_part_is_named_once(make: Make) -> None:
    shelf = Shelf()
    shelf.pin(make(loading__profile="quadratic", springs__exchange_count=2))
    names = [row.name for row in shelf.differences(make(road__seed=3))]
    assert names == ["Road: Seed", "Spring exchange", "Loading profile"]


def test_key_figures_have_units_and_a_dash_where_there_is_none(make: Make) -> None:
    shelf = Shelf()
    pin = shelf.pin(make())
    found = {row.name: row.values[0] for row in shelf.key_figures()}
    assert found["Peak force"] == f"{pin.results.contact_force.max():#.3g} N"
    assert found["Adherence force"] == found["First failed step"] == "–"
    assert found["Final stiffness"].endswith(" MN/m")
    assert found["Energy released"].endswith("0 mJ")


def test_the_run_on_show_is_compared_unless_it_is_pinned(make: Make) -> None:
    shelf, run = Shelf(), make()
    assert shelf.with_run(None) == ()
    (shown,) = shelf.with_run(run)
    assert (shown.label, shown.look) == ("this run", THIS_RUN)
    pin = shelf.pin(run)
    assert shelf.with_run(run) == (pin,)
    assert shelf.with_run(make()) == (pin,)


def test_there_is_room_for_a_few(make: Make) -> None:
    shelf, runs = Shelf(), [make(road__seed=seed) for seed in range(2, MOST + 3)]
    for run in runs[:MOST]:
        shelf.pin(run)
    assert [pin.look for pin in shelf.pinned] == list(LOOKS)
    assert len({THIS_RUN, *LOOKS}) == MOST + 1
    with pytest.raises(InputError, match=f"at most {MOST}, got one more: unpin one"):
        shelf.pin(runs[MOST])
    shelf.pin(runs[0])
    freed = shelf.pinned[2]
    shelf.unpin(freed.label)
    assert shelf.pin(runs[MOST]).look == freed.look


def test_runs_are_renamed_and_let_go(make: Make) -> None:
    shelf, told = Shelf(), []
    shelf.watch(lambda: told.append(len(shelf.pinned)))
    shelf.pin(make(), "a")
    shelf.pin(make(road__seed=2), "b")
    shelf.rename("a", "  stiff   road ")
    assert [pin.label for pin in shelf.pinned] == ["stiff road", "b"]
    for new, why in (("b", "unlike those"), (" ", "1 to 40 characters, got 0"), ("x" * 41, "41")):
        with pytest.raises(InputError, match=why):
            shelf.rename("stiff road", new)
    with pytest.raises(InputError, match=r"one of the pinned runs \(stiff road, b\), got 'a'"):
        shelf.unpin("a")
    shelf.unpin("b")
    shelf.clear()
    assert told == [1, 2, 2, 1, 0]
