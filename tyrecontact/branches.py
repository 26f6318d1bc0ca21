"""Force by indentation: the branches of loading and unloading of a run, and their slopes.

A branch is single-valued. Loading takes the steps that press deeper than all before them, up to
the deepest; unloading those that come back further than all since then. A hold is on
neither, nor what a machine springs back and forth. Where road and tread are apart nothing is told.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: a slope is taken over two of so many parts of a branch
_PARTS = 100


@dataclass(frozen=True)
class Branch:
    """Indentation [m], increasing, and the force there [N]; both of shape (points,)."""

    depth: np.ndarray
    force: np.ndarray

    def at(self, depth: np.ndarray) -> np.ndarray:
        """Force [N] at indentations [m]; nan beyond the branch."""
        if not self.depth.size:
            return np.full(np.shape(depth), np.nan)
        return np.interp(depth, self.depth, self.force, left=np.nan, right=np.nan)

    def slope(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Indentation [m], force [N] and stiffness dF/dd [N/m], shape (points,), equally spaced.

        Each over 2 % of the branch, but not less than its steps; none of fewer than 3 points.
        """
        parts = min(_PARTS, self.depth.size - 1)
        if parts < 2:
            return np.zeros(0), np.zeros(0), np.zeros(0)
        depth = np.linspace(self.depth[0], self.depth[-1], parts + 1)
        force = np.interp(depth, self.depth, self.force)
        return depth, force, np.gradient(force, depth)

    def less(self, other: Branch) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Where the other one has its points and this one is: indentation [m], force less that
        of the other [N], and that of the other [N].
        """
        excess = self.at(other.depth) - other.force
        known = np.isfinite(excess)
        return other.depth[known], excess[known], other.force[known]


def branches(
    depth: np.ndarray, force: np.ndarray, drive: np.ndarray | None = None
) -> tuple[Branch, Branch]:
    """Loading and unloading of a run from its indentation [m] and force [N], shape (steps,).

    `drive` : of the machine [m or N], which tells a hold, shape (steps,); None for no hold.
    """
    moves = np.ones(depth.size, bool) if drive is None else np.diff(drive, prepend=np.nan) != 0
    touching = np.flatnonzero(force)
    if not touching.size:
        none = Branch(np.zeros(0), np.zeros(0))
        return none, none
    begin, end = max(int(touching[0]) - 1, 0), int(touching[-1]) + 2
    turn = begin + int(depth[begin:end].argmax())
    # rounding must not split a hold
    top = int(np.flatnonzero(depth[:end] >= depth[turn] * (1 - 1e-9))[-1])
    up = np.flatnonzero(moves[begin : turn + 1]) + begin
    up = up[_records(depth[up])]
    down = np.flatnonzero(_records(-depth[top:end])) + top
    down = down[:0] if down.size < 2 else down[::-1]
    return Branch(depth[up], force[up]), Branch(depth[down], force[down])


def _records(values: np.ndarray) -> np.ndarray:
    """Whether each value is larger than all before it."""
    before = np.concatenate([[-np.inf], np.maximum.accumulate(values)[:-1]])
    found: np.ndarray = values > before
    return found
