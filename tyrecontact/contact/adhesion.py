r"""When a bond lets go: the thesis' law, and laws that know area, age and rate (physics, 8).

An element is bonded once it has been pressed, and free again when its bond has broken; there is
no attraction at a distance. Laws differ in the way a bonded element is pulled (`interface`), in
what its bond bears (`broken`) and in what it remembers (`after`). Those whose bonds change in time
are in contact/kinetics.py.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.interface import Hinged, Interface, Mirrored
from tyrecontact.contact.latest import Latest
from tyrecontact.errors import InputError
from tyrecontact.road.springs import Springs


class Law(Protocol):
    """What holds road and tread together."""

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        """Force law of the elements while these bonds last."""

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        """Which bonds do not bear a step that ends so."""

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        """The bonds after that step."""


@dataclass(frozen=True)
class ReleaseForce:
    """The thesis' law: a bond breaks when its tension exceeds `release_force` [N].

    `release_force` is one number, or one an element; 0 N is no adhesion: nothing bonds.
    """

    release_force: float | np.ndarray

    def __post_init__(self) -> None:
        require_not_negative("release_force", self.release_force, "N")

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        return Mirrored(springs, bonds.bonded)

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        if not self._sticks:
            return bonds.bonded
        return bonds.bonded & (-outcome.force > self.release_force)

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        bonded = bonds.bonded
        if self._sticks:
            bonded = (bonded | (outcome.compression > 0)) & (np.asarray(self.release_force) > 0)
        return bonds.after(outcome, bonded)

    @cached_property
    def _sticks(self) -> bool:
        return bool(np.any(np.asarray(self.release_force) > 0))


def constant_limit(law: Law, element: int) -> float | None:
    """Tension that the bond of an element bears [N], where area, age and rate do not change it."""
    if not isinstance(law, ReleaseForce | Hysteresis):
        return None
    limits = np.atleast_1d(law.release_force)
    return float(limits[element % limits.size])


def table_limits(springs: Springs, release_force: float, step: float) -> np.ndarray:
    """Tension that each bond of the thesis really bears [N], shape (elements,).

    The thesis cuts each spring's table, of entries every `step` [m], at the last entry whose
    force is below the release force [N] (Appendix C.4).
    """
    low, high = np.zeros(springs.count), np.full(springs.count, springs.depth)
    while np.any(springs.force(high) < release_force):
        high = np.where(springs.force(high) < release_force, 2 * high, high)
    for _ in range(60):  # halvings: to rounding
        middle = (low + high) / 2
        above = springs.force(middle) >= release_force
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return springs.force(np.maximum(np.ceil(high / step) - 1, 0) * step)


@dataclass(frozen=True)
class Multiplicative:
    """A release force that grows with area, age and rate (thesis, chapter 5.4):

    F_rel = F0 (A_max / A0)^p [1 + beta ln(1 + t_c / tau)] [1 + (|dd/dt| / v0)^n]

    Attributes
    ----------
    release_force : F0 [N].  reference_area : A0 [m2].  area_exponent : p [-].
    ageing : beta [-].  ageing_time : tau [s].
    reference_rate : v0 [m/s]; inf for a force that no rate changes.  rate_exponent : n [-].
    """

    release_force: float
    area_exponent: float
    reference_area: float
    ageing: float
    ageing_time: float
    reference_rate: float
    rate_exponent: float

    def __post_init__(self) -> None:
        require_not_negative("release_force", self.release_force, "N")

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        return Mirrored(springs, bonds.bonded)

    def limit(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        """Tension that each bond bears [N]."""
        area = np.pi * springs.radius(bonds.reach) ** 2
        aged = 1 + self.ageing * np.log1p(bonds.age / self.ageing_time)
        rate = np.abs(outcome.compression - bonds.compression) / outcome.time_step
        hurried = 1 + (rate / self.reference_rate) ** self.rate_exponent
        if np.isinf(self.reference_rate):
            hurried = 1.0
        grown = (area / self.reference_area) ** self.area_exponent
        return self.release_force * grown * aged * hurried

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        return bonds.bonded & (-outcome.force > self.limit(springs, bonds, outcome))

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        bonded = (bonds.bonded | (outcome.compression > 0)) & (self.release_force > 0)
        return bonds.after(outcome, bonded)


@dataclass(frozen=True)
class Hysteresis:
    """Unloading along F_L(d_max) - k_u (d_max - d), k_u the punch of frozen area (thesis, Fig. 48).

    A bond breaks when its tension exceeds `release_force` [N], or where a bond of `ReleaseForce`
    would: one that was hardly pressed has hardly a stiffness, and would be drawn out without end.
    The dent that it leaves stays until the element is apart: pressed again before that, it
    reloads along the same line.
    """

    release_force: float

    def __post_init__(self) -> None:
        require_not_negative("release_force", self.release_force, "N")

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        return self._hinged(springs, bonds)

    @cached_property
    def _hinged(self) -> Latest[Springs, Bonds, Interface]:
        return Latest(hinged_at_reach)

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        drawn = springs.force(np.maximum(-outcome.compression, 0.0))
        tension = np.maximum(-outcome.force, np.where(outcome.force < 0, drawn, 0.0))
        return bonds.bonded & (tension > self.release_force)

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        bonded = (bonds.bonded | (outcome.force > 0)) & (self.release_force > 0)
        return bonds.after(outcome, bonded)


def hinged_at_reach(springs: Springs, bonds: Bonds) -> Interface:
    return Hinged(springs, bonds.bonded, bonds.reach)


def require_not_negative(name: str, value: float | np.ndarray, unit: str) -> None:
    if not np.all(np.asarray(value) >= 0):
        raise InputError(f"{name} must not be negative, got {value} {unit}")
