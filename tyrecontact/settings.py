"""Settings: values with a default, bounds, a unit and a meaning, declared once.

They are `param` parameters whose errors are one sentence with the unit in it. The unit, and the
unit they are shown in on a form, are their `metadata`.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from numbers import Real
from typing import Any, cast

import numpy as np
import param

from tyrecontact.errors import InputError, shown, unknown_name

#: one declaration for all scenarios: a copy of it for each takes longer than their values
_SHARED: dict[str, Any] = {"per_instance": False}


def _path(parameter: param.Parameter) -> str:
    """Part and name, "loading.rate"; a declaration's owner is a class, or an instance of it."""
    owner = parameter.owner
    if owner is None:
        return str(parameter.name)
    kind = owner if isinstance(owner, type) else type(owner)
    return f"{kind.__name__.lower()}.{parameter.name}"


class Quantity(param.Number):
    """A real number with bounds (inclusive) and a unit; `shown_in` = (unit, factor) for forms."""

    def __init__(
        self,
        default: float,
        bounds: tuple[float, float],
        unit: str,
        doc: str,
        shown_in: tuple[str, float] | None = None,
    ) -> None:
        metadata = {"unit": unit, "shown_in": shown_in or (unit, 1.0)}
        super().__init__(default=default, bounds=bounds, doc=doc, metadata=metadata, **_SHARED)

    def _validate(self, val: Any) -> None:
        low, high = cast(tuple[float, float], self.bounds)
        unit = _spaced(self.metadata["unit"])
        number = isinstance(val, Real) and not isinstance(val, bool)
        if not number or not low <= val <= high:
            raise InputError(
                f"{_path(self)} must be a number between {low:g} and {high:g}{unit}, "
                f"got {shown(val)}{unit if number else ''}"
            )


class Count(param.Integer):
    """A whole number with bounds (inclusive)."""

    def __init__(self, default: int, bounds: tuple[int, int], doc: str, unit: str = "") -> None:
        metadata = {"unit": unit, "shown_in": (unit, 1.0)}
        super().__init__(default=default, bounds=bounds, doc=doc, metadata=metadata, **_SHARED)

    def _validate(self, val: Any) -> None:
        low, high = cast(tuple[float, float], self.bounds)
        if not isinstance(val, int) or isinstance(val, bool) or not low <= val <= high:
            raise InputError(
                f"{_path(self)} must be a whole number between {low} and {high}, got {shown(val)}"
            )


class Choice(param.Selector):
    """One of a few names."""

    def __init__(self, default: str, names: list[str], doc: str) -> None:
        metadata = {"unit": "", "shown_in": ("", 1.0)}
        super().__init__(default=default, objects=names, doc=doc, metadata=metadata, **_SHARED)

    def _validate(self, val: Any) -> None:
        if not isinstance(val, str) or val not in self.objects:
            raise unknown_name(_path(self), val, self.objects)


class Text(param.String):
    """A text, such as the name of a file."""

    def __init__(self, default: str, doc: str) -> None:
        metadata = {"unit": "", "shown_in": ("", 1.0)}
        super().__init__(default=default, doc=doc, metadata=metadata, **_SHARED)

    def _validate(self, val: Any) -> None:
        if not isinstance(val, str):
            raise InputError(f"{_path(self)} must be a text, got {shown(val)}")


class Tables(param.Parameter):
    """A list of tables of settings, such as the layers of a tread; default: none.

    Parameters
    ----------
    called : what a table is called in a message ("layer").
    taken : a table checked, as a dictionary of plain values; raises InputError.
    """

    def __init__(self, called: str, taken: Callable[[Mapping[str, Any]], dict], doc: str) -> None:
        metadata = {"unit": "", "shown_in": ("", 1.0), "called": called, "taken": taken}
        super().__init__(default=[], instantiate=True, doc=doc, metadata=metadata, **_SHARED)

    def taken(self, val: Any) -> list[dict]:
        """The tables checked, and copied: later changes of `val` do not reach the setting."""
        if not isinstance(val, list | tuple) or not all(isinstance(t, Mapping) for t in val):
            raise InputError(f"{_path(self)} must be a list of tables, got {shown(val)}")
        tables = []
        for number, table in enumerate(val, start=1):
            try:
                tables.append(self.metadata["taken"](table))
            except InputError as error:
                called = self.metadata["called"]
                raise InputError(f"{called} {number} of {_path(self)}: {error}") from None
        return tables


def _plain(value: Any) -> Any:
    """A number as Python's own int or float: no other would survive a way through JSON."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Real) and not isinstance(value, int | float):
        return float(value)
    return value


class Part(param.Parameterized):
    """A group of settings; a misspelt one is refused, not taken as a new attribute."""

    def __init__(self, **settings: Any) -> None:
        for name in settings:
            self._require_known(name)
        super().__init__(**settings)

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):
            self._require_known(name)
            if isinstance(self.param[name], Tables):
                value = self.param[name].taken(value)
        super().__setattr__(name, _plain(value))

    def _require_known(self, name: str) -> None:
        if name not in self.param:
            known = [setting for setting in self.param if setting != "name"]
            raise unknown_name(f"setting of {type(self).__name__.lower()}", name, known)


class Group(param.ClassSelector):
    """A part of a scenario: each scenario has its own."""

    def __init__(self, kind: type[Part]) -> None:
        super().__init__(class_=kind, default=kind(), instantiate=True, **_SHARED)

    def _validate(self, val: Any) -> None:
        if not isinstance(val, self.class_):
            raise InputError(
                f"{self.name} must be a {cast(type, self.class_).__name__}, got {shown(val)}"
            )


def parsed(parameter: param.Parameter, text: str) -> Any:
    """The value that a text (of a command line) stands for, not yet checked against bounds."""
    if isinstance(parameter, Count):
        kind: Callable[[str], Any] = int
    elif isinstance(parameter, Quantity):
        kind = float
    elif isinstance(parameter, Tables):
        kind = json.loads
    else:
        return text
    try:
        return kind(text)
    except (ValueError, RecursionError):
        return text  # refused with a sentence when it is set


def _spaced(unit: str) -> str:
    return f" {unit}" if unit else ""
