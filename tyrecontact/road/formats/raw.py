"""What a reader of a format hands on: numbers, and the facts the file carries about them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road import scan

#: height that stands for "missing" in ESRI grids and their kin
NO_DATA = -9999.0


@dataclass(frozen=True)
class Asked:
    """What the user gave: pitch [m] and unit, None where not given."""

    pitch: float | None = None
    unit: str | None = None

    @property
    def step(self) -> float | None:
        """The given pitch in the given unit [-]; None if either is not given."""
        if self.pitch is None or self.unit is None:
            return None
        return self.pitch / scan.UNITS[self.unit]


@dataclass(frozen=True)
class Raw:
    """Numbers of a file, and what it says about them.

    Attributes
    ----------
    heights : in the file's unit, shape (ny, nx) or (n,), NaN where missing.
    kind : of the file.
    unit : name of the heights' unit; None if the file does not carry it.
    scale : metres per unit; None with `unit`.
    pitch : distance of heights [m]; None if the file does not carry it.
    spacing : distance of heights in the (unnamed) unit of the heights; None if not carried.
    resampled : the pitch was chosen by the reader (or by the user), not measured at.
    done : what was understood or done, one clause each.
    """

    heights: np.ndarray
    kind: str
    unit: str | None = None
    scale: float | None = None
    pitch: float | None = None
    spacing: float | None = None
    resampled: bool = False
    done: tuple[str, ...] = ()


def require_size(heights: float, path: Path) -> None:
    """Refuse more heights than can be handled, before they are read."""
    if heights > scan.MAX_HEIGHTS:
        raise InputError(
            f"{path.name} must hold at most {scan.MAX_HEIGHTS:g} heights, got {heights:g}"
        )


def require_square(dx: float, dy: float, path: Path) -> None:
    """Refuse heights that are not equally spaced along x and y (to 0.1 %)."""
    if not abs(dx - dy) <= 1e-3 * max(dx, dy):
        raise InputError(
            f"heights must be equally spaced along x and y, got {path.name} with spacings "
            f"{dx:.6g} and {dy:.6g}"
        )
