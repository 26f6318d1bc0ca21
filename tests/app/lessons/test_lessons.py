"""The lessons: their texts are short, their settings exist, and what they claim comes out."""

from __future__ import annotations

import re

import pytest

from app.lessons import PLACES, Claim, Lesson, Step, get, lessons
from tests.app.lessons.measures import MEASURES, measured, scenario
from tyrecontact.errors import InputError

#: so that a step fits above the plots
_WORDS = {"text": 45, "question": 16, "seen": 36}
_FEEDBACK_WORDS, _LABEL = 40, 46

_LESSONS = pytest.mark.parametrize("lesson", lessons().values(), ids=lambda lesson: lesson.name)


def _words(text: str) -> int:
    return len(text.split())


def _said(step: Step) -> str:
    """All words of a step."""
    answers = [text for choice in step.choices for text in (choice.label, choice.feedback)]
    return " ".join([step.text, step.question, step.seen, *answers])


def test_there_are_eight_in_order() -> None:
    assert [lesson.number for lesson in lessons().values()] == list(range(1, 9))
    assert all(name == lesson.name for name, lesson in lessons().items())
    assert get("inertia").title == "Does inertia matter?"
    with pytest.raises(InputError, match="inertia"):
        get("inertai")


@_LESSONS
def test_a_lesson_is_short_and_complete(lesson: Lesson) -> None:
    assert 3 <= len(lesson.steps) <= 5
    assert lesson.steps[0].preset
    for step in lesson.steps:
        for name, most in _WORDS.items():
            assert 0 < _words(getattr(step, name)) <= most, (name, step.question)
        assert step.look in PLACES
        assert 2 <= len(step.choices) <= 3
        assert sum(choice.right for choice in step.choices) == 1
        for choice in step.choices:
            assert len(choice.label) <= _LABEL
            assert _words(choice.feedback) <= _FEEDBACK_WORDS, choice.feedback
        assert step.claims


@_LESSONS
def test_what_a_lesson_sets_exists(lesson: Lesson) -> None:
    for index, step in enumerate(lesson.steps):
        preset, settings = lesson.scenario(index)
        scenario(preset, settings)
        if step.preset:
            assert (preset, settings) == (step.preset, step.settings)
        else:
            assert not step.settings
            assert (preset, settings) == lesson.scenario(index - 1)


@_LESSONS
def test_a_claim_has_the_number_of_its_words(lesson: Lesson) -> None:
    in_words = {"ten": 10.0}
    for step in lesson.steps:
        for claim in step.claims:
            assert claim.says in _said(step), claim
            if claim.says:
                found = re.search(r"\d+(\.\d+)?|\bten\b", claim.says)
                assert found is not None
                assert in_words.get(found[0]) == claim.value or float(found[0]) == claim.value


def _off(lesson: Lesson, index: int, claim: Claim) -> str:
    preset, settings = lesson.scenario(index)
    found = MEASURES[claim.measure](measured(preset, {**settings, **claim.settings}), claim.at)
    fits = abs(found - claim.value) <= claim.within
    return "" if fits else f"step {index + 1}: {claim} is {found:.4g}"


@_LESSONS
def test_what_a_lesson_claims_comes_out(lesson: Lesson) -> None:
    off = [
        _off(lesson, index, claim)
        for index, step in enumerate(lesson.steps)
        for claim in step.claims
    ]
    assert [each for each in off if each] == []
