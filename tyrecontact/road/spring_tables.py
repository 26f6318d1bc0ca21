r"""Springs as tables: what an element's spring answers at a compression (physics, section 2).

All springs share the nodes delta_j = depth (j / cells)^2, which are close where springs are soft.
Between them the energy U(delta) is a polynomial of the fifth degree, F = U' and k = F', and what
the adhesion laws ask of the punch (its radius, and what it would do with its area frozen) is
linear. Beyond the depth a spring goes on with its last stiffness and its last punch.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy.interpolate import PchipInterpolator, PPoly

from tyrecontact.errors import InputError
from tyrecontact.fast import loops

#: number of cells of the tables of springs that are made from heights
CELLS = 256


class Response(NamedTuple):
    """What springs answer: force [N], stiffness [N/m], energy [J]; shape (elements,) each."""

    force: np.ndarray
    stiffness: np.ndarray
    energy: np.ndarray


@dataclass(frozen=True)
class Springs:
    """Non-linear springs, one an element.

    Attributes
    ----------
    depth : compression [m] to which the tables go; each spring goes on with its last stiffness.
    energy_table : coefficients of U(delta) [J], shape (elements, cells + 1, 6): a polynomial in
        the distance from the cell's lower node, highest power first.
    contact_table : at the nodes, shape (elements, cells + 1, 3): radius a of the equivalent punch
        [m], stiffness k_p of a punch of that area frozen [N/m], and dk_p / da at frozen
        thickness of the layer under it [N/m2].
    tangent : the spring was read as the sum of its punches, k_p = k: then the stiffness is also
        that of the frozen punch, to the last digit.
    """

    depth: float
    energy_table: np.ndarray
    contact_table: np.ndarray
    tangent: bool = False

    @property
    def count(self) -> int:
        return self.energy_table.shape[0]

    @cached_property
    def nodes(self) -> np.ndarray:
        """Compressions of the tables' nodes [m], shape (cells + 1,)."""
        return graded(self.depth, self.energy_table.shape[1] - 1)

    def force(self, compression: np.ndarray) -> np.ndarray:
        """Force [N] at a compression [m] >= 0; last axis the elements."""
        return self._evaluate(compression, 1)

    def stiffness(self, compression: np.ndarray) -> np.ndarray:
        """Stiffness dF/d(delta) [N/m] at a compression [m] >= 0; last axis the elements."""
        return self._evaluate(compression, 2)

    def energy(self, compression: np.ndarray) -> np.ndarray:
        """Energy [J] held at a compression [m] >= 0; last axis the elements."""
        return self._evaluate(compression, 0)

    def respond(self, compression: np.ndarray, mirrored: np.ndarray) -> Response:
        """Force, stiffness and energy in one look-up; all arrays have shape (elements,).

        Parameters
        ----------
        compression : [m]; below zero a spring gives nothing,
        mirrored : but where it answers there as it does above, F(-d) = -F(d).
        """
        x, coefficients = self._look_up(np.abs(compression))
        energy, force, stiffness = (coefficients[0].copy() for _ in range(3))
        for power, coefficient in enumerate(coefficients[1:], start=1):
            energy *= x
            energy += coefficient
            if power < 5:  # Horner's scheme for the derivative, and for half the second one
                force *= x
                force += energy
            if power < 4:
                stiffness *= x
                stiffness += force
        active = (compression > 0) | mirrored
        force *= active
        energy *= active
        stiffness *= 2 * active
        return Response(np.copysign(force, compression, out=force), stiffness, energy)

    def radius(self, compression: np.ndarray) -> np.ndarray:
        """Radius a [m] of the equivalent punch at a compression [m] >= 0."""
        return self._between_nodes(compression, 0)

    def punch_stiffness(self, compression: np.ndarray) -> np.ndarray:
        """Stiffness k_p [N/m] at a compression [m] >= 0 while the area touched stays as it is."""
        if self.tangent:
            return self.stiffness(compression)
        return self._between_nodes(compression, 1)

    def punch_stiffness_slope(self, compression: np.ndarray) -> np.ndarray:
        """dk_p / da [N/m2] at a compression [m] >= 0, the layer's thickness frozen."""
        return self._between_nodes(compression, 2)

    def onset(self, compression: np.ndarray) -> np.ndarray:
        """Smallest compression [m] at which the radius is that of the given one [m] >= 0.

        The compression itself where the radius grows, the beginning of a plateau on one.
        """
        compression = np.asarray(compression, float)
        cell, x = self._cell(compression)
        element = np.arange(self.count)
        on_plateau = self._level[element, cell] | (x == 0) | (cell == self._level.shape[1] - 1)
        return np.where(on_plateau, self._plateau_start[element, cell], compression)

    def take(self, index: np.ndarray) -> Springs:
        """Springs with element i given spring `index[i]`."""
        return Springs(
            self.depth, self.energy_table[index], self.contact_table[index], self.tangent
        )

    @cached_property
    def _level(self) -> np.ndarray:
        """Whether the radius stays the same across the cell above a node."""
        radius = self.contact_table[..., 0]
        return np.diff(radius, axis=1, append=np.inf) == 0

    @cached_property
    def _plateau_start(self) -> np.ndarray:
        """The lowest node [m] with the radius of this one, all nodes between them included."""
        level, nodes = self._level, self.nodes
        starts = np.ones(level.shape, bool)
        starts[:, 1:] = ~level[:, :-1]
        first = np.maximum.accumulate(np.where(starts, np.arange(nodes.size), 0), axis=1)
        return nodes[first]

    @cached_property
    def cells(self) -> np.ndarray:
        """`energy_table` in one piece of memory, as look-ups want it."""
        return np.ascontiguousarray(self.energy_table)

    @cached_property
    def _contact_cells(self) -> np.ndarray:
        return np.ascontiguousarray(self.contact_table)

    @cached_property
    def _first_row(self) -> np.ndarray:
        """Number of each element's first cell among all cells of all elements."""
        return np.arange(self.count) * self.energy_table.shape[1]

    @cached_property
    def _widths(self) -> np.ndarray:
        """Of the cells [m]; beyond the last node nothing changes, however wide that cell."""
        return np.append(np.diff(self.nodes), self.depth)

    def _cell(self, compression: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Number of the cell, and the distance from its lower node [m]."""
        place = np.minimum(compression / self.depth, 1.0)
        np.sqrt(place, out=place)
        place *= self.energy_table.shape[1] - 1
        cell = place.astype(np.intp)
        return cell, compression - self.nodes.take(cell)

    def _look_up(self, compression: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Distance from the cell's node [m], and the coefficients of U, powers first."""
        cell, x = self._cell(compression)
        rows = self.cells.reshape(-1, self.cells.shape[2]).take(cell + self._first_row, axis=0)
        return x, np.ascontiguousarray(rows.transpose(-1, *range(rows.ndim - 1)))

    def _between_nodes(self, compression: np.ndarray, column: int) -> np.ndarray:
        compression = np.asarray(compression, float)
        fast = loops()
        if fast is not None and compression.shape == (self.count,):
            table = self._contact_cells
            return np.asarray(fast.between_nodes(table, column, self.depth, compression))
        cell, x = self._cell(compression)
        flat, columns = self._contact_cells.reshape(-1), self.contact_table.shape[2]
        here = (cell + self._first_row) * columns + column
        low = flat.take(here)
        rise = flat.take(here + columns * (cell < self.nodes.size - 1)) - low
        rise *= np.minimum(x / self._widths.take(cell), 1.0)
        rise += low
        return rise

    def _evaluate(self, compression: np.ndarray, derivative: int) -> np.ndarray:
        x, coefficients = self._look_up(np.asarray(compression, float))
        for _ in range(derivative):
            powers = np.arange(len(coefficients) - 1, 0, -1)
            coefficients = coefficients[:-1] * powers.reshape(-1, *[1] * x.ndim)
        value = coefficients[0].copy()
        for coefficient in coefficients[1:]:
            value *= x
            value += coefficient
        return value


def graded(depth: float, cells: int = CELLS) -> np.ndarray:
    """Nodes depth (j / cells)^2 [m], shape (cells + 1,)."""
    return depth * (np.arange(cells + 1) / cells) ** 2


def tabulated(
    depth: float, stiffness: np.ndarray, contact_table: np.ndarray, tangent: bool
) -> Springs:
    """Springs from k [N/m] at the nodes, shape (elements, cells + 1), monotone between them."""
    delta = graded(depth, stiffness.shape[1] - 1)
    k: PPoly = PchipInterpolator(delta, stiffness, axis=1)
    energy = k.antiderivative(2)  # U'' = k, U(0) = U'(0) = 0
    cells = energy.c.transpose(2, 1, 0)  # scipy's (power, cell, element)
    last = np.zeros((stiffness.shape[0], 1, 6))
    last[:, 0, 3], last[:, 0, 4], last[:, 0, 5] = k(depth) / 2, energy(depth, 1), energy(depth)
    table = np.ascontiguousarray(np.concatenate([cells, last], axis=1))
    return Springs(depth, table, contact_table, tangent)


def linear(stiffness: np.ndarray, depth: float, radius: float | np.ndarray) -> Springs:
    """Springs of constant stiffness, each a flat punch that touches wholly from the start.

    Parameters
    ----------
    stiffness : [N/m], one an element.
    depth : compression [m] to which the table goes (it changes nothing).
    radius : of the punch [m], a number or one an element. k_p = k and dk_p / da = k / a, as on
        a half-space; the onset is 0.

    Raises
    ------
    InputError : a stiffness, depth or radius that is not positive and finite.
    """
    k = np.atleast_1d(np.asarray(stiffness, float))
    a = np.broadcast_to(np.asarray(radius, float), k.shape)
    for name, values, unit in (("stiffness", k, "N/m"), ("depth", depth, "m"), ("radius", a, "m")):
        good = (np.asarray(values) > 0) & np.isfinite(values)
        if not good.all():
            wrong = np.asarray(values)[~good].ravel()[0]
            raise InputError(f"{name} of linear springs must be positive, got {wrong} {unit}")
    table = np.zeros((k.size, 2, 6))
    table[:, :, 3] = k[:, None] / 2
    table[:, 1, 4], table[:, 1, 5] = k * depth, k * depth**2 / 2
    contact = np.stack([a, k, k / a], axis=-1)
    return Springs(float(depth), table, np.repeat(contact[:, None], 2, axis=1), tangent=True)
