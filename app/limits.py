"""What a public server allows a visitor: read from the environment, refused in one sentence.

    TYRECONTACT_MAX_SESSIONS   visitors at once; more see a page that says so
    TYRECONTACT_MAX_RUNS       runs computed at once; the others queue. Apart from them as many
                               inputs and roads are prepared for the eye at once
    TYRECONTACT_MAX_STEPS      time steps of a run
    TYRECONTACT_MAX_ELEMENTS   elements along a side of the patch
    TYRECONTACT_MAX_SECONDS    wall clock of a run [s], pauses and waiting not counted
    TYRECONTACT_MAX_UPLOAD     size of a road file [MB], 200 where not set

What is not set is not limited, but for uploads.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cache
from typing import Any

from tyrecontact import Simulation
from tyrecontact.errors import InputError

from .slots import SessionCount, Slots

_PREFIX = "TYRECONTACT_MAX_"
#: settings that lie between whole numbers
_REAL = ("seconds", "upload")


@dataclass(frozen=True)
class Limits:
    """What is allowed; None for no limit.

    Attributes
    ----------
    sessions, runs : at once.  steps : of a run.  elements : along a side of the patch.
    seconds : wall clock of a run [s], pauses and waiting not counted.
    upload : size of a file [MB].

    Raises
    ------
    InputError : a limit that is no positive number.
    """

    sessions: int | None = None
    runs: int | None = None
    steps: int | None = None
    elements: int | None = None
    seconds: float | None = None
    upload: float = 200.0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if value is not None and not 0 < value < math.inf:
                raise _no_limit(field.name, repr(value))

    @classmethod
    def from_environment(cls, environment: Mapping[str, str] = os.environ) -> Limits:
        """The limits that are set there.

        Raises
        ------
        InputError : a value that is no positive number.
        """
        found: dict[str, Any] = {}
        for field in fields(cls):
            text = environment.get(_PREFIX + field.name.upper(), "").strip()
            if text:
                found[field.name] = _number(field.name, text)
        return cls(**found)

    def check(self, simulation: Simulation) -> None:
        """Refuse what is too large, before anything is computed.

        Raises
        ------
        InputError : the limit, and what to lower, in one sentence.
        """
        elements = simulation.scenario.road.elements
        if self.elements is not None and elements > self.elements:
            raise InputError(
                f"road.elements must be at most {self.elements} on this server, got {elements}"
            )
        if self.steps is not None and len(simulation) > self.steps:
            raise InputError(
                f"a run must take at most {self.steps} steps on this server, got "
                f"{len(simulation)}: load faster or less deep, hold for a shorter time, or lower "
                "numerics.time_resolution_factor"
            )

    def check_upload(self, size: float) -> None:
        """Refuse a file of too many bytes.

        Raises
        ------
        InputError : the limit, in one sentence.
        """
        if size > self.upload * 1e6:
            raise InputError(
                f"a road file must have at most {self.upload:g} MB on this server, "
                f"got {size / 1e6:.3g} MB"
            )


def _number(name: str, text: str) -> float:
    try:
        return float(text) if name in _REAL else int(text)
    except ValueError:
        raise _no_limit(name, repr(text)) from None


def _no_limit(name: str, got: str) -> InputError:
    unit = {"seconds": " s", "upload": " MB"}.get(name, "")
    kind = "a positive number" if name in _REAL else "a whole number above 0"
    return InputError(f"{_PREFIX}{name.upper()} must be {kind}, got {got}{unit}")


@cache
def limits() -> Limits:
    """Those of this server, read once.  InputError : a value that is no positive number."""
    return Limits.from_environment()


@cache
def slots() -> Slots:
    """The queue of all runs on this server."""
    return Slots(limits().runs)


@cache
def preparing() -> Slots:
    """A queue for what is prepared for the eye: it does not wait for runs, nor they for it."""
    return Slots(limits().runs)


@cache
def sessions() -> SessionCount:
    """The visitors on this server."""
    return SessionCount(limits().sessions)
