"""A whole road file at a glance: so few heights that they can be drawn, the extremes kept."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tyrecontact.road.scan import Scan

#: heights along a side of a map at most, and stretches of a profile
MAP, PROFILE = 400, 1500


@dataclass(frozen=True)
class Overview:
    """Heights of a whole file, made few.

    Attributes
    ----------
    heights : [m], NaN where nothing was measured; of a map shape (ny, nx), each the mean of a
        block; of a profile shape (n,), the lowest and the highest of each stretch.
    place : of a profile, where they are from its start [m], shape (n,); empty for a map.
    extent : of the whole file, (y, x) or (x,) [m].
    low, high : between which all but 1 % of these heights lie [m].
    """

    heights: np.ndarray
    place: np.ndarray
    extent: tuple[float, ...]
    low: float
    high: float

    @property
    def is_profile(self) -> bool:
        """Whether it is one line of heights."""
        return self.heights.ndim == 1


def overview(scan: Scan) -> Overview:
    """A scan made so few that it can be drawn: at most 400 x 400 heights, or 1500 stretches."""
    heights, place = _line(scan) if scan.is_profile else (_blocks(scan.heights), np.empty(0))
    low, high = (float(np.nanpercentile(heights, share)) for share in (0.5, 99.5))
    return Overview(heights, place, scan.extent, low, high)


def _blocks(heights: np.ndarray) -> np.ndarray:
    """Means over the valid heights of square blocks, those at the far edges smaller."""
    every = -(-max(heights.shape) // MAP)
    if every == 1:
        return heights
    starts = [np.arange(0, count, every) for count in heights.shape]
    valid = np.isfinite(heights)
    total, count = (
        np.add.reduceat(np.add.reduceat(values, starts[0], axis=0), starts[1], axis=1)
        for values in (np.where(valid, heights, 0.0), valid.astype(np.int64))
    )
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def _line(scan: Scan) -> tuple[np.ndarray, np.ndarray]:
    """Heights of a profile and their places [m]: those missing, and the extremes of the others."""
    heights = scan.heights
    place = (np.arange(heights.size) + 0.5) * scan.pitch
    every = -(-heights.size // PROFILE)
    if every <= 2:
        return heights, place
    padded = np.pad(heights, (0, -heights.size % every), constant_values=np.nan)
    stretches = padded.reshape(-1, every)
    missing = np.isnan(stretches)
    lowest = np.where(missing, np.inf, stretches).argmin(axis=1)
    highest = np.where(missing, -np.inf, stretches).argmax(axis=1)
    start = np.arange(0, padded.size, every)
    index = start[:, None] + np.sort(np.column_stack([lowest, highest]), axis=1)
    index = np.minimum(index.ravel(), heights.size - 1)
    return heights[index], place[index]
