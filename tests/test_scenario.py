"""The question: parts and settings by name, copies, dictionaries, and files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tyrecontact import Scenario
from tyrecontact.errors import InputError
from tyrecontact.parts.process import Numerics
from tyrecontact.scenario import read_tables

CHANGES: dict[str, dict[str, Any]] = {
    "road": {"file": "scan.npy", "pitch": 2e-5, "height_unit": "um", "elements": 12},
    "springs": {"exchange_count": 7},
    "tread": {"static_modulus": 1e7},
    "loading": {"profile": "quadratic", "rate": 0.1},
    "adhesion": {"release_force": 0.0},
    "numerics": {"kernel": "static", "lags": 64},
}


def message_of(call: Any, *arguments: Any) -> str:
    """The one sentence of the InputError that a call must end with."""
    with pytest.raises(InputError) as caught:
        call(*arguments)
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("road.size", 20e-3),
        ("road.elements", 20),
        ("springs.youngs_modulus", 10e6),
        ("springs.exchange_compression", 9e-6),
        ("tread.static_modulus", 25e6),
        ("tread.exponent", 0.6091),
        ("tread.relaxation_time", 3.717e-6),
        ("tread.poissons_ratio", 0.499),
        ("tread.density", 1300),
        ("tread.thickness", 10e-3),
        ("tread.base_modulus", 72e9),
        ("tread.base_loss_factor", 5e-5),
        ("tread.base_poissons_ratio", 0.33),
        ("tread.base_density", 2700),
        ("tread.base_thickness", 3e-3),
        ("loading.max_indentation", 0.2e-3),
        ("adhesion.release_force", 0.6),
        ("numerics.kernel", "passive"),
        ("numerics.solver", "robust"),
        ("numerics.sampling_frequency", 51200),
        ("numerics.lags", 256),
    ],
)
def test_defaults_are_those_of_the_thesis(path: str, value: object) -> None:
    assert {name: found for name, _, found in Scenario().settings()}[path] == value


def test_parts_come_as_keyword_arguments_and_the_rest_stays_default() -> None:
    changed, default = Scenario(**CHANGES).to_dict(), Scenario().to_dict()
    for part, values in default.items():
        assert changed[part] == {**values, **CHANGES[part]}


def test_settings_lists_every_setting_once_with_its_value() -> None:
    scenario = Scenario(**CHANGES)
    paths = [path for path, _, _ in scenario.settings()]
    assert len(paths) == len(set(paths)) == sum(map(len, scenario.to_dict().values()))
    for path, parameter, value in scenario.settings():
        part, _, name = path.partition(".")
        assert parameter.name == name
        assert value == getattr(getattr(scenario, part), name)


def test_a_dictionary_is_plain_and_makes_an_equal_scenario() -> None:
    scenario = Scenario(**CHANGES)
    text = json.dumps(scenario.to_dict())
    assert Scenario(**json.loads(text)).to_dict() == scenario.to_dict()
    assert Scenario().to_dict() != scenario.to_dict()


def test_a_copy_shares_nothing() -> None:
    scenario = Scenario(**CHANGES)
    before, copy = scenario.to_dict(), scenario.copy()
    assert copy.to_dict() == before
    for path, parameter, _ in copy.settings():
        copy.set(path, parameter.default)
    assert scenario.to_dict() == before
    assert copy.to_dict() == Scenario().to_dict()


def test_scenarios_do_not_share_their_parts() -> None:
    one, other = Scenario(), Scenario()
    one.loading.rate = 0.2
    assert other.loading.rate == 0.03
    assert Scenario().loading.rate == 0.03


@pytest.mark.parametrize(
    ("path", "text", "value"),
    [
        ("loading.rate", "0.01", 0.01),
        ("road.elements", "8", 8),
        ("numerics.kernel", "static", "static"),
        ("road.file", "3.npy", "3.npy"),
    ],
)
def test_set_parses_a_text(path: str, text: str, value: object) -> None:
    scenario = Scenario()
    scenario.set(path, text)
    part, parameter = scenario.find(path)
    assert getattr(part, parameter.name) == value


@pytest.mark.parametrize("text", ["fast", "", "nan", "inf", "1,5", "1e999", "0x10"])
def test_set_refuses_a_text_that_is_no_number_of_the_setting(text: str) -> None:
    scenario = Scenario()
    assert message_of(scenario.set, "loading.rate", text).startswith("loading.rate must be a num")
    assert scenario.loading.rate == 0.03


def test_an_unknown_part_lists_the_parts_and_the_nearest() -> None:
    for message in (
        message_of(lambda: Scenario(loadin={})),
        message_of(Scenario().set, "loadin.rate", 1),
        message_of(Scenario().find, "loadin.rate"),
    ):
        assert "adhesion, loading, numerics, road, springs, tread" in message
        assert "did you mean 'loading'" in message


def test_an_unknown_setting_lists_those_of_the_part_and_the_nearest() -> None:
    for message in (
        message_of(lambda: Scenario(adhesion={"release_forse": 1})),
        message_of(Scenario().set, "adhesion.release_forse", 1),
    ):
        assert message.startswith("setting of adhesion must be one of ageing, ")
        assert "did you mean 'release_force'" in message


@pytest.mark.parametrize("path", ["", "loading", "loading.", "loading.rate.x", "loading.name"])
def test_a_path_that_leads_to_no_setting_is_refused(path: str) -> None:
    assert "must be one of" in message_of(Scenario().set, path, 1)


@pytest.mark.parametrize("values", [3, "rate", None, [("rate", 1)]], ids=repr)
def test_a_part_must_be_a_table(values: Any) -> None:
    message = message_of(lambda: Scenario(loading=values))
    assert message == f"loading must be a table of settings, got {values!r}"


def test_a_toml_file_holds_parts(tmp_path: Path) -> None:
    file = tmp_path / "fast.toml"
    file.write_text('preset = "adhesion"\n[loading]\nrate = 0.2\n[road]\nfile = "ü.npy"\n', "utf-8")
    tables = read_tables(file)
    assert tables.pop("preset") == "adhesion"
    scenario = Scenario(**tables)
    assert (scenario.loading.rate, scenario.road.file) == (0.2, "ü.npy")


@pytest.mark.parametrize("content", [b"[loading\n", b"rate = fast\n", b"a = 1\na = 2\n", b"\xff"])
def test_a_file_that_is_not_toml_is_refused_by_name(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "broken.toml"
    file.write_bytes(content)
    assert message_of(read_tables, file).startswith(f"scenario file must be TOML, got {file}: ")


def test_a_file_that_cannot_be_read_is_refused_with_the_reason(tmp_path: Path) -> None:
    missing = message_of(read_tables, tmp_path / "missing.toml")
    assert missing.endswith("missing.toml: No such file or directory")
    assert message_of(read_tables, tmp_path).endswith(": Is a directory")


def test_a_misspelt_attribute_is_refused_with_the_nearest() -> None:
    part = Scenario().numerics
    assert "did you mean 'kernel'" in message_of(setattr, part, "kernal", "static")
    assert "did you mean 'numerics'" in message_of(setattr, Scenario(), "numeric", part)
    assert not hasattr(part, "kernal")


def test_a_misspelt_keyword_is_refused_with_the_nearest() -> None:
    assert "did you mean 'kernel'" in message_of(lambda: Numerics(kernal="static"))


def test_a_part_called_self_is_unknown_like_any_other() -> None:
    message = message_of(lambda: Scenario(**{"self": {}}))
    assert message.startswith("part of a scenario must be one of")


def test_a_part_that_is_replaced_by_something_else_is_refused_as_input() -> None:
    for value in (3, None, Scenario().tread):
        assert "road must be a Road" in message_of(setattr, Scenario(), "road", value)
