r"""Roughness springs: force against compression of each element's small scale (physics, section 2).

At compression delta an element touches with the area A(delta) of its heights above
z_max - delta, taken as one circular punch of radius a = sqrt(A / pi) on a layer as thick as
what is left, h(delta) = z_max - delta - z_min. With kappa(a / h) of that punch (road/punch.py)

    k_p(delta) = 2 E a kappa / (1 - nu^2),    nu = 1/2,

    F(delta) = int_0^delta k_p    ("tangent": each punch adds to what was pressed before)
    F(delta) = k_p delta          ("secant": the thesis' wording; a punch that was there always)
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy  # its parts are loaded where they are first used

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.road.punch import factor_and_exponent
from tyrecontact.road.simplification import exchange_stiffest, linearised, mean, standard
from tyrecontact.road.smoothing import convex_stiffness, polynomial_stiffness
from tyrecontact.road.spring_tables import Springs, graded, linear, tabulated

__all__ = [
    "Springs",
    "exchange_stiffest",
    "from_heights",
    "linear",
    "linearised",
    "mean",
    "standard",
]

READINGS, SMOOTHINGS = ("tangent", "secant"), ("monotone", "polynomial")
#: elements taken at a time: what is computed of so many stays near the processor
_BLOCK = 256
#: nodes that a curve must have to be smoothed
_FEWEST_NODES = 16


def from_heights(
    heights: np.ndarray,
    pitch: float,
    youngs_modulus: float,
    *,
    bonded: bool = False,
    reading: str = "tangent",
    smoothing: str = "monotone",
) -> Springs:
    """Springs of elements from all their heights, by the true solution of the punch.

    Parameters
    ----------
    heights : [m], shape (elements, pixels of an element).
    pitch : side of a pixel [m]; also the least thickness of the layer under the punch.
    youngs_modulus : of the (incompressible) rubber at small scale [Pa].
    bonded : the punch does not slip on the rubber.
    reading : "tangent" or "secant": the punch's stiffness as dF / d delta, or as F / delta.
    smoothing : "monotone" or "polynomial" (road/smoothing.py).

    Returns
    -------
    Springs with F(0) = 0, k >= 0 and never falling; beyond full compression k stays. What they
    call their punch's stiffness is that of the smoothed spring, k or F / delta.

    Raises
    ------
    InputError : elements without any height difference, a modulus that is not positive, an
        unknown reading or smoothing.

    Source: physics.md section 2; thesis, chapter 3.2.
    """
    _require_known("reading", reading, READINGS)
    _require_known("smoothing", smoothing, SMOOTHINGS)
    if not 0 < youngs_modulus < np.inf:
        raise InputError(f"youngs_modulus of the springs must be positive, got {youngs_modulus} Pa")
    depth = _depth(heights)
    blocks = (heights[first : first + _BLOCK] for first in range(0, len(heights), _BLOCK))
    punches = (_Punches.of(block, depth, pitch, youngs_modulus, bonded) for block in blocks)
    return _joined([_springs(punch, reading, smoothing) for punch in punches])


def _joined(parts: list[Springs]) -> Springs:
    """Springs of the same depth and reading, one after the other."""
    return Springs(
        parts[0].depth,
        np.concatenate([part.energy_table for part in parts]),
        np.concatenate([part.contact_table for part in parts]),
        parts[0].tangent,
    )


def _depth(heights: np.ndarray) -> float:
    """Largest height difference within an element [m]."""
    depth = float((heights.max(axis=-1) - heights.min(axis=-1)).max())
    if not depth > 0:
        raise InputError("road must be rough inside its elements, got elements that are all flat")
    return depth


def _springs(punch: _Punches, reading: str, smoothing: str) -> Springs:
    tangent = reading == "tangent"
    stiffness = _stiffness(punch, tangent, smoothing)
    springs = tabulated(float(punch.delta[-1]), stiffness, punch.table, tangent)
    springs.contact_table[..., 1] = stiffness
    if not tangent:
        force = springs.energy_table[..., 4]  # U' at the nodes
        springs.contact_table[:, 1:, 1] = force[:, 1:] / punch.delta[1:]
    return springs


def _require_known(what: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise unknown_name(f"{what} of springs", value, known)


@dataclass(frozen=True)
class _Punches:
    """The punch of each element at the nodes `delta` [m]; `full` compression [m] of each.

    `table` holds radius, stiffness and slope, shape (elements, nodes, 3).
    """

    delta: np.ndarray
    full: np.ndarray
    table: np.ndarray

    @classmethod
    def of(
        cls, heights: np.ndarray, depth: float, pitch: float, youngs_modulus: float, bonded: bool
    ) -> _Punches:
        below_top = np.sort(heights.max(axis=-1, keepdims=True) - heights, axis=-1)
        full, delta = below_top[:, -1], graded(depth)
        touching = np.array([np.searchsorted(row, delta, side="left") for row in below_top])
        radius = pitch * np.sqrt(touching / np.pi)
        ratio = radius / np.maximum(full[:, None] - delta, pitch)
        factor, exponent = factor_and_exponent(ratio, bonded=bonded)
        per_radius = 8 / 3 * youngs_modulus * factor
        slope = per_radius * (1 + exponent)
        return cls(delta, full, np.stack([radius, per_radius * radius, slope], axis=-1))


def _stiffness(punch: _Punches, tangent: bool, smoothing: str) -> np.ndarray:
    """k [N/m] of the springs at the nodes, shape (elements, nodes)."""
    own = punch.table[..., 1]
    if tangent and smoothing == "monotone":
        return own  # the punch only grows and the layer only thins: it never falls
    if tangent:
        force = scipy.integrate.cumulative_trapezoid(own, punch.delta, axis=1, initial=0)
    else:
        force = own * punch.delta
    # an element all but flat is fully compressed at once: its last stiffness is all there is
    full = np.maximum(punch.full, punch.delta[_FEWEST_NODES])
    smooth = convex_stiffness if smoothing == "monotone" else polynomial_stiffness
    return smooth(punch.delta, force, full)
