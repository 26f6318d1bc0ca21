"""Columns x y z of a regular grid, in any order of lines."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.formats.columns import Header
from tyrecontact.road.formats.raw import Asked, Raw, require_size, require_square
from tyrecontact.road.formats.text import data_lines, delimiter_of, numbers, opened

#: coordinates may be off the grid by this share of a step
_OFF_GRID = 0.05


def read(path: Path, _: Asked) -> Raw:
    """x y z on each line, all in the same unit; places without a line are missing heights.

    Raises
    ------
    InputError : not three columns, or coordinates that are not those of one regular square grid.
    """
    with opened(path) as lines:
        first = next(data_lines(lines), "")
    if not first:
        raise InputError(f"road file must hold numbers, got {path.name}, which is empty")
    columns = numbers(path, Header((), delimiter_of(first), 3))
    if columns.shape[1] != 3:
        raise InputError(f"{path.name} must hold columns x y z, got {columns.shape[1]} columns")
    if not np.isfinite(columns[:, :2]).all():
        raise InputError(f"{path.name} must hold finite x and y, got some that are not")
    column, dx = _places(columns[:, 0], "x", path)
    row, dy = _places(columns[:, 1], "y", path)
    require_square(dx, dy, path)
    shape = (row.max() + 1, column.max() + 1)
    require_size(shape[0] * shape[1], path)
    filled = len(columns) / (shape[0] * shape[1])
    if filled < 0.1:
        raise _irregular(path, f"of whose places only {filled:.1%} are taken")
    taken = np.zeros(shape, bool)
    taken[row, column] = True
    if np.count_nonzero(taken) != len(columns):
        raise _irregular(path, "with several heights at one place")
    heights = np.full(shape, np.nan)
    heights[row, column] = columns[:, 2]
    clause = "x, y and z taken to have the same unit"
    return Raw(heights, "x y z columns", spacing=dx, done=(clause,))


def _places(coordinates: np.ndarray, axis: str, path: Path) -> tuple[np.ndarray, float]:
    """Which step of the grid each coordinate is, and the step."""
    levels = np.unique(coordinates)
    gaps = np.diff(levels)
    span = levels[-1] - levels[0]
    gaps = gaps[gaps > 1e-6 * span]  # the same number written twice with other last digits
    if not gaps.size:
        raise _irregular(path, f"with a single {axis}")
    # the mean step is better known than any one: coordinates are rounded in the file
    step = span / np.rint(gaps / np.median(gaps)).sum()
    place = (coordinates - levels[0]) / step
    if not np.abs(place - np.rint(place)).max() <= _OFF_GRID:
        raise _irregular(path, f"whose {axis} do not lie on equal steps of {step:.4g}")
    return np.rint(place).astype(np.int64), float(step)


def _irregular(path: Path, how: str) -> InputError:
    return InputError(f"x and y must lie on one regular square grid, got {path.name} {how}")
