"""A scenario as what gives the same run elsewhere: a Python script, a command line, a TOML file.

Each names the preset and says only what differs from it, in SI units and to the last digit.
"""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from pathlib import PurePath
from pprint import pformat
from typing import Any

import tomli_w

from tyrecontact import Scenario, presets
from tyrecontact.settings import Text

#: where the run of a script or of a command line is written
OUTPUT = "run.nc"
_BREAK = " \\\n  "
_WIDTH = 88


def changes(preset: str, scenario: Scenario) -> dict[str, Any]:
    """What differs from a preset: path of a setting -> its value, in the declared order.

    Raises
    ------
    InputError : no preset has that name.
    """
    base = {path: value for path, _, value in presets.get(preset).settings()}
    return {path: value for path, _, value in scenario.settings() if value != base[path]}


def without_folders(scenario: Scenario) -> Scenario:
    """A copy whose files go by their names alone: the server's folders are nobody else's."""
    copy = scenario.copy()
    for path, parameter, value in scenario.settings():
        if isinstance(parameter, Text) and value:
            copy.set(path, _name(value))
    copy.tread.layers = [
        {**layer, **({"modulus_table": _name(table)} if (table := _table(layer)) else {})}
        for layer in scenario.tread.layers
    ]
    return copy


def files(scenario: Scenario) -> dict[str, str]:
    """Files that a scenario reads: what asks for it -> the file."""
    found = {path: value for path, p, value in scenario.settings() if isinstance(p, Text) and value}
    for number, layer in enumerate(scenario.tread.layers, start=1):
        if _table(layer):
            found[f"layer {number} of tread.layers"] = _table(layer)
    return found


def python(preset: str, scenario: Scenario) -> str:
    """A script that runs a scenario and writes the run."""
    lines = [
        "import tyrecontact as tc",
        "",
        *_notes(scenario),
        f"scenario = tc.presets.get({_quoted(preset)})",
        *(_setting(path, value) for path, value in changes(preset, scenario).items()),
        "",
        "results = tc.Simulation(scenario).run()",
        f"results.to_xarray().to_netcdf({_quoted(OUTPUT)})",
    ]
    return "\n".join(lines) + "\n"


def command_line(preset: str, scenario: Scenario) -> str:
    """A command for a shell (POSIX) that runs a scenario and writes the run."""
    words = [f"tyrecontact run {shlex.quote(preset)}"]
    for path, value in changes(preset, scenario).items():
        words.append(f"--set {shlex.quote(f'{path}={_text(value)}')}")
    return _BREAK.join([*words, f"--output {OUTPUT}"]) + "\n"


def toml(preset: str, scenario: Scenario) -> str:
    """A file for `tyrecontact run FILE.toml`."""
    tables: dict[str, Any] = {"preset": preset}
    for path, value in changes(preset, scenario).items():
        part, _, name = path.partition(".")
        tables.setdefault(part, {})[name] = value
    notes = _notes(scenario)
    return "\n".join([*notes, ""] if notes else []) + tomli_w.dumps(tables)


def _setting(path: str, value: Any) -> str:
    if isinstance(value, list):
        value = pformat(value, width=_WIDTH, sort_dicts=False)
        return f"scenario.set(\n    {_quoted(path)},\n{_indented(value)},\n)"
    literal = _quoted(value) if isinstance(value, str) else repr(value)
    return f"scenario.set({_quoted(path)}, {literal})"


def _indented(text: str) -> str:
    return "\n".join(f"    {line}" for line in text.splitlines())


def _text(value: Any) -> str:
    """A value as the command line reads it."""
    return json.dumps(value) if isinstance(value, list) else str(value)


def _quoted(text: str) -> str:
    """A text as Python writes it, in double quotes where that is all the difference."""
    written = repr(text)
    return f'"{text}"' if written == f"'{text}'" and '"' not in text else written


def _notes(scenario: Scenario) -> list[str]:
    """What the reader must do before it runs."""
    return [
        f"# {what} reads {_quoted(file)}: give the path of your copy"
        for what, file in files(scenario).items()
    ]


def _table(layer: Mapping[str, Any]) -> str:
    return str(layer.get("modulus_table", ""))


def _name(file: str) -> str:
    return PurePath(file).name
