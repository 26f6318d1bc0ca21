"""A scenario as a link, and a link as a scenario: what cannot be used is told and left out.

A link names its version, a preset, and what differs from it in SI units: `v=1&p=default&lr=0.05`.
Anybody can write one: nothing in it is trusted, and no file of the server is ever read for it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple
from urllib.parse import parse_qsl, quote

from tyrecontact import Scenario, presets
from tyrecontact.errors import InputError
from tyrecontact.settings import Tables, Text

from .code import changes
from .link_agreement import together
from .link_keys import KEYS, PRESET_KEY, VERSION_KEY, VIEW_MARK
from .link_values import OWN_FILE, has_own_file, layers, written

#: of the links that are written here
VERSION = 1
#: characters of a link, and of one value in it, beyond which nothing is read
LONGEST, LONGEST_VALUE = 8000, 80
#: sentences told about one link, at most
MOST_TOLD = 8
#: of a setting that reads a file: what the file is of -> what those have who lack it
_FILES = {
    "road.file": ("road", "a made road"),
    "loading.table": ("loading profile", "the profile of the preset"),
    "tread.modulus_table": ("modulus of the tread", "the table of the thesis' Appendix B"),
    "tread.layers": ("modulus of a layer", "the table of the thesis' Appendix B"),
}
_PATHS = {key: path for path, key in KEYS.items()}


class Link(NamedTuple):
    """What a link says: `view` name -> choice; `problems` one sentence each on what was left."""

    preset: str
    scenario: Scenario
    view: dict[str, str]
    problems: list[str]


def query(preset: str, scenario: Scenario, view: Mapping[str, str] | None = None) -> str:
    """The text behind the question mark.

    Parameters
    ----------
    preset : that the scenario differs least from, or came from.
    scenario : its files are only marked (see `unshared`).
    view : name -> choice of what is looked at, such as {"axis": "time"}.

    Raises
    ------
    InputError : no preset has that name.
    """
    pairs = [(VERSION_KEY, str(VERSION)), (PRESET_KEY, preset)]
    for path, value in changes(preset, scenario).items():
        _, parameter = scenario.find(path)
        text = OWN_FILE if isinstance(parameter, Text) and value else written(value)
        pairs.append((KEYS[path], text))
    pairs += [(VIEW_MARK + name, choice) for name, choice in (view or {}).items()]
    return "&".join(f"{quote(key, safe='')}={quote(text, safe='/:*')}" for key, text in pairs)


def unshared(scenario: Scenario) -> list[str]:
    """One sentence on each file that a link to this scenario cannot carry."""
    found = [path for path in _FILES if path != "tread.layers" and _value(scenario, path)]
    if has_own_file(scenario.tread.layers):
        found.append("tread.layers")
    return [
        f"The {what} comes from a file of your own, which a link cannot carry: "
        f"whoever opens it gets {instead}"
        for what, instead in (_FILES[path] for path in found)
    ]


def parse(search: str, views: Mapping[str, Sequence[str]] | None = None) -> Link:
    """What a link asks for, as far as it can be had; it never raises.

    Parameters
    ----------
    search : the text behind the question mark, with or without it.
    views : name -> choices of what can be looked at.
    """
    problems: list[str] = []
    pairs = _pairs(search, problems)
    _check_version(pairs.pop(VERSION_KEY, str(VERSION)), problems)
    preset = _preset(pairs.pop(PRESET_KEY, "default"), problems)
    view: dict[str, str] = {}
    settings: dict[str, Any] = {}
    for key, text in pairs.items():
        try:
            if key.startswith(VIEW_MARK):
                name = key.removeprefix(VIEW_MARK)
                view[name] = _choice(name, text, views or {})
            else:
                settings.update([_setting(key, text, problems)])
        except InputError as error:
            problems.append(str(error))
    scenario, left = together(preset, settings)
    problems += left
    if len(problems) > MOST_TOLD:
        more = len(problems) - MOST_TOLD + 1
        problems[MOST_TOLD - 1 :] = [f"{more} more things in this link cannot be used"]
    return Link(preset, scenario, view, problems)


def _pairs(search: str, problems: list[str]) -> dict[str, str]:
    if len(search) > LONGEST:
        problems.append(
            f"A link must have at most {LONGEST} characters, got {len(search)}: nothing was taken"
        )
        return {}
    pairs: dict[str, str] = {}
    for key, text in parse_qsl(search.removeprefix("?"), keep_blank_values=True):
        if key in pairs:
            problems.append(f"{_shown(key)} must be given once: the first one was taken")
        pairs.setdefault(key, text)
    return pairs


def _check_version(text: str, problems: list[str]) -> None:
    if text == str(VERSION):
        return
    if text.isdecimal() and len(text) < 6 and int(text) > VERSION:
        problems.append(
            f"This link is of version {int(text)} and this page of version {VERSION}: "
            "what it understands was taken"
        )
    else:
        problems.append(f"The version of a link must be {VERSION}, got {_shown(text)}")


def _preset(name: str, problems: list[str]) -> str:
    try:
        if len(name) > LONGEST_VALUE:
            raise InputError
        presets.get(name)
    except InputError:
        problems.append(f"No preset is called {_shown(name)}: the default stands in")
        return "default"
    return name


def _choice(name: str, text: str, views: Mapping[str, Sequence[str]]) -> str:
    if name not in views:
        raise InputError(f"Nothing to look at is called {_shown(name)}")
    if text not in views[name]:
        raise InputError(f"{name} must be one of {', '.join(views[name])}, got {_shown(text)}")
    return text


def _setting(key: str, text: str, problems: list[str]) -> tuple[str, Any]:
    """Path and value of one setting; both can be used."""
    if key not in _PATHS:
        raise InputError(f"No setting of a link is called {_shown(key)}")
    path, trial = _PATHS[key], Scenario()
    _, parameter = trial.find(path)
    if isinstance(parameter, Text):
        raise InputError(_own_file(path) if text == OWN_FILE else _no_file(path, text))
    value: Any = text
    if isinstance(parameter, Tables):
        value, own = layers(text)
        if own:
            problems.append(_own_file(path))
    elif len(text) > LONGEST_VALUE:
        raise InputError(f"{path} must have at most {LONGEST_VALUE} characters, got {len(text)}")
    trial.set(path, value)
    return path, _value(trial, path)


def _own_file(path: str) -> str:
    what, instead = _FILES[path]
    return (
        f"The {what} came from a file of the sender's own, which a link cannot carry: "
        f"here it is {instead}"
    )


def _no_file(path: str, text: str) -> str:
    return f"{path} must not be named in a link, got {_shown(text)}: no file is read for one"


def _value(scenario: Scenario, path: str) -> Any:
    part, _ = scenario.find(path)
    return getattr(part, path.partition(".")[2])


def _shown(text: str) -> str:
    """Somebody else's text in a sentence: short, and without control characters."""
    return repr(text if len(text) <= 40 else text[:39] + "…")
