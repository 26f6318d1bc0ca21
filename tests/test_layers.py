"""The layers of a tread as a setting: checked table by table, kept plain, and carried along."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tyrecontact import Results, Scenario, Simulation
from tyrecontact.__main__ import main
from tyrecontact.errors import InputError
from tyrecontact.parts.tread import Tread
from tyrecontact.scenario import read_tables
from tyrecontact.settings import parsed

TOP = {
    "thickness": 8e-3, "density": 1200.0, "poissons_ratio": 0.49, "material": "fractional-zener",
    "static_modulus": 2e7, "glassy_modulus": 5e8, "exponent": 0.6, "relaxation_time": 1e-7,
}  # fmt: skip
BASE = {
    "thickness": 3e-3, "density": 2700.0, "poissons_ratio": 0.33,
    "material": "nearly-constant-loss", "youngs_modulus": 72e9, "loss_factor": 5e-5,
}  # fmt: skip
TOML = """
[[tread.layers]]
thickness = 8e-3
density = 1200
poissons_ratio = 0.49
material = "fractional-zener"
static_modulus = 2e7
glassy_modulus = 5e8
exponent = 0.6
relaxation_time = 1e-7
[[tread.layers]]
thickness = 3e-3
density = 2700
poissons_ratio = 0.33
material = "nearly-constant-loss"
youngs_modulus = 72e9
loss_factor = 5e-5
"""


def without(name: str, table: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key != name}


def test_no_layers_stand_for_tread_and_base() -> None:
    assert Scenario().tread.layers == []


def test_layers_come_from_a_file_a_dictionary_and_a_text(tmp_path: Path) -> None:
    (tmp_path / "layers.toml").write_text(TOML)
    from_file = Scenario(**read_tables(tmp_path / "layers.toml"))
    from_text = Scenario()
    from_text.set("tread.layers", json.dumps([TOP, BASE]))
    for scenario in (from_file, from_text, Scenario(tread={"layers": (TOP, BASE)})):
        assert scenario.tread.layers == [TOP, BASE]


def test_layers_survive_json_a_copy_and_a_dictionary() -> None:
    scenario = Scenario(tread={"layers": [TOP, BASE]})
    again = Scenario(**json.loads(json.dumps(scenario.to_dict())))
    assert again.to_dict() == scenario.copy().to_dict() == scenario.to_dict()


def test_layers_are_nobody_elses_to_change() -> None:
    given = [dict(TOP)]
    scenario = Scenario(tread={"layers": given})
    copy = scenario.copy()
    given[0]["thickness"] = -1.0
    scenario.to_dict()["tread"]["layers"][0]["thickness"] = -1.0
    copy.tread.layers[0]["thickness"] = 1.0
    assert scenario.tread.layers == [TOP]
    assert Tread().layers is not Tread().layers


def test_whole_numbers_and_the_order_of_a_table_do_not_matter() -> None:
    turned = dict(reversed(TOP.items())) | {"density": 1200}
    assert list(Tread(layers=[turned]).layers[0]) == list(TOP)


@pytest.mark.parametrize(
    ("tables", "sentence"),
    [
        (3, "tread.layers must be a list of tables, got 3"),
        ("soft", "tread.layers must be a list of tables, got 'soft'"),
        ([TOP, 3], "tread.layers must be a list of tables, got"),
        (TOP, "tread.layers must be a list of tables, got"),
        ([{}], "layer 1 of tread.layers: thickness must be given, got nothing"),
        ([TOP, without("density", BASE)], "layer 2 of tread.layers: density must be given, got t"),
        ([without("exponent", TOP)], "layer 1 of tread.layers: exponent must be given"),
        ([without("material", TOP)], "layer 1 of tread.layers: material must be given"),
        (
            [BASE | {"exponent": 0.5}],
            "layer 1 of tread.layers: settings of a nearly-constant-loss layer must be thickness, "
            "density, poissons_ratio, material, youngs_modulus, loss_factor, got exponent",
        ),
        (
            [BASE, BASE, TOP | {"thickness": 0.0}],
            "layer 3 of tread.layers: layer.thickness must be a number between 1e-06 and 0.2 m, "
            "got 0.0 m",
        ),
        ([TOP | {"poissons_ratio": 0.5}], "layer 1 of tread.layers: layer.poissons_ratio must be"),
        ([TOP | {"density": float("nan")}], "layer 1 of tread.layers: layer.density must be a num"),
        ([TOP | {"thickness": "10 mm"}], "layer.thickness must be a number .* got '10 mm'"),
        (
            [TOP | {"material": "fractional-zenner"}],
            "must be one of .*did you mean 'fractional-zener'",
        ),
        ([TOP | {"thikness": 1}], "layer 1 of tread.layers: .*did you mean 'thickness'"),
        ([TOP | {"name": "top"}], "layer 1 of tread.layers: settings of a fractional-zener"),
    ],
)
def test_tables_that_will_not_do_are_refused_by_number(tables: Any, sentence: str) -> None:
    scenario = Scenario(tread={"layers": [BASE]})
    with pytest.raises(InputError, match=sentence) as caught:
        scenario.tread.layers = tables
    assert "\n" not in str(caught.value)
    assert scenario.tread.layers == [BASE]


@pytest.mark.parametrize("text", ["[{", "soft", "[" * 100_000, "NaN", '[{"thickness": NaN}]'])
def test_a_text_that_holds_no_tables_is_refused(text: str) -> None:
    with pytest.raises(InputError, match=r"tread\.layers"):
        Scenario().set("tread.layers", text)


def test_a_text_is_parsed_as_json() -> None:
    parameter = Scenario().find("tread.layers")[1]
    assert parsed(parameter, '[{"a": 1}]') == [{"a": 1}]


def test_a_layered_tread_runs_and_is_remembered_in_the_file(quick: Scenario) -> None:
    quick.tread.layers = [TOP, BASE]
    results = Simulation(quick).run()
    assert isinstance(results, Results)
    assert results.failed_at is None
    kept = json.loads(results.to_xarray().attrs["scenario"])
    assert Scenario(**kept).to_dict() == quick.to_dict()


def test_the_command_line_takes_layers_and_refuses_them(
    capsys: pytest.CaptureFixture[str],
) -> None:
    wrong = json.dumps([TOP, BASE | {"density": -1}])
    assert main(["run", "default", "--set", f"tread.layers={wrong}"]) == 2
    captured = capsys.readouterr()
    assert captured.err.startswith("tyrecontact: layer 2 of tread.layers: layer.density must be a")
    assert captured.err.count("\n") == 1
