"""Values of settings as the text of a link, and back: short, exact, without a quote."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.parts.tread import Layer
from tyrecontact.settings import parsed

from .link_keys import LAYER_KEYS

#: stands where a file of the sender's own was, which a link cannot carry
OWN_FILE = "*"
_BETWEEN_LAYERS, _BETWEEN_SETTINGS = "_", "~"
_LAYER_NAMES = {key: name for name, key in LAYER_KEYS.items()}


def written(value: Any) -> str:
    """A setting's value; tables are those of layers."""
    if isinstance(value, list):
        return _BETWEEN_LAYERS.join(_layer_written(layer) for layer in value)
    return value if isinstance(value, str) else shortest(value)


def shortest(number: float) -> str:
    """A number in as few characters as tell it from all others: 25e6, 3e-5, 0.6091."""
    plain = repr(number)
    mantissa, _, exponent = repr(float(number)).removeprefix("-").partition("e")
    whole, _, decimals = mantissa.partition(".")
    digits, power = whole + decimals, int(exponent or 0) - len(decimals)
    stripped = digits.rstrip("0")
    if not stripped:
        return "0"
    power += len(digits) - len(stripped)
    sign = "-" if number < 0 else ""
    scientific = f"{sign}{stripped.lstrip('0')}e{power}"
    exact = scientific if isinstance(number, float) else plain  # no int through a float
    return min(plain.removesuffix(".0"), exact, key=len)


def layers(text: str) -> tuple[list[dict[str, Any]], bool]:
    """Layers of a tread, unchecked, and whether one had a file of the sender's own.

    Raises
    ------
    InputError : a letter that is no setting's, one given twice, or the name of a file.
    """
    tables = [_layer_read(part) for part in text.split(_BETWEEN_LAYERS)] if text else []
    own = [table for table in tables if table.get("modulus_table") == OWN_FILE]
    for table in tables:
        if table.get("modulus_table", OWN_FILE) not in ("", OWN_FILE):
            raise InputError("modulus_table must not be named in a link: no file is read for one")
        if "modulus_table" in table or table.get("material") == "tabulated":
            table["modulus_table"] = ""
    return tables, bool(own)


def has_own_file(tables: Sequence[Mapping[str, Any]]) -> bool:
    """Whether a layer reads a file."""
    return any(table.get("modulus_table") for table in tables)


def _layer_written(layer: Mapping[str, Any]) -> str:
    parts = []
    for name, value in layer.items():
        if name != "modulus_table":
            parts.append(LAYER_KEYS[name] + written(value))
        elif value:
            parts.append(LAYER_KEYS[name] + OWN_FILE)
    return _BETWEEN_SETTINGS.join(parts)


def _layer_read(text: str) -> dict[str, Any]:
    table: dict[str, Any] = {}
    for part in text.split(_BETWEEN_SETTINGS):
        key, value = part[:1], part[1:]
        if key not in _LAYER_NAMES:
            raise unknown_name("letter of a layer's setting", key, _LAYER_NAMES)
        name = _LAYER_NAMES[key]
        if name in table:
            raise InputError(f"{name} of a layer must be given once, got it twice")
        table[name] = parsed(Layer.param[name], value)
    return table
