"""Settings in words: a value with its unit, in what two scenarios differ, and a label for that."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import PurePath
from typing import Any

import param

from tyrecontact import Scenario, presets
from tyrecontact.settings import Choice, Count, Tables, Text

from .fields import label_of
from .plain_words import true_minus

#: settings that are known by their value alone: path -> its words
_KNOWN: dict[str, Callable[[str], str]] = {
    "adhesion.release_force": lambda value: value,
    "loading.rate": lambda value: value,
    "loading.profile": lambda value: value,
    "springs.simplification": lambda value: f"{value} springs",
    "numerics.time_resolution_factor": lambda value: f"factor {value}",
    "springs.exchange_count": lambda value: f"{value.partition(' ')[0]} exchanged",
    "numerics.kernel": lambda value: f"{value} kernel",
    "numerics.solver": lambda value: f"{value} solver",
}
#: of more differences than this a label gives the number
_FEW = 2


def with_unit(parameter: param.Parameter, value: Any) -> str:
    """A value [SI] of a setting as a form shows it, with its unit."""
    if isinstance(parameter, Tables):
        count = len(value)
        return "none" if not count else f"{count} {parameter.metadata['called']}{'s'[: count > 1]}"
    if isinstance(parameter, Text):
        return PurePath(value).name or "none"  # a server's folders are nobody else's
    if isinstance(parameter, Choice):
        return value or "not given"
    unit, factor = parameter.metadata["shown_in"]
    if unit[:1].isdigit():  # a power of ten, for forms alone
        unit, factor = "", 1.0
    number = str(value) if isinstance(parameter, Count) else f"{value * factor:.10g}"
    return f"{true_minus(number)} {unit}".rstrip()


def changes(scenario: Scenario, base: Scenario) -> list[str]:
    """Paths of the settings in which two scenarios differ, in the declared order."""
    other = {path: value for path, _, value in base.settings()}
    return [path for path, _, value in scenario.settings() if value != other[path]]


@cache
def _preset(name: str) -> Scenario:
    return presets.get(name)


def preset_of(scenario: Scenario) -> str:
    """Name of the preset that a scenario is, or empty."""
    name = _nearest(scenario)
    return "" if changes(scenario, _preset(name)) else name


def label(scenario: Scenario, base: Scenario | None) -> str:
    """A few words on a scenario: in what it differs from another one, or from a preset.

    Parameters
    ----------
    base : of the run that it is compared with; None where there is none yet.
    """
    different = [] if base is None else changes(scenario, base)
    if different and len(different) <= _FEW:
        return _words(scenario, different)
    name = _nearest(scenario)
    different = changes(scenario, _preset(name))
    return f"{name}, {_words(scenario, different)}" if different else name


def _nearest(scenario: Scenario) -> str:
    """The preset with the fewest differences."""
    return min(presets.PRESETS, key=lambda name: len(changes(scenario, _preset(name))))


def _words(scenario: Scenario, paths: list[str]) -> str:
    if len(paths) > _FEW:
        return f"{len(paths)} settings"
    return ", ".join(_word(scenario, path) for path in paths)


def _word(scenario: Scenario, path: str) -> str:
    part, parameter = scenario.find(path)
    value = with_unit(parameter, getattr(part, path.partition(".")[2]))
    known = _KNOWN.get(path)
    return known(value) if known else f"{label_of(path)} {value}"
