"""The guided lessons: texts are data, one TOML file a lesson, with what they claim beside them.

A step may choose a preset and settings; steps after it keep them until another one chooses. A
claim is a number of the text, and how it is measured in the scenario of its step: tests run every
scenario and compare.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from typing import Any

from tyrecontact.errors import unknown_name

#: where a step may point: name -> what it is called in a sentence
PLACES = {
    "force": "the force",
    "iterations": "the iterations",
    "map": "the contact map",
    "stiffness": "Stiffness",
    "release": "Release",
    "energy": "Energy",
    "inputs": "Inputs",
    "compare": "Compare",
    "element": "Element",
}


@dataclass(frozen=True)
class Choice:
    """An answer to the question of a step; `right` where it is what comes out."""

    label: str
    feedback: str
    right: bool = False


@dataclass(frozen=True)
class Claim:
    """A number of the text.

    Attributes
    ----------
    says : the words of the step that it backs, with the number in them; or empty.
    measure : name of a figure of the run (tests/app/lessons/measures.py), `at` which place.
    value, within : what it is, and how far off it may be on another machine; in its unit.
    settings : path -> value, beside those of the step.
    """

    measure: str
    value: float
    within: float
    says: str = ""
    at: float | None = None
    settings: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Step:
    """One step of a lesson.

    Attributes
    ----------
    text, question, choices : what is said and asked before the run.
    look : the place, of `PLACES`, that answers it.
    seen : what the thesis has of it.
    preset, settings : what the step chooses; "" where it goes on with what there is.
    pin : label under which its run is kept for comparison, or "".
    """

    text: str
    question: str
    choices: tuple[Choice, ...]
    look: str
    seen: str
    preset: str = ""
    settings: Mapping[str, Any] = field(default_factory=dict)
    pin: str = ""
    claims: tuple[Claim, ...] = ()


@dataclass(frozen=True)
class Lesson:
    """A lesson: `where` names chapter and figures of the thesis, `minutes` is about how long."""

    name: str
    number: int
    title: str
    where: str
    minutes: int
    aim: str
    steps: tuple[Step, ...]

    def scenario(self, index: int) -> tuple[str, Mapping[str, Any]]:
        """Preset and settings in force at a step."""
        chosen = next(step for step in reversed(self.steps[: index + 1]) if step.preset)
        return chosen.preset, chosen.settings


@cache
def lessons() -> dict[str, Lesson]:
    """All lessons by name, in their order."""
    read = [
        _lesson(tomllib.loads(path.read_text(encoding="utf-8")))
        for path in files(__package__).iterdir()
        if path.name.endswith(".toml")
    ]
    return {lesson.name: lesson for lesson in sorted(read, key=lambda lesson: lesson.number)}


def get(name: str) -> Lesson:
    """The lesson of a name.

    Raises
    ------
    InputError : no lesson has that name; the nearest is offered.
    """
    known = lessons()
    if name not in known:
        raise unknown_name("lesson", name, known)
    return known[name]


def _lesson(table: dict[str, Any]) -> Lesson:
    return Lesson(**{**table, "steps": tuple(_step(step) for step in table["steps"])})


def _step(table: dict[str, Any]) -> Step:
    parts = {
        "choices": tuple(Choice(**choice) for choice in table["choices"]),
        "claims": tuple(Claim(**claim) for claim in table.get("claims", [])),
    }
    return Step(**{**table, **parts})
