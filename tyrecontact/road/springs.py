r"""Roughness springs: force against compression of each element's small scale (physics, section 2).

At compression delta an element touches with the area A(delta) of its heights above
z_max - delta, taken as one circular punch of radius a = sqrt(A / pi) on a layer as thick as
what is left, h(delta) = z_max - delta - z_min. With kappa(a / h) of that punch (road/punch.py)

    k(delta) = 2 E a kappa / (1 - nu^2),    F(delta) = int_0^delta k    ("tangent")

Springs are stored as one table, k piecewise cubic and F its exact antiderivative, on nodes
delta_j = depth (j / cells)^2 that are close where springs are soft.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator, PPoly

from tyrecontact.errors import InputError
from tyrecontact.road.punch import stiffness_factor

#: number of cells of the table of force against compression
_CELLS = 256


@dataclass(frozen=True)
class Springs:
    """Non-linear springs, one an element.

    Attributes
    ----------
    depth : compression [m] to which the table goes; each spring goes on with its last stiffness.
    energy_table : coefficients of U(delta) [J], shape (elements, cells + 1, 6): a polynomial in
        the distance from the cell's lower node, highest power first.
    """

    depth: float
    energy_table: np.ndarray

    @property
    def count(self) -> int:
        return self.energy_table.shape[0]

    def force(self, compression: np.ndarray) -> np.ndarray:
        """Force [N] at a compression [m] >= 0; last axis the elements."""
        return self._evaluate(compression, 1)

    def stiffness(self, compression: np.ndarray) -> np.ndarray:
        """Stiffness dF/d(delta) [N/m] at a compression [m] >= 0; last axis the elements."""
        return self._evaluate(compression, 2)

    def energy(self, compression: np.ndarray) -> np.ndarray:
        """Energy [J] held at a compression [m] >= 0; last axis the elements."""
        return self._evaluate(compression, 0)

    def force_and_stiffness(self, compression: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Force [N] and stiffness [N/m] in one look-up."""
        x, c = self._look_up(compression)
        force = (((5 * c[..., 0] * x + 4 * c[..., 1]) * x + 3 * c[..., 2]) * x + 2 * c[..., 3]) * x
        stiffness = ((20 * c[..., 0] * x + 12 * c[..., 1]) * x + 6 * c[..., 2]) * x + 2 * c[..., 3]
        return force + c[..., 4], stiffness

    def take(self, index: np.ndarray) -> Springs:
        """Springs with element i given spring `index[i]`."""
        return Springs(self.depth, self.energy_table[index])

    def _look_up(self, compression: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        cells = self.energy_table.shape[1] - 1
        share = np.minimum(compression / self.depth, 1.0)
        cell = (np.sqrt(share) * cells).astype(int)
        x = compression - self.depth * (cell / cells) ** 2
        return x, self.energy_table[np.arange(self.count), cell]

    def _evaluate(self, compression: np.ndarray, derivative: int) -> np.ndarray:
        x, c = self._look_up(np.asarray(compression, float))
        powers = np.arange(5, -1, -1)
        for _ in range(derivative):
            c, powers = (c * powers)[..., :-1], powers[:-1] - 1
        value = np.zeros_like(x)
        for i in range(c.shape[-1]):
            value = value * x + c[..., i]
        return value


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
    delta = depth * np.linspace(0, 1, _CELLS + 1) ** 2
    touching = np.array([np.searchsorted(row, delta, side="left") for row in below_top])
    radius = pitch * np.sqrt(touching / np.pi)
    thickness = np.maximum(full - delta, pitch)
    stiffness = 8 / 3 * youngs_modulus * radius * stiffness_factor(radius / thickness)
    return _tabulated(delta, stiffness)


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


def _tabulated(delta: np.ndarray, stiffness: np.ndarray) -> Springs:
    """The table of U from k at the nodes; shape of `stiffness` (elements, nodes)."""
    k: PPoly = PchipInterpolator(delta, stiffness, axis=1)
    energy = k.antiderivative(2)  # U'' = k, U(0) = U'(0) = 0
    cells = energy.c.transpose(2, 1, 0)  # scipy's (power, cell, element)
    last = np.zeros((stiffness.shape[0], 1, 6))
    end = delta[-1]
    last[:, 0, 3], last[:, 0, 4], last[:, 0, 5] = k(end) / 2, energy(end, 1), energy(end)
    return Springs(float(end), np.concatenate([cells, last], axis=1))
