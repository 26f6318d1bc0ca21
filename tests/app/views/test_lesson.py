"""A lesson's strip and the list to choose from: what they draw, and whom they call."""

from __future__ import annotations

from typing import Any

import pytest

from app.lessons import lessons
from app.views.lesson import LessonCard
from app.views.lesson_list import LessonList
from app.views.style import DESK, HALL
from tyrecontact.errors import InputError


class Calls(list):
    """What a card has asked of its page, in order."""

    def card(self) -> LessonCard:
        return LessonCard(
            lambda preset, settings: self.append(("apply", preset, settings)),
            lambda place: self.append(("point", place)),
            lambda label: self.append(("pin", label)),
            lambda: self.append(("leave",)),
        )

    def taken(self) -> list[tuple]:
        found = list(self)
        self.clear()
        return found


def _press(card: LessonCard, what: str, **more: Any) -> None:
    card.root._handle_msg({"do": what, **more})


def test_nothing_is_there_without_a_lesson() -> None:
    calls = Calls()
    card = calls.card()
    assert not card.root.visible
    assert card.step is None
    for what in ("next", "back", "leave", "show"):
        _press(card, what)
    card.leave()
    card.size(HALL)
    assert not card.root.visible
    assert calls == []
    with pytest.raises(InputError, match="why-it-blows-up"):
        card.start("why-it-blow-up")


def test_a_lesson_sets_its_scenario_asks_and_answers() -> None:
    calls = Calls()
    card = calls.card()
    card.start("why-it-blows-up")
    assert calls.taken() == [
        ("apply", "thesis-instability", {"loading.max_indentation": 80e-6}),
        ("point", "force"),
    ]
    state = card.root.state
    assert card.root.visible
    assert (state["step"], state["steps"], state["chosen"]) == (1, 4, -1)
    assert state["feedback"] == ""
    _press(card, "choose", index=0)
    assert not card.root.state["right"]
    assert "46.7 µm" in card.root.state["feedback"]
    _press(card, "choose", index=1)
    assert card.root.state["right"]
    assert card.root.state["seen"] == card.step.seen
    assert calls == []
    _press(card, "show")
    assert calls.taken() == [("point", "force")]


def test_forth_and_back_pin_and_set_what_differs() -> None:
    calls = Calls()
    card = calls.card()
    card.start("compliant-machine")
    calls.clear()
    _press(card, "next")
    assert [call[:2] for call in calls.taken()] == [("pin", "rigid"), ("apply", "adhesion")]
    _press(card, "choose", index=1)
    _press(card, "next")  # goes on with the scenario of the step before
    assert calls.taken() == [("pin", "1 MN/m")]
    assert card.root.state["chosen"] == -1
    _press(card, "next")
    _press(card, "back")
    assert card.root.state["step"] == 3
    preset, settings = calls.taken()[-1][1:]
    assert (preset, settings) == ("adhesion", dict(card.lesson.steps[1].settings))


def test_the_end_of_a_lesson_takes_the_strip_away() -> None:
    calls = Calls()
    card = calls.card()
    card.start("contact-map")
    _press(card, "back")
    assert card.index == 0
    for _ in card.lesson.steps:
        _press(card, "next")
    assert calls[-1] == ("leave",)
    assert not card.root.visible
    card.start("contact-map")
    _press(card, "leave")
    assert calls[-1] == ("leave",)
    assert card.lesson is None


def test_what_no_button_sends_is_left_alone() -> None:
    calls = Calls()
    card = calls.card()
    card.start("inertia")
    calls.clear()
    for index in (3, -1, None, "0", 1.0):
        _press(card, "choose", index=index)
    _press(card, "dance")
    card.root._handle_msg("next")
    assert card.chosen == -1
    assert calls == []


def test_type_grows_in_a_hall() -> None:
    card = Calls().card()
    card.start("inertia")
    assert card.root.state["size"] == DESK.title
    card.size(HALL)
    assert card.root.state["size"] == HALL.title


def test_the_list_offers_all_and_starts_the_chosen() -> None:
    started: list[str] = []
    offered = LessonList(started.append)
    assert [card["name"] for card in offered.root.lessons] == list(lessons())
    assert offered.root.lessons[0]["title"].startswith("1. ")
    offered.root._handle_msg("inertia")
    offered.root._handle_msg("nonsense")
    offered.root._handle_msg(["inertia"])
    assert started == ["inertia"]
    offered.show(None, HALL)
    assert offered.root.type_size == HALL.title
