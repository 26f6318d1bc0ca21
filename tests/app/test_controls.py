"""The form is made from the declarations, and form and scenario stay equal."""

from __future__ import annotations

import pytest

from app.controls import MAIN, Controls
from tyrecontact import presets


@pytest.fixture
def refusals() -> list[str]:
    return []


@pytest.fixture
def controls(refusals: list[str]) -> Controls:
    return Controls(refusals.append, refusals.clear)


def test_every_setting_has_a_widget_but_files_and_tables(controls: Controls) -> None:
    paths = {path for path, _, _ in controls.scenario.settings()}
    assert paths - set(controls.widgets) == {
        "road.file", "road.pitch", "road.height_unit", "tread.layers",
        "tread.modulus_table", "loading.table",
    }  # fmt: skip


def test_the_four_main_controls_stand_on_top(controls: Controls) -> None:
    top = controls.root[0]
    assert [controls.widgets[path] for path in MAIN] == list(top)[1:]


def test_labels_carry_the_unit_that_is_shown(controls: Controls) -> None:
    assert controls.widgets["adhesion.release_force"].label == "Release criterion [N]"
    assert controls.widgets["loading.max_indentation"].label == "Max indentation [mm]"
    assert controls.widgets["loading.max_indentation"].value == pytest.approx(0.2)
    assert controls.widgets["tread.base_poissons_ratio"].label == "Base Poisson's ratio"


def test_a_changed_widget_changes_the_scenario_in_si_units(controls: Controls) -> None:
    controls.widgets["loading.max_indentation"].value = 0.15
    controls.widgets["adhesion.release_force"].value = 0.3
    controls.widgets["numerics.time_resolution_factor"].value = 4
    controls.widgets["loading.profile"].value = "quadratic"
    scenario = controls.scenario
    assert scenario.loading.max_indentation == pytest.approx(0.15e-3)
    assert scenario.adhesion.release_force == 0.3
    assert scenario.numerics.time_resolution_factor == 4
    assert scenario.loading.profile == "quadratic"


def test_a_bad_value_is_refused_with_a_sentence_and_put_back(
    controls: Controls, refusals: list[str]
) -> None:
    widget = controls.widgets["tread.thickness"]
    widget.value = -1.0
    assert len(refusals) == 1
    assert "tread.thickness must be a number between" in refusals[0]
    assert widget.value == pytest.approx(10.0)
    assert controls.scenario.tread.thickness == pytest.approx(10e-3)


def test_an_emptied_entry_is_refused_and_put_back(controls: Controls, refusals: list[str]) -> None:
    controls.widgets["loading.rate"].value = None
    assert len(refusals) == 1
    assert controls.widgets["loading.rate"].value == pytest.approx(30.0)


@pytest.mark.parametrize("name", presets.names())
def test_a_preset_sets_form_and_scenario_alike(
    controls: Controls, refusals: list[str], name: str
) -> None:
    controls.load(presets.get(name))
    assert controls.scenario.to_dict() == presets.get(name).to_dict()
    assert refusals == []
    for path in MAIN:
        _, parameter = controls.scenario.find(path)
        part = getattr(controls.scenario, path.partition(".")[0])
        assert controls.widgets[path].value == getattr(part, parameter.name)


def test_a_road_that_was_taken_survives_a_preset(controls: Controls) -> None:
    controls._take_road("/somewhere/road.npy", 1e-5, "um")
    controls.load(presets.get("adhesion"))
    assert controls.scenario.road.file == "/somewhere/road.npy"
    assert controls.scenario.road.pitch == 1e-5
