"""Triangles of a scan to heights on a regular grid: the upper surface, and its largest square."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy  # its parts are loaded where they are first used

from tyrecontact.errors import InputError

#: a square found after turning must be larger than the straight one by this factor
_WORTH_TURNING = 1.05
#: a node that misses a triangle by this share of it still belongs to it (single precision)
_TOUCH = 1e-4


@dataclass(frozen=True)
class Gridded:
    """Heights on a grid, shape (ny, nx), NaN where the scan has a hole; and what was done."""

    heights: np.ndarray
    step: float
    done: tuple[str, ...]


def largest_square(triangles: np.ndarray, step: float | None, most: int) -> Gridded:
    """The largest square that lies in the outline of a triangulated surface, on a grid.

    Parameters
    ----------
    triangles : corners (x, y, z) in any one unit, shape (n, 3, 3).
    step : of the grid, in that unit; None: as fine as the triangles are, two a cell.
    most : heights that the grid may have.

    Raises
    ------
    InputError : no triangle that is seen from above, or a grid that is too large.
    """
    triangles = _seen_from_above(triangles)
    done = [f"interpolated from {len(triangles)} triangles"]
    if step is None:
        step = float(np.sqrt(2 * np.median(_area(triangles))))
        done.append("pitch from their size, two to a cell")
    if not 0 < step < np.inf:
        raise InputError(f"pitch must be positive and finite, got {step} of the file's unit")
    height = rasterised(triangles, step, most)
    straight, _ = _square(np.isfinite(height))
    angle = _best_angle(np.isfinite(height), straight)
    if angle:
        height = rasterised(_turned(triangles, np.deg2rad(angle)), step, most)
        done.append(f"turned by {angle} degrees")
    side, (row, column) = _square(np.isfinite(height))
    done.append(f"cropped to the largest square in its outline, {side} x {side} heights")
    square = height[row : row + side, column : column + side]
    return Gridded(square, step, tuple(done))


def rasterised(triangles: np.ndarray, step: float, most: int) -> np.ndarray:
    """Height of the upper surface at the nodes of a grid, shape (ny, nx); NaN where there is none.

    Triangles are taken by size in powers of two, and those of a size all at once, node by node.
    """
    flat = triangles[..., :2] / step
    low = np.floor(flat.min(axis=1))
    origin, top = low.min(axis=0), np.ceil(flat.max(axis=(0, 1)))
    columns, rows = (int(n) for n in top - origin + 1)
    if rows * columns > most:
        raise InputError(f"a grid must have at most {most:g} heights, got {columns} x {rows}")
    heights = np.full((rows, columns), -np.inf)
    reach = (np.ceil(flat.max(axis=1)) - low).max(axis=1).astype(np.int64)
    sizes = 2 ** np.ceil(np.log2(np.maximum(reach, 1))).astype(np.int64)
    for size in np.unique(sizes):
        chosen = sizes == size
        corners, start = flat[chosen] - origin, (low[chosen] - origin).astype(np.int64)
        for dy, dx in np.ndindex(size + 1, size + 1):
            _raise_to(heights, corners, triangles[chosen][..., 2], start + np.array([dx, dy]))
    heights[np.isneginf(heights)] = np.nan
    return heights


def _raise_to(heights: np.ndarray, corners: np.ndarray, z: np.ndarray, node: np.ndarray) -> None:
    """Raise each triangle's one node to the triangle, where it lies in it."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    whole = _cross(b - a, c - a)
    second, third = _cross(node - a, c - a) / whole, _cross(b - a, node - a) / whole
    first = 1 - second - third
    inside = np.minimum(np.minimum(first, second), third) >= -_TOUCH
    inside &= (node[:, 0] < heights.shape[1]) & (node[:, 1] < heights.shape[0])
    value = first * z[:, 0] + second * z[:, 1] + third * z[:, 2]
    np.maximum.at(heights, (node[inside, 1], node[inside, 0]), value[inside])


def _cross(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]


def _area(triangles: np.ndarray) -> np.ndarray:
    """Area of the triangles seen from above, shape (n,)."""
    a, b, c = triangles[:, 0, :2], triangles[:, 1, :2], triangles[:, 2, :2]
    return np.abs(_cross(b - a, c - a)) / 2


def _seen_from_above(triangles: np.ndarray) -> np.ndarray:
    """Triangles that are not walls: those with an area from above."""
    finite = np.isfinite(triangles).all(axis=(1, 2))
    triangles = triangles[finite].astype(float)
    if len(triangles):
        # coordinates of a survey are large: their digits are kept by a near origin
        triangles = triangles - triangles.min(axis=(0, 1)) * [1, 1, 0]
        area = _area(triangles)
        triangles = triangles[area > 1e-9 * area.max()]
    if not len(triangles):
        raise InputError("a triangulated scan must have triangles that are seen from above, got 0")
    return triangles


def _turned(triangles: np.ndarray, angle: float) -> np.ndarray:
    """Turned about the vertical by an angle [rad], as `ndimage.rotate` turns a map."""
    x, y = triangles[..., 0], triangles[..., 1]
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.stack([x * cosine + y * sine, y * cosine - x * sine, triangles[..., 2]], axis=-1)


def _square(mask: np.ndarray) -> tuple[int, tuple[int, int]]:
    """Side and lowest corner of the largest square of a mask; holes inside it do not count.

    By bisection: sums over all squares of a side come from sums over rectangles to the corner.
    """
    sums = np.pad(
        scipy.ndimage.binary_fill_holes(mask).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0))
    )

    def full(side: int) -> np.ndarray:
        ends, starts = slice(side, None), slice(None, -side)
        covered = sums[ends, ends] - sums[starts, ends] - sums[ends, starts] + sums[starts, starts]
        return covered == side**2

    side, beyond = 0, min(mask.shape) + 1
    while beyond - side > 1:
        middle = (side + beyond) // 2
        side, beyond = (middle, beyond) if full(middle).any() else (side, middle)
    if not side:
        return 0, (0, 0)
    row, column = np.argwhere(full(side))[0]
    return side, (int(row), int(column))


def _best_angle(mask: np.ndarray, straight: int) -> int:
    """By how many degrees to turn so that the largest square is largest; 0 if not worth it."""
    if mask.size > 1_000_000:  # the outline is known well enough from fewer nodes
        every = int(np.ceil(np.sqrt(mask.size / 1_000_000)))
        mask, straight = scipy.ndimage.binary_fill_holes(mask)[::every, ::every], straight // every
    sides = {}
    for angle in range(3, 90, 3):
        turned = scipy.ndimage.rotate(mask.astype(np.uint8), angle, order=0)
        sides[angle] = _square(turned > 0)[0]
    angle = max(sides, key=lambda key: sides[key])
    return angle if sides[angle] > _WORTH_TURNING * straight else 0
