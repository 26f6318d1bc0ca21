"""The question: every setting of a run, its parts put together.

The settings themselves are declared once, in `parts/`; from that come validation, command-line
options, files and the page's controls.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from copy import deepcopy
from pathlib import Path
from typing import Any

import param

from tyrecontact.errors import InputError, shown, unknown_name
from tyrecontact.parts.process import Adhesion, Loading, Numerics
from tyrecontact.parts.road import Road, Springs
from tyrecontact.parts.tread import Tread
from tyrecontact.settings import Group, Part, parsed


class Scenario(Part):
    """All settings of a run.

    Parts are attributes (`scenario.loading.rate`), or keyword arguments of dictionaries:
    `Scenario(loading={"rate": 0.01}, numerics={"kernel": "static"})`.

    Raises
    ------
    InputError : an unknown part or setting, or a value that is out of bounds or of a wrong kind.
    """

    road = Group(Road)
    springs = Group(Springs)
    tread = Group(Tread)
    loading = Group(Loading)
    adhesion = Group(Adhesion)
    numerics = Group(Numerics)

    PARTS = ("road", "springs", "tread", "loading", "adhesion", "numerics")

    def __init__(self, /, **parts: Mapping[str, Any]) -> None:
        super().__init__()
        for part, values in parts.items():
            if part not in self.PARTS:
                raise unknown_name("part of a scenario", part, self.PARTS)
            if not isinstance(values, Mapping):
                raise InputError(f"{part} must be a table of settings, got {shown(values)}")
            for name, value in values.items():
                self.set(f"{part}.{name}", value)

    def set(self, path: str, value: Any) -> None:
        """Set one setting by its path, such as "loading.rate"; a text is parsed."""
        part, parameter = self.find(path)
        if isinstance(value, str):
            value = parsed(parameter, value)
        setattr(part, path.partition(".")[2], value)

    def find(self, path: str) -> tuple[Part, param.Parameter]:
        """The part and the declaration of a setting, from its path."""
        part_name, _, name = path.partition(".")
        if part_name not in self.PARTS:
            raise unknown_name("part of a scenario", part_name, self.PARTS)
        part = getattr(self, part_name)
        names = [known for known in part.param if known != "name"]
        if name not in names:
            raise unknown_name(f"setting of {part_name}", name, names)
        return part, part.param[name]

    def settings(self) -> Iterator[tuple[str, param.Parameter, Any]]:
        """Every setting: path, declaration, value."""
        for part_name in self.PARTS:
            part = getattr(self, part_name)
            for name in part.param:
                if name != "name":
                    yield f"{part_name}.{name}", part.param[name], getattr(part, name)

    def to_dict(self) -> dict[str, dict[str, Any]]:
        """Nested plain values; `Scenario(**scenario.to_dict())` is an equal scenario."""
        result: dict[str, dict[str, Any]] = {part: {} for part in self.PARTS}
        for path, _, value in self.settings():
            part, _, name = path.partition(".")
            result[part][name] = deepcopy(value)  # tables are nobody else's to change
        return result

    def file_stamps(self) -> list[tuple[str, int, int]]:
        """Name, time of change [ns] and size [B] of each file that is named, where there is one.

        A file may change under its name: what was made of it is good while its stamp stays.
        """
        layers = [layer.get("modulus_table", "") for layer in self.tread.layers]
        names = [self.road.file, self.loading.table, self.tread.modulus_table, *layers]
        stamps = []
        for name in filter(None, names):
            try:
                found = Path(name).expanduser().stat()
            except (OSError, ValueError, RuntimeError):  # refused where it is read
                continue
            stamps.append((name, found.st_mtime_ns, found.st_size))
        return stamps

    def copy(self) -> Scenario:
        """An equal scenario that shares nothing with this one."""
        return Scenario(**self.to_dict())


def read_tables(path: Path) -> dict[str, Any]:
    """The tables of a TOML file.

    Raises
    ------
    InputError : a file that is absent or not TOML.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"scenario file must be readable, got {path}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"scenario file must be TOML, got {path}: {error}") from None
