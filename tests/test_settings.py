"""Settings: every one declared in full, and bad values refused in one sentence."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import Any

import numpy as np
import param
import pytest

from tyrecontact import Scenario
from tyrecontact.errors import InputError, shown
from tyrecontact.settings import Choice, Count, Quantity, Tables, Text, parsed

SETTINGS = {path: parameter for path, parameter, _ in Scenario().settings()}
NUMBERS = [path for path, p in SETTINGS.items() if isinstance(p, Quantity | Count)]
QUANTITIES = [path for path, p in SETTINGS.items() if isinstance(p, Quantity)]
COUNTS = [path for path, p in SETTINGS.items() if isinstance(p, Count)]
CHOICES = [path for path, p in SETTINGS.items() if isinstance(p, Choice)]
#: what a form shows -> factor to it, by the unit of the setting
SHOWN = {
    "m": {"m": 1, "mm": 1e3, "µm": 1e6},
    "s": {"s": 1, "ms": 1e3, "µs": 1e6},
    "m/s": {"m/s": 1, "mm/s": 1e3, "µm/s": 1e6},
    "m²": {"m²": 1, "mm²": 1e6},
    "N/m": {"N/m": 1, "MN/m": 1e-6},
    "N/s": {"N/s": 1, "N/ms": 1e-3},
    "Pa": {"Pa": 1, "MPa": 1e-6, "GPa": 1e-9},
    "Hz": {"Hz": 1, "kHz": 1e-3},
    "B": {"B": 1, "MB": 1e-6},
}
HUGE = 10**400  # larger than any float


def refusal(path: str, value: Any) -> str:
    """The sentence with which a value is refused, after which the old value must still hold."""
    scenario = Scenario()
    part, name = getattr(scenario, path.partition(".")[0]), path.partition(".")[2]
    before = getattr(part, name)
    with pytest.raises(InputError) as caught:
        setattr(part, name, value)
    assert getattr(part, name) == before
    assert "\n" not in str(caught.value)
    return str(caught.value)


def factor_to(unit: str, shown: str) -> float:
    """From a setting in its unit to what a form shows: another unit, or multiples of 1e-5, say."""
    if shown == unit or unit:
        return SHOWN.get(unit, {unit: 1.0})[shown]
    return 1 / float(shown)


@pytest.mark.parametrize("path", SETTINGS)
def test_every_setting_is_declared_in_full(path: str) -> None:
    parameter = SETTINGS[path]
    assert isinstance(parameter, Quantity | Count | Choice | Text | Tables)
    assert parameter.doc[0].isupper()
    assert len(parameter.doc) > 10
    unit, (shown, factor) = parameter.metadata["unit"], parameter.metadata["shown_in"]
    assert isinstance(unit, str)
    assert factor == pytest.approx(factor_to(unit, shown), rel=1e-12)  # rounding


@pytest.mark.parametrize("path", NUMBERS)
def test_defaults_lie_within_finite_bounds(path: str) -> None:
    low, high = SETTINGS[path].bounds
    assert -math.inf < low <= SETTINGS[path].default <= high < math.inf


@pytest.mark.parametrize("path", NUMBERS)
def test_bounds_are_inclusive(path: str) -> None:
    for bound in SETTINGS[path].bounds:
        scenario = Scenario()
        scenario.set(path, bound)
        part, _, name = path.partition(".")
        assert getattr(getattr(scenario, part), name) == bound


@pytest.mark.parametrize("path", QUANTITIES)
def test_a_quantity_out_of_bounds_is_refused_with_path_bounds_and_unit(path: str) -> None:
    (low, high), unit = SETTINGS[path].bounds, SETTINGS[path].metadata["unit"]
    spaced = f" {unit}" if unit else ""
    for value in (math.nextafter(low, -math.inf), high * 1.01, -1e300):
        assert refusal(path, value) == (
            f"{path} must be a number between {low:g} and {high:g}{spaced}, got {value!r}{spaced}"
        )


@pytest.mark.parametrize("path", COUNTS)
def test_a_count_out_of_bounds_is_refused_with_path_and_bounds(path: str) -> None:
    low, high = SETTINGS[path].bounds
    for value in (low - 1, high + 1, HUGE):
        said = f"{path} must be a whole number between {low} and {high}, got {shown(value)}"
        assert refusal(path, value) == said


def test_a_sentence_does_not_repeat_all_of_a_long_value() -> None:
    for path, value in (
        ("road.seed", HUGE),
        ("loading.rate", "x" * 10**6),
        ("tread.layers", [1] * 999),
    ):
        assert len(refusal(path, value)) < 200
        assert refusal(path, value).endswith("…")


@pytest.mark.parametrize("path", NUMBERS)
@pytest.mark.parametrize(
    "value", [math.nan, math.inf, -math.inf, True, "1", None, 1j, [1.0], np.ones(1)], ids=repr
)
def test_what_is_no_real_number_is_refused(path: str, value: object) -> None:
    assert f"got {value!r}" in refusal(path, value)


@pytest.mark.parametrize("path", COUNTS)
def test_a_count_is_whole(path: str) -> None:
    assert "whole number" in refusal(path, float(SETTINGS[path].default))


@pytest.mark.parametrize("path", CHOICES)
@pytest.mark.parametrize("value", ["PASSIVE", "?", 3, None, True, ["passive"]], ids=repr)
def test_a_choice_out_of_the_names_lists_them(path: str, value: object) -> None:
    message = refusal(path, value)
    assert message.startswith(f"{path} must be one of ")
    assert all(name in message for name in SETTINGS[path].objects)


def test_a_choice_offers_the_nearest_name() -> None:
    assert "did you mean 'passive'" in refusal("numerics.kernel", "pasive")


@pytest.mark.parametrize("value", [3, None, True, b"road.npy", ["road.npy"]], ids=repr)
def test_a_text_is_a_text(value: object) -> None:
    assert refusal("road.file", value) == f"road.file must be a text, got {value!r}"


@pytest.mark.parametrize(
    ("path", "text", "value"),
    [
        ("loading.rate", "0.01", 0.01),
        ("loading.rate", " 1e-2 ", 0.01),
        ("road.elements", "12", 12),
        ("numerics.kernel", "static", "static"),
        ("road.file", "12", "12"),
    ],
)
def test_a_text_is_parsed_to_the_kind_of_the_setting(path: str, text: str, value: object) -> None:
    found = parsed(SETTINGS[path], text)
    assert found == value
    assert type(found) is type(value)


@pytest.mark.parametrize("path", ["loading.rate", "road.elements"])
def test_a_text_that_is_no_number_is_left_to_be_refused(path: str) -> None:
    assert parsed(SETTINGS[path], "1,5") == "1,5"


def test_the_message_names_the_part_on_any_way_to_the_setting() -> None:
    scenario = Scenario()
    _, parameter = scenario.find("loading.rate")  # makes a copy of the declaration
    assert isinstance(parameter, param.Parameter)
    with pytest.raises(InputError, match=r"^loading\.rate must"):
        scenario.loading.rate = -1
    with pytest.raises(InputError, match=r"^loading\.rate must"):
        scenario.loading.param.update(rate=-1)
    with pytest.raises(InputError, match=r"^loading\.rate must"):
        type(scenario.loading)(rate=-1)


def test_a_number_beyond_float_is_refused_in_a_sentence() -> None:
    assert "loading.rate" in refusal("loading.rate", HUGE)


def test_a_choice_refuses_an_array_in_a_sentence() -> None:
    assert "kernel must be one of" in refusal("numerics.kernel", np.array(["passive", "static"]))


@pytest.mark.parametrize(
    "value",
    [
        np.float32(0.01),
        np.float64(0.01),
        np.int64(1),
        Fraction(1, 100),
    ],
    ids=repr,
)
def test_a_number_of_another_kind_becomes_a_plain_one(value: Any) -> None:
    scenario = Scenario()
    scenario.loading.rate = value
    assert json.loads(json.dumps(scenario.to_dict()))["loading"]["rate"] == float(value)


def test_an_empty_name_can_be_seen_in_the_list() -> None:
    assert "must be one of '' (none), m, mm, um, got 'nm'" in refusal("road.height_unit", "nm")
