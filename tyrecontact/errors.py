"""What the package raises when it is asked for something it cannot do."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

#: signs of somebody's value in a sentence
_LONGEST = 80


class TyreContactError(Exception):
    """Base of every error that tyrecontact raises on purpose."""


class InputError(TyreContactError, ValueError):
    """A value, a name or a file that cannot be used; the message is one sentence."""


def shown(value: object) -> str:
    """A value as Python writes it, cut short: a sentence is no place for a megabyte."""
    text = repr(value)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def unknown_name(kind: str, name: object, known: Iterable[str]) -> InputError:
    """The error for a wrong name: it lists the right ones and points at the nearest.

    Parameters: `kind` what was looked for ("preset", "setting of loading"), `name` what was
    asked, `known` the names that exist.
    """
    names = sorted(known)
    nearest = get_close_matches(str(name)[:_LONGEST], names, n=1, cutoff=0.5)
    listed = ", ".join(known_name or "'' (none)" for known_name in names)
    hint = f" (did you mean {nearest[0]!r}?)" if nearest else ""
    return InputError(f"{kind} must be one of {listed}, got {shown(name)}{hint}")
