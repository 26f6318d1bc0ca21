"""A measured road as its file holds it: a map or a profile, with what is missing still missing."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tyrecontact.errors import InputError

#: metres per unit that may be given for heights (and for coordinates, where a file has them)
UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6}
#: a file with more heights than this is refused
MAX_HEIGHTS = 64_000_000


class NotCarriedError(InputError):
    """Pitch or unit must be given, since the file does not carry it.

    Attributes
    ----------
    missing : all that must be given, of "pitch" and "unit".
    """

    def __init__(self, message: str, missing: tuple[str, ...]) -> None:
        super().__init__(message)
        self.missing = missing


@dataclass(frozen=True)
class Scan:
    """Heights of a road as they were measured.

    Attributes
    ----------
    heights : z [m], shape (ny, nx) of a map or (n,) of a profile, positive up; NaN where missing.
    pitch : distance of neighbouring heights [m]; a height stands for pitch x pitch.
    name : of the file.
    kind : of the file, such as "text matrix".
    unit : of the heights in the file.
    pitch_origin, unit_origin : "file", or "given" (then perhaps against what the file says).
    missing_share : of the heights in the file [-].
    done : what was done to it, one clause each.

    Raises
    ------
    InputError : no map and no profile, no height at all, or a pitch that is not positive.
    """

    heights: np.ndarray
    pitch: float
    name: str = "road"
    kind: str = "array"
    unit: str = "m"
    pitch_origin: str = "given"
    unit_origin: str = "given"
    missing_share: float = 0.0
    done: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        shape = self.heights.shape
        if len(shape) not in (1, 2) or min(shape, default=0) < 2:
            raise InputError(
                "road file must hold a 2-D map of heights of at least 2 x 2, or a profile of at "
                f"least 2, got {self.name} with shape {shape}"
            )
        if not np.isfinite(self.heights).any():
            raise InputError(
                f"road file must hold heights, got {self.name}, where all {self.heights.size} "
                "are missing"
            )
        if not 0 < self.pitch < np.inf:
            raise InputError(f"pitch must be positive and finite, got {self.pitch} m")

    @property
    def is_profile(self) -> bool:
        """Whether it is one line of heights."""
        return self.heights.ndim == 1

    @property
    def extent(self) -> tuple[float, ...]:
        """Size (y, x) of a map, (x,) of a profile [m]: number of heights times pitch."""
        return tuple(count * self.pitch for count in self.heights.shape)

    @property
    def valid(self) -> np.ndarray:
        """Where there is a height, shape of `heights`."""
        return np.isfinite(self.heights)

    def changed(self, heights: np.ndarray, *clauses: str) -> Scan:
        """The same scan with other heights, and with what was done told."""
        return replace(self, heights=heights, done=(*self.done, *clauses))
