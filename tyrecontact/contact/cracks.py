r"""The edge of a contact as a crack, on the tables of its spring (physics, section 8).

A punch of the area that a spring touches at compression c, pulled to d < c, has at its edge

    G = k'(a) (d - c)^2 / (4 pi a),

with a and k' linear in c between the table's nodes, and neither ever falling. A radius then has
one smallest compression, and k' (c - d)^2 - 4 pi w a, whose sign is that of G - w, is a convex
cubic in each cell, with a lowest point in closed form: where a crack rests is solved for.

Contacts are told by the numbers of their elements; all arrays have the shape (contacts,).
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from tyrecontact.road.springs import Springs

#: beyond its depth a table goes on as it ends, for so many depths
_BEYOND = 1e6
#: Newton's method needs fewer
_MOST_ITERATIONS = 60
_CLOSE = 1e-9


class CrackTable:
    """Radius a [m] and k' = dk_p / da [N/m2] of contacts by the compression of their area [m]."""

    def __init__(self, springs: Springs) -> None:
        nodes, table = springs.nodes, springs.contact_table[..., [0, 2]].transpose(2, 0, 1)
        self._depth, self._cells = springs.depth, nodes.size - 1
        self._nodes = np.append(nodes, _BEYOND * springs.depth)
        self._values = np.ascontiguousarray(np.append(table, table[..., -1:], axis=-1))
        rise = np.diff(self._values, axis=-1, append=self._values[..., -1:])
        self._rise = rise / np.diff(self._nodes, append=np.inf)

    def radius_and_release(
        self, element: np.ndarray, reach: np.ndarray, depth: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """a [m] at c = `reach`, and G [J/m2] when pulled to d = `depth` [m]; G is 0 where a is."""
        cell = self._cell(reach)
        place, offset = element * self._nodes.size + cell, reach - self._nodes[cell]
        radius, slope = (
            values.take(place) + rise.take(place) * offset
            for values, rise in zip(self._values, self._rise, strict=True)
        )
        safe = np.where(radius > 0, radius, np.inf)
        return radius, slope * (depth - reach) ** 2 / (4 * np.pi * safe)

    def receded(
        self,
        element: np.ndarray,
        radius: np.ndarray,
        left: np.ndarray,
        start: np.ndarray,
        depth: np.ndarray,
        tough: np.ndarray,
    ) -> np.ndarray:
        """Where cracks that move from `start` [m] down to a radius `left` [m] come to rest [m].

        That is at the first G <= w, or at `left`; 0 where the whole contact is gone. `radius` [m]
        is that at `start`; they are pulled to d = `depth` [m], and `tough` is w [J/m2].
        """
        end, slope = self._at_radius(element, left, start)
        # no less than this is the one, no more than that the other, anywhere on the way
        drive, hold = slope * np.maximum(end - depth, 0.0) ** 2, 4 * np.pi * tough * radius
        may_rest = np.flatnonzero(drive <= hold)
        if may_rest.size:
            ways = (values[may_rest] for values in (element, start, end, depth, tough))
            end[may_rest] = self._first_rest(*ways)
        return end

    def _cell(self, reach: np.ndarray) -> np.ndarray:
        return (np.sqrt(np.minimum(reach / self._depth, 1.0)) * self._cells).astype(int)

    def _at_radius(
        self, element: np.ndarray, radius: np.ndarray, start: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Smallest compression with at least a radius, at most `start`; k' at the node below."""
        row, cell = element * self._nodes.size, self._cell(start)
        further = np.flatnonzero(self._values[0].take(row + cell) >= radius)
        if further.size:  # the others stay in their cell
            smaller = self._values[0][element[further]] < radius[further, None]
            cell[further] = np.maximum(smaller.sum(axis=1) - 1, 0)
        place = row + cell
        lacking = np.maximum(radius - self._values[0].take(place), 0.0)
        rise = self._rise[0].take(place)
        reach = self._nodes.take(cell) + lacking / np.where(rise > 0, rise, np.inf)
        return np.minimum(reach, start), self._values[1].take(place)

    def _first_rest(
        self,
        element: np.ndarray,
        start: np.ndarray,
        end: np.ndarray,
        depth: np.ndarray,
        tough: np.ndarray,
    ) -> np.ndarray:
        """The first G <= w on the way from `start`, where G > w, to `end`; else `end`."""
        end = np.maximum(end, np.minimum(depth, start))  # where nothing pulls it rests
        first, last = self._cell(end).min(), self._cell(start).max() + 1
        low = np.maximum(self._nodes[first:last], end[:, None])
        high = np.minimum(self._nodes[first + 1 : last + 1], start[:, None])
        cubics = self._cubics(element, slice(first, last), low, depth, tough)
        place = np.minimum(low + cubics.lowest(), high)
        rests = (cubics.at(place - low) <= 0) & (low < high)
        highest = rests.shape[1] - 1 - rests[:, ::-1].argmax(axis=1)
        found = np.flatnonzero(rests.any(axis=1))
        one = found, highest[found]
        resting, moving = place[one] - low[one], high[one] - low[one]
        end[found] = low[one] + cubics.only(one).root(resting, moving)
        return end

    def _cubics(
        self,
        element: np.ndarray,
        cells: slice,
        low: np.ndarray,
        depth: np.ndarray,
        tough: np.ndarray,
    ) -> _Cubics:
        """Those of cells, from the compressions `low` [m] in them on, shape (contacts, cells)."""
        offset = low - self._nodes[cells]
        (da, dk), (a, k) = self._rise[:, element, cells], self._values[:, element, cells]
        bound = 4 * np.pi * tough[:, None]
        a, k, pull = a + da * offset, k + dk * offset, low - depth[:, None]
        return _Cubics(pull, k, dk, bound * a, bound * da)


@dataclass(frozen=True)
class _Cubics:
    """(k + dk x)(pull + x)^2 - (hold + rise x): convex for pull, x >= 0, as k > 0 and dk >= 0."""

    pull: np.ndarray
    k: np.ndarray
    dk: np.ndarray
    hold: np.ndarray
    rise: np.ndarray

    def at(self, x: np.ndarray) -> np.ndarray:
        return (self.k + self.dk * x) * (self.pull + x) ** 2 - (self.hold + self.rise * x)

    def lowest(self) -> np.ndarray:
        """x >= 0 at which they are lowest."""
        turn = self.dk * self.pull
        falls = np.maximum(self.rise - (turn + 2 * self.k) * self.pull, 0.0)
        root = np.sqrt((self.k - turn) ** 2 + 3 * self.dk * self.rise)
        return falls / (2 * turn + self.k + root)

    def root(self, low: np.ndarray, high: np.ndarray) -> np.ndarray:
        """x between one where they are not positive, and not falling, and one where they are."""
        x = high  # from above Newton's method comes down to the root and not beyond
        for _ in range(_MOST_ITERATIONS):
            pull, k = self.pull + x, self.k + self.dk * x
            slope = (self.dk * pull + 2 * k) * pull - self.rise
            step = self.at(x) / np.where(slope > 0, slope, np.inf)
            x, last = np.clip(x - step, low, high), x
            if np.all(last - x <= _CLOSE * high):  # as exact as can be: digits double in a step
                break
        return x

    def only(self, place: tuple[np.ndarray, np.ndarray]) -> _Cubics:
        return _Cubics(*(getattr(self, f.name)[place] for f in fields(self)))
