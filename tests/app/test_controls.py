"""The form is made from the declarations, and form and scenario stay equal."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from app.controls import GROUPS, MAIN, OF_FILES, OF_ROAD_FILE, Controls
from tyrecontact import presets
from tyrecontact.settings import Text


@pytest.fixture
def refusals() -> list[str]:
    return []


@pytest.fixture
def told() -> list[list[str]]:
    return []


@pytest.fixture
def controls(refusals: list[str], told: list[list[str]]) -> Controls:
    return Controls(refusals.append, lambda paths: told.append(list(paths)))


def test_every_setting_can_be_reached_on_the_form(controls: Controls) -> None:
    shown = {*MAIN, *OF_ROAD_FILE}
    for parts in GROUPS.values():
        controls._rows(parts)
    shown |= set(controls._fields) | set(OF_FILES)
    assert shown == {path for path, _, _ in controls.scenario.settings()}


def test_what_is_folded_is_made_when_it_is_unfolded_and_once(controls: Controls) -> None:
    assert set(controls._fields) == set(MAIN)
    controls._folded.active = [1]
    made = dict(controls._fields)
    assert set(made) > set(MAIN)
    controls._folded.active = []
    controls._folded.active = [1]
    assert controls._fields == made


def test_a_file_of_the_server_cannot_be_named(controls: Controls) -> None:
    for path, parameter, _ in controls.scenario.settings():
        if isinstance(parameter, Text):
            assert path in (*OF_FILES, *OF_ROAD_FILE)


def test_a_moved_control_changes_the_scenario_in_si_units(
    controls: Controls, told: list[list[str]]
) -> None:
    for path, shown, value in (
        ("loading.max_indentation", 0.15, 0.15e-3),
        ("adhesion.release_force", 0.3, 0.3),
        ("numerics.time_resolution_factor", 4, 4),
        ("loading.profile", "quadratic", "quadratic"),
    ):
        controls.field(path).root.value = shown
        assert controls.value(path) == pytest.approx(value)
        assert controls.field(path).root.differs
        assert told[-1] == [path]


def test_a_bad_value_is_refused_with_a_sentence_and_put_back(
    controls: Controls, refusals: list[str]
) -> None:
    for value in (-1.0, None, float("nan")):
        refusals.clear()
        widget = controls.field("tread.thickness").root
        widget.value = value
        assert len(refusals) == 1
        assert "tread.thickness must be a number between" in refusals[0]
        assert widget.value == pytest.approx(10.0)
        assert controls.value("tread.thickness") == pytest.approx(10e-3)


def test_several_settings_are_taken_all_or_none(controls: Controls, refusals: list[str]) -> None:
    controls.change_all({"loading.rate": 0.1, "tread.thickness": -1.0})
    assert controls.value("loading.rate") == 0.03
    assert len(refusals) == 1


@pytest.mark.parametrize("name", presets.names())
def test_a_preset_sets_form_and_scenario_alike(
    controls: Controls, refusals: list[str], name: str
) -> None:
    controls.load(name)
    assert controls.scenario.to_dict() == presets.get(name).to_dict()
    assert refusals == []
    assert controls.changes() == []
    for path in MAIN:
        assert controls.field(path).root.value == controls.value(path)


def test_undo_redo_and_reset_bring_form_preset_and_marks_back(controls: Controls) -> None:
    controls.load("adhesion")
    controls.change("loading.rate", 0.2)
    assert controls.changes() == ["loading.rate"]
    controls.undo()
    assert (controls.preset, controls.changes()) == ("adhesion", [])
    controls.undo()
    assert controls.preset == "default"
    controls.redo()
    controls.redo()
    assert controls.value("loading.rate") == 0.2
    assert controls.field("loading.rate").root.differs
    controls.reset()
    assert controls.scenario.to_dict() == presets.get("adhesion").to_dict()
    assert not controls.field("loading.rate").root.differs
    controls.undo()
    assert controls.value("loading.rate") == 0.2


def test_one_setting_goes_back_to_the_presets_value(controls: Controls) -> None:
    controls.load("adhesion")
    controls.change("loading.hold_time", 0.5)
    controls.change("loading.rate", 0.2)
    controls.restore("loading.hold_time")
    assert controls.changes() == ["loading.rate"]


def test_a_road_that_was_taken_survives_a_preset_and_not_a_reset(controls: Controls) -> None:
    road: dict[str, Any] = {
        "road.pitch": 1e-5, "road.height_unit": "um", "road.size": 0.01,
        "road.file": "/somewhere/road.npy",
    }  # fmt: skip
    controls.take_road(road)
    controls.load("adhesion")
    assert {path: controls.value(path) for path in road} == road
    controls.reset()
    assert controls.value("road.file") == ""
    assert controls.value("road.size") == 0.02


def test_layers_are_written_as_tables(controls: Controls, refusals: list[str]) -> None:
    area = controls.field("tread.layers").root
    area.value = (
        '[{"thickness": 0.002, "density": 1200, "poissons_ratio": 0.49, '
        '"material": "nearly-constant-loss", "youngs_modulus": 1e7, "loss_factor": 0.05}]'
    )
    assert refusals == []
    assert controls.value("tread.layers")[0]["thickness"] == 0.002
    area.value = "no tables"
    assert len(refusals) == 1
    assert '"thickness": 0.002' in area.value
    area.value = " "
    assert controls.value("tread.layers") == []
    assert len(refusals) == 1


def test_layers_read_no_file_of_the_server(
    controls: Controls, refusals: list[str], tmp_path: Path
) -> None:
    secret = tmp_path / "secret.txt"
    secret.write_text("root:x:0:0\n", encoding="utf-8")
    layer = {
        "thickness": 0.01, "density": 1200.0, "poissons_ratio": 0.49, "material": "tabulated"
    }  # fmt: skip
    tables = [{**layer, "modulus_table": str(secret)}]
    controls.field("tread.layers").root.value = json.dumps(tables)
    controls.change_all({"tread.layers": tables})
    assert controls.value("tread.layers") == []
    assert len(refusals) == 2
    assert "no file can be named" in refusals[0]
    controls.change("tread.layers", [{**layer, "modulus_table": ""}])
    assert len(refusals) == 2


def test_a_road_that_was_undone_does_not_come_back_with_a_preset(controls: Controls) -> None:
    controls.take_road({"road.pitch": 1e-5, "road.file": "/somewhere/road.npy"})
    controls.undo()
    controls.load("adhesion")
    assert controls.value("road.file") == ""
    controls.undo()
    controls.redo()
    controls.take_road({"road.pitch": 1e-5, "road.file": "/somewhere/road.npy"})
    controls.reset()
    controls.undo()
    controls.load("default")
    assert controls.value("road.file") == "/somewhere/road.npy"


def test_back_to_the_made_road_is_back_to_that_of_the_preset(controls: Controls) -> None:
    controls.load("adhesion")
    controls._plain.set("road.size", 0.03)
    controls.take_road({"road.size": 0.01, "road.file": "/somewhere/road.npy"})
    controls.take_road({"road.size": 0.02, "road.file": ""})
    assert controls.value("road.size") == 0.03


def test_undo_finds_the_file_before_and_its_name(controls: Controls) -> None:
    file = controls.text_files["loading.table"]
    assert file.root is not None
    file.input.param.update(filename="a.txt", value=b"0 0\n1 1e-4\n")
    first = controls.value("loading.table")
    controls.change("loading.rate", 0.2)
    file.input.param.update(filename="b.txt", value=b"0 0\n1 2e-4\n")
    assert file.name == "b.txt"
    controls.undo()
    assert controls.value("loading.table") == first
    assert Path(first).exists()
    assert file.name == "a.txt"
    controls.reset()
    assert file.name == ""
    controls.close()
    assert not Path(first).exists()
