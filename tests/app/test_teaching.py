"""Lessons on the page: what they put into the form, where they point, what they keep."""

from __future__ import annotations

from typing import Any

import pytest

from app.lessons import lessons
from app.session import Session
from app.views.style import VERMILION
from tests.app.frames import frames_until_the_end
from tyrecontact import Scenario


@pytest.fixture
def session() -> Session:
    return Session()


@pytest.mark.parametrize("name", list(lessons()))
def test_a_lesson_puts_each_of_its_scenarios_into_the_form(session: Session, name: str) -> None:
    session.teaching.begin(name)
    lesson = lessons()[name]
    for index in range(len(lesson.steps)):
        preset, settings = lesson.scenario(index)
        assert session.controls.preset == preset
        assert session.headline.notice == ""
        for path, value in settings.items():
            assert session.controls.value(path) == value
        session.teaching.card._pressed({"do": "next"})
    assert session.teaching.card.lesson is None


def test_a_step_of_a_lesson_is_undone_at_once(session: Session) -> None:
    lesson = next(one for one in lessons().values() if one.scenario(0)[1])
    before = session.controls.scenario.to_dict()
    session.teaching.begin(lesson.name)
    assert session.controls.scenario.to_dict() != before
    session.controls.undo()
    assert session.controls.scenario.to_dict() == before
    assert not session.controls.history.can_undo


def test_a_lesson_frames_the_plot_it_speaks_of_until_it_is_over(session: Session) -> None:
    session.teaching.begin(next(iter(lessons())))
    session.teaching._point("force")
    assert session.live.force.root.outline_line_color == VERMILION
    session.teaching.card.leave()
    assert session.live.force.root.outline_line_color != VERMILION


def test_a_lesson_opens_the_tab_it_speaks_of(session: Session) -> None:
    session.tabs.open("Lessons")
    session.teaching.begin(next(iter(lessons())))
    assert session.tabs.title == "Watch"
    session.teaching._point("stiffness")
    assert session.tabs.title == "Stiffness"
    session.teaching._point("element")
    assert session.tabs.title == "Watch"


def test_only_the_run_of_a_step_is_kept_under_its_label(small: Scenario) -> None:
    session = Session()
    session.whatif.pace.value = "as fast as it can"
    teaching = session.teaching

    def labels() -> list[str]:
        return [pin.label for pin in session.shelf.pinned]

    teaching._apply("default", small_changes(small))
    teaching._pin("nothing has run")
    assert labels() == []
    session.start()
    frames_until_the_end(session)
    teaching._pin("first")
    assert labels() == ["first"]
    teaching._apply("default", {**small_changes(small), "loading.rate": 0.08})
    teaching._pin("second")  # not run
    assert labels() == ["first"]
    session.start()
    frames_until_the_end(session)
    teaching._pin("second")
    assert labels() == ["first", "second"]


def small_changes(small: Scenario) -> dict[str, Any]:
    """What makes the default preset a small scenario."""
    paths = ("road.elements", "road.size", "road.pixel", "loading.max_indentation", "loading.rate")
    values = small.to_dict()
    parts = (path.split(".") for path in (*paths, "numerics.lags"))
    return {f"{part}.{name}": values[part][name] for part, name in parts}


def test_a_lesson_is_about_the_made_road_and_undo_brings_the_own_one_back(
    session: Session,
) -> None:
    own = {"road.file": "/somewhere/road.npy", "road.size": 0.01}
    session.controls.take_road(own)
    session.teaching.begin(next(iter(lessons())))
    assert session.controls.value("road.file") == ""
    session.controls.undo()
    assert session.controls.value("road.file") == own["road.file"]
    session.controls.load("adhesion")  # a preset is about any road
    assert session.controls.value("road.file") == own["road.file"]
