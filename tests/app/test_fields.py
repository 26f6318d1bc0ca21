"""Fields of the form: made from a declaration, in the unit that is shown, with a mark."""

from __future__ import annotations

from typing import Any

import pytest

from app.fields import Field, label_of, meaning
from tyrecontact import Scenario
from tyrecontact.errors import InputError
from tyrecontact.settings import Text


def _field(path: str, changes: list[tuple[str, Any]], restored: list[str]) -> Field:
    scenario = Scenario()
    part, parameter = scenario.find(path)
    value = getattr(part, parameter.name)
    return Field(path, parameter, value, lambda *what: changes.append(what), restored.append)


#: files are brought, not named
_PATHS = [path for path, declared, _ in Scenario().settings() if not isinstance(declared, Text)]


@pytest.mark.parametrize("path", _PATHS)
def test_every_setting_has_a_field_that_shows_its_value_within_its_slider(path: str) -> None:
    field = _field(path, [], [])
    widget = field.root
    assert widget.label.startswith(label_of(path))
    if getattr(widget, "step", None) is not None:
        assert widget.low <= widget.start <= widget.value <= widget.end <= widget.high
        assert 0 < widget.step <= widget.end - widget.start


@pytest.mark.parametrize("path", ["loading.rate", "loading.max_indentation", "tread.thickness"])
def test_a_slider_steps_over_round_numbers(path: str) -> None:
    widget = _field(path, [], []).root
    steps = (widget.value - widget.start) / widget.step  # as a browser counts them
    assert steps == pytest.approx(round(steps), abs=1e-6)
    assert widget.low > 0


def test_a_slider_begins_at_a_bound_that_is_the_value() -> None:
    _, parameter = Scenario().find("loading.rate")
    widget = Field("loading.rate", parameter, parameter.bounds[0], print, print).root
    assert widget.start == widget.value == widget.low


def test_a_quantity_is_shown_in_its_unit_and_handed_on_in_si() -> None:
    changes: list[tuple[str, Any]] = []
    field = _field("loading.rate", changes, [])
    assert field.root.value == 30.0
    assert field.root.label == "Rate [mm/s]"
    field.root.value = 45.0
    assert changes == [("loading.rate", pytest.approx(0.045))]


def test_a_count_stays_a_whole_number_whatever_the_browser_sends() -> None:
    changes: list[tuple[str, Any]] = []
    _field("springs.exchange_count", changes, []).root.value = 80.0
    assert changes == [("springs.exchange_count", 80)]
    assert isinstance(changes[0][1], int)


@pytest.mark.parametrize(
    "sent", [10**400, -(10**400), float("nan"), True, [1], {"a": 1}, "x" * 10**6]
)
@pytest.mark.parametrize("path", ["loading.rate", "springs.exchange_count", "loading.profile"])
def test_what_no_page_sends_is_refused_in_a_short_sentence(path: str, sent: Any) -> None:
    scenario = Scenario()
    part, parameter = scenario.find(path)
    before = getattr(part, parameter.name)
    field = Field(path, parameter, before, scenario.set, lambda _: None)
    with pytest.raises(InputError, match=f"{path} must be") as refused:
        field.root.value = sent
    assert len(str(refused.value)) < 220
    assert getattr(part, parameter.name) == before


def test_what_is_set_is_not_told_as_a_change() -> None:
    changes: list[tuple[str, Any]] = []
    field = _field("loading.rate", changes, [])
    field.set(0.1)
    assert field.root.value == pytest.approx(100.0)
    assert changes == []


def test_the_mark_and_the_way_back() -> None:
    restored: list[str] = []
    field = _field("tread.thickness", [], restored)
    field.mark(True)
    assert field.root.differs
    field.root._handle_msg({"restore": True})
    field.root._handle_msg("nonsense")
    assert restored == ["tread.thickness"]


def test_meanings_name_the_chapter_of_the_thesis() -> None:
    _, parameter = Scenario().find("loading.rate")
    assert meaning(parameter).endswith("Thesis: chapters 4.3 and 5.1.")
