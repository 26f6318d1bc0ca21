r"""Roughness springs: force against compression of each element's small scale (physics, section 2).

At compression delta an element touches with the area A(delta) of its heights above
z_max - delta, taken as one circular punch of radius a = sqrt(A / pi) on a layer as thick as
what is left, h(delta) = z_max - delta - z_min. With kappa(a / h) of that punch (road/punch.py)

    k(delta) = 2 E a kappa / (1 - nu^2),    F(delta) = int_0^delta k    ("tangent")
"""

from __future__ import annotations

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.punch import stiffness_exponent, stiffness_factor
from tyrecontact.road.spring_tables import Springs, graded, linear, tabulated

__all__ = ["Springs", "exchange_stiffest", "from_heights", "linear"]


def from_heights(heights: np.ndarray, pitch: float, youngs_modulus: float) -> Springs:
    """Springs of elements from all their heights: true punch solution, tangent, monotone.

    Parameters
    ----------
    heights : [m], shape (elements, pixels of an element).
    pitch : side of a pixel [m]; also the least thickness of the layer under the punch.
    youngs_modulus : of the (incompressible) rubber at small scale [Pa].

    Returns
    -------
    Springs with F(0) = 0 and k(0) = 0, k non-decreasing; beyond full compression k stays.

    Raises
    ------
    InputError : elements without any height difference, or a modulus that is not positive.

    Source: physics.md section 2; thesis, chapter 3.2.
    """
    if not 0 < youngs_modulus < np.inf:
        raise InputError(f"youngs_modulus of the springs must be positive, got {youngs_modulus} Pa")
    below_top = np.sort(heights.max(axis=-1, keepdims=True) - heights, axis=-1)
    full = below_top[:, -1:]
    depth = float(full.max())
    if not depth > 0:
        raise InputError("road must be rough inside its elements, got elements that are all flat")
    delta = graded(depth)
    touching = np.array([np.searchsorted(row, delta, side="left") for row in below_top])
    radius = pitch * np.sqrt(touching / np.pi)
    ratio = radius / np.maximum(full - delta, pitch)
    per_radius = 8 / 3 * youngs_modulus * stiffness_factor(ratio)
    slope = per_radius * (1 + stiffness_exponent(ratio))
    contact = np.stack([radius, per_radius * radius, slope], axis=-1)
    return tabulated(depth, contact[..., 1], contact, tangent=True)


def exchange_stiffest(springs: Springs, count: int, compression: float) -> Springs:
    """The `count` stiffest springs, each replaced by one of the `count` next in the ranking.

    Parameters
    ----------
    count : number of springs to replace, at most half of them; 0 changes nothing.
    compression : [m] at which the springs are ranked by their force.

    Source: thesis, chapter 4.2.2 (80 springs, ranked at 9 um).
    """
    if not 0 <= 2 * count <= springs.count:
        half = springs.count // 2
        raise InputError(f"exchange_count must lie between 0 and {half}, got {count}")
    if count == 0:
        return springs
    ranking = np.argsort(-springs.force(np.full(springs.count, compression)), kind="stable")
    index = np.arange(springs.count)
    index[ranking[:count]] = ranking[count : 2 * count]
    return springs.take(index)
