r"""Adhesion laws whose bonds form and break in time (physics, section 8): Bell and Evans' kinetics
of bonds, and a contact that recedes by fracture (Johnson, Kendall and Roberts; Gent and Schultz).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.special import exp1

from tyrecontact.contact.adhesion import require_not_negative
from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.interface import Hinged, Interface, Mirrored
from tyrecontact.road.springs import Springs

#: a contact of which less than this share of the bonds is left has broken
_LEAST_FRACTION = 0.01
#: e to this is the largest rate that is told from infinity
_LARGEST_EXPONENT = 700.0
_HALVINGS = 40
#: share of the bonds that may break in a step before their rate counts as changing in it
_MANY = 0.01
#: stands for zero where one divides by it
_NOTHING = 1e-200
#: a crack of infinite speed moves at this excess of G over w, too
_LEAST_EXCESS = 1e-16
#: places where a receding contact is looked at for rest
_PLACES = 33


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
    """What db/dt = -b exp(x / b) makes of a share in a time: E_1(x / b) falls at the rate 1."""
    goal = exp1(pull / share) - time
    low, high = np.zeros_like(share), share
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        enough = exp1(pull / middle) >= goal
        low, high = np.where(enough, low, middle), np.where(enough, middle, high)
    return high


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
        require_not_negative("work_of_adhesion", self.work_of_adhesion, "J/m2")

    def interface(self, springs: Springs, bonds: Bonds) -> Interface:
        if self.work_of_adhesion == 0:
            return Mirrored(springs, bonds.bonded)
        return Hinged(springs, bonds.bonded, bonds.reach)

    def toughness(self, bonds: Bonds) -> np.ndarray:
        """w of each contact [J/m2]."""
        return self.work_of_adhesion * (1 + self.ageing * np.log1p(bonds.age / self.ageing_time))

    def broken(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        opening = self._opening(springs, bonds, outcome)
        if opening.any():  # few can shrink to nothing in a step; only those are looked into
            left = springs.radius(bonds.reach) - self._lost(springs, bonds, outcome, opening)
            opening &= left <= springs.radius(np.zeros_like(left))
        if opening.any():
            opening[opening] = self._receded(springs, bonds, outcome, opening) <= 0
        return opening

    def after(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> Bonds:
        bonded = (bonds.bonded | (outcome.force > 0)) & (self.work_of_adhesion > 0)
        moved = bonds.after(outcome, bonded)
        reach = springs.onset(moved.reach)  # pressing on at constant area moves no crack
        opening = self._opening(springs, bonds, outcome)
        if opening.any():
            reach[opening] = self._receded(springs, bonds, outcome, opening)
        return replace(moved, reach=reach)

    def _opening(self, springs: Springs, bonds: Bonds, outcome: Outcome) -> np.ndarray:
        """Where the crack moves: bonded and pulled, with G > w."""
        release = _energy_release_rate(springs, bonds.reach, outcome.compression)
        pulled = bonds.bonded & (outcome.compression < bonds.reach)
        pulled |= bonds.bonded & (outcome.force < 0)
        return pulled & (release > self.toughness(bonds))

    def _receded(
        self, springs: Springs, bonds: Bonds, outcome: Outcome, opening: np.ndarray
    ) -> np.ndarray:
        """Compression of the area that is left [m] of the opening contacts; 0 where none is."""
        left = (springs.radius(bonds.reach) - self._lost(springs, bonds, outcome, opening))[opening]
        springs = springs.take(np.flatnonzero(opening))
        start, depth = bonds.reach[opening], outcome.compression[opening]
        end = _at_radius(springs, left, start)
        return _first_rest(springs, start, end, depth, self.toughness(bonds)[opening])

    def _lost(
        self, springs: Springs, bonds: Bonds, outcome: Outcome, opening: np.ndarray
    ) -> np.ndarray:
        """How far the cracks that open would move in the step at the speed they have [m]."""
        release = _energy_release_rate(springs, bonds.reach, outcome.compression)
        excess = np.where(opening, release / self.toughness(bonds) - 1, 1.0)
        with np.errstate(over="ignore"):  # beyond all bounds is fast enough
            speed = self.crack_speed * np.maximum(excess, _LEAST_EXCESS) ** (
                1 / self.crack_exponent
            )
        return np.where(opening, speed * outcome.time_step, 0.0)


def _at_radius(springs: Springs, radius: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Smallest compression [m] with at least a radius [m], at most `start`; 0 if all have it."""
    low, high = np.zeros_like(start), start
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        enough = springs.radius(middle) >= radius
        low, high = np.where(enough, low, middle), np.where(enough, middle, high)
    return np.where(springs.radius(np.zeros_like(start)) >= radius, 0.0, high)


def _first_rest(
    springs: Springs, start: np.ndarray, end: np.ndarray, depth: np.ndarray, tough: np.ndarray
) -> np.ndarray:
    """Where a crack that moves from `start` to `end` [m] first meets G <= w, or `end`."""
    places = start - np.linspace(0, 1, _PLACES)[:, None] * (start - end)
    rests = _energy_release_rate(springs, places, depth) <= tough
    rests[0] = False  # it moves there
    found, first = rests.any(axis=0), np.maximum(rests.argmax(axis=0), 1)
    if not found.any():
        return end
    column = np.arange(start.size)
    moving, resting = places[first - 1, column], places[first, column]
    for _ in range(_HALVINGS):
        middle = (moving + resting) / 2
        stops = _energy_release_rate(springs, middle, depth) <= tough
        moving, resting = np.where(stops, moving, middle), np.where(stops, middle, resting)
    return np.where(found, resting, end)


def _energy_release_rate(
    springs: Springs, reach: np.ndarray, compression: np.ndarray
) -> np.ndarray:
    """G [J/m2] at the edge of contacts of the area at `reach` [m], pulled to `compression` [m]."""
    radius = springs.radius(reach)
    release = springs.punch_stiffness_slope(reach) * (compression - reach) ** 2
    return np.where(radius > 0, release / (4 * np.pi * np.where(radius > 0, radius, 1.0)), 0.0)
