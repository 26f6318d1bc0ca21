r"""Adhesion laws whose bonds form and break in time (physics, section 8): Bell and Evans' kinetics
of bonds, and a contact that recedes by fracture (Johnson, Kendall and Roberts; Gent and Schultz).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.special import exp1

from tyrecontact.contact.adhesion import hinged_at_reach, require_not_negative
from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.cracks import CrackTable
from tyrecontact.contact.interface import Interface, Mirrored
from tyrecontact.contact.latest import Latest
from tyrecontact.road.springs import Springs

#: a contact of which less than this share of the bonds is left has broken
_LEAST_FRACTION = 0.01
#: e to this is the largest rate that is told from infinity
_LARGEST_EXPONENT = 700.0
_MOST_ITERATIONS = 60
_ROUNDING = 1e-14
#: share of the bonds that may break in a step before their rate counts as changing in it
_MANY = 0.01
#: stands for zero where one divides by it
_NOTHING = 1e-200
#: a crack of infinite speed moves at this excess of G over w, too
_LEAST_EXCESS = 1e-16


@dataclass(frozen=True)
class BondKinetics:
    """db/dt = k_on (1 - b) [d >= 0] - k_off b exp(T / (b A_max sigma)), T the tension.

    b, the share of bonds that hold, moves by the exact solution for a constant T, or, where few
    break in a step, by that for a constant rate; below 0.01 the contact breaks.

    Attributes
    ----------
    binding_rate, unbinding_rate : k_on, k_off [1/s].
    bond_stress : sigma [Pa].

    Source: G. I. Bell, Science 200 (1978) 618; E. Evans, Annu. Rev. Biophys. 30 (2001) 105.
    """

    binding_rate: float
    unbinding_rate: float
    bond_stress: float

    def __post_init__(self) -> None:
        require_not_negative("binding_rate", self.binding_rate, "1/s")
        require_not_negative("unbinding_rate", self.unbinding_rate, "1/s")

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        return Mirrored(springs, bonds.bonded)

    def fraction(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        """Share of bonds [-] after the step."""
        return self._shares(springs, bonds, outcome)

    @cached_property
    def _shares(self) -> Latest[Springs, Bonds, Outcome, np.ndarray]:
        return Latest(self._fraction)

    def _fraction(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        tension = np.maximum(-outcome.force, 0.0)
        strength = np.pi * springs.radius(bonds.reach) ** 2 * self.bond_stress
        held = np.maximum(bonds.fraction, _NOTHING)
        exponent = np.where(tension > 0, tension / np.maximum(held * strength, _NOTHING), 0.0)
        if self.unbinding_rate > 0:
            exponent = exponent + np.log(self.unbinding_rate)
            off = np.exp(np.minimum(exponent, _LARGEST_EXPONENT))
        else:
            off = np.zeros_like(tension)
        on = self.binding_rate * (outcome.compression >= 0)
        total = on + off
        settled = on / np.where(total > 0, total, 1.0)
        share = settled + (bonds.fraction - settled) * np.exp(-total * outcome.time_step)
        many = np.flatnonzero((tension > 0) & (off * outcome.time_step > _MANY))
        if many.size:
            pull = tension[many] / np.maximum(strength[many], _NOTHING)
            share[many] = _share_left(held[many], pull, self.unbinding_rate * outcome.time_step)
        return share

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        weak = self.fraction(springs, bonds, outcome) < _LEAST_FRACTION
        return bonds.bonded & (outcome.force < 0) & weak

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        fraction = self.fraction(springs, bonds, outcome)
        bonded = bonds.bonded | (outcome.compression > 0)
        moved = bonds.after(outcome, bonded & (self.binding_rate > 0))
        return replace(moved, fraction=np.where(moved.bonded, fraction, 0.0))


def _share_left(share: np.ndarray, pull: np.ndarray, time: float) -> np.ndarray:
    """What db/dt = -b exp(x / b) makes of a share in a time: E_1(x / b) falls at the rate 1.

    Newton's method for z = x / b. E_1 in ln z and ln E_1 in z both fall ever more slowly, so
    that no step of either leads beyond the root: the larger one is taken.
    """
    z = pull / share
    goal = exp1(z) - time
    left = np.zeros_like(share)
    some = np.flatnonzero(goal > 0)
    z, goal = z[some], goal[some]
    for _ in range(_MOST_ITERATIONS):
        value, rate = exp1(z), np.exp(-z)  # -dE_1 / d ln z
        by_ln_z, by_ln_e = np.expm1((value - goal) / rate), np.log(value / goal) * value / rate
        further = np.maximum(by_ln_z, by_ln_e)
        z = z * (1 + further)
        if np.all(further <= _ROUNDING):
            break
    left[some] = pull[some] / z
    return left


@dataclass(frozen=True)
class RecedingContact:
    r"""A punch whose edge is a crack: F = F_L(c) + k(c) (d - c), c the compression of its area,

        G = k'(a) (d - c)^2 / (4 pi a),    -da/dt = v* (G / w - 1)^(1/n),
        w = w0 [1 + beta ln(1 + t_c / tau)]

    Within a step the contact shrinks at most to where G = w at the compression it has; where there
    is no such radius and it would shrink to nothing it lets go at once. A contact whose radius
    cannot shrink (a spring of constant area) lets go at G = w, that is at the tension
    sqrt(8 pi E* w a^3) on a half-space. The crack moves at the end of a step, and what that does
    to the force comes with the next one: short steps where a machine is soft.

    Attributes
    ----------
    work_of_adhesion : w0 [J/m2]; 0 is no adhesion, elements unload as they load.
    ageing : beta [-].  ageing_time : tau [s].
    crack_speed : v* [m/s], may be inf.  crack_exponent : n [-].

    Source: K. L. Johnson et al., Proc. R. Soc. A 324 (1971) 301; A. N. Gent and J. Schultz,
    J. Adhesion 3 (1972) 281.
    """

    work_of_adhesion: float
    ageing: float
    ageing_time: float
    crack_speed: float
    crack_exponent: float

    def __post_init__(self) -> None:
        require_not_negative("work_of_adhesion", self.work_of_adhesion, "J/m²")

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        if self.work_of_adhesion == 0:
            return Mirrored(springs, bonds.bonded)
        return self._hinged(springs, bonds)

    def toughness(self, bonds: Bonds) -> np.ndarray:
        """w of each contact [J/m2]."""
        return self.work_of_adhesion * (1 + self.ageing * np.log1p(bonds.age / self.ageing_time))

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        front, gone = self._front(springs, bonds, outcome), np.zeros(bonds.reach.size, bool)
        gone[front.element] = front.reach <= 0
        return gone

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        bonded = (bonds.bonded | (outcome.force > 0)) & (self.work_of_adhesion > 0)
        moved = bonds.after(outcome, bonded)
        reach = springs.onset(moved.reach)  # pressing on at constant area moves no crack
        front = self._front(springs, bonds, outcome)
        reach[front.element] = front.reach
        return replace(moved, reach=reach)

    @cached_property
    def _hinged(self) -> Latest[Springs, Bonds, Interface]:
        return Latest(hinged_at_reach)

    @cached_property
    def _cracks(self) -> Latest[Springs, CrackTable]:
        return Latest(CrackTable)

    @cached_property
    def _front(self) -> Latest[Springs, Bonds, Outcome, _Front]:
        return Latest(self._moved)

    def _moved(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> _Front:
        """The cracks that move, bonded and pulled with G > w, and where they get to."""
        table, tough = self._cracks(springs), self.toughness(bonds)
        pulled = (outcome.compression < bonds.reach) | (outcome.force < 0)
        element = np.flatnonzero(bonds.bonded & pulled)
        start, depth, tough = (x[element] for x in (bonds.reach, outcome.compression, tough))
        radius, release = table.radius_and_release(element, start, depth)
        moving = release > tough
        element, start, depth, tough, radius, release = (
            x[moving] for x in (element, start, depth, tough, radius, release)
        )
        with np.errstate(over="ignore"):  # beyond all bounds is fast enough
            excess = np.maximum(release / tough - 1, _LEAST_EXCESS)
            lost = self.crack_speed * excess ** (1 / self.crack_exponent) * outcome.time_step
        left = radius - lost
        return _Front(element, table.receded(element, radius, left, start, depth, tough))


@dataclass(frozen=True)
class _Front:
    """Elements whose crack moves, and the compression [m] of the area that is left; 0: none."""

    element: np.ndarray
    reach: np.ndarray
