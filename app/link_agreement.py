"""Settings of a link that cannot go together: as many as can are taken, each other one is told."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tyrecontact import Scenario, Simulation, presets
from tyrecontact.errors import InputError

#: so few settings are tried with each of them left out
_FEW = 16


def together(preset: str, settings: Mapping[str, Any]) -> tuple[Scenario, list[str]]:
    """The preset with as many of the settings as go together, and a sentence on each that was left.

    Parameters
    ----------
    preset : that exists.
    settings : path -> value, each in its bounds.
    """
    whole = _made(preset, settings)
    refusal = _refusal(whole)
    if not refusal:
        return whole, []
    if len(settings) <= _FEW:
        for path in reversed(list(settings)):  # one that is out of place is the common case
            fewer = _made(preset, {p: v for p, v in settings.items() if p != path})
            if not _refusal(fewer):
                return fewer, [_left(path, refusal)]
    taken: dict[str, Any] = {}
    left = list(settings.items())
    for _ in range(2):  # what is refused at first may go with what came after it
        left = _take(preset, taken, left)
    problems = [_left(path, _refusal(_made(preset, {**taken, path: v}))) for path, v in left]
    return _made(preset, taken), problems


def _take(preset: str, taken: dict[str, Any], more: list[tuple[str, Any]]) -> list[tuple[str, Any]]:
    """Add to what was taken all that goes with it, and return the rest.

    By halves: few trials where most of it does.
    """
    if not _refusal(_made(preset, {**taken, **dict(more)})):
        taken.update(more)
        return []
    if len(more) == 1:
        return more
    half = len(more) // 2
    left = _take(preset, taken, more[:half])
    return left + _take(preset, taken, more[half:])


def _left(path: str, refusal: str) -> str:
    return f"{path} was left as it is in the preset: {refusal}"


def _made(preset: str, settings: Mapping[str, Any]) -> Scenario:
    scenario = presets.get(preset)
    for path, value in settings.items():
        scenario.set(path, value)
    return scenario


def _refusal(scenario: Scenario) -> str:
    try:
        Simulation(scenario)
    except InputError as error:
        return str(error)
    return ""
