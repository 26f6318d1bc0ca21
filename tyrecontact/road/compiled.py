"""Look-ups in tables of springs, one element at a time, compiled by numba (the extra `fast`)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

#: shared with contact/compiled.py: kept on disk, free for other threads, divisions as in numpy
compiled = njit(cache=True, nogil=True, error_model="numpy")


@compiled
def cell_of(compression: float, depth: float, cells: int) -> Any:
    """Number of the cell of a compression [m] >= 0, and the distance from its lower node [m]."""
    cell = int(np.sqrt(min(compression / depth, 1.0)) * cells)
    return cell, compression - depth * (cell / cells) ** 2


@compiled
def respond(coefficients: Any, x: float) -> Any:
    """U, U' and U'' of a polynomial of the fifth degree, by Horner's scheme."""
    u = f = k = coefficients[0]
    for power in range(1, 4):
        u = u * x + coefficients[power]
        f = f * x + u
        k = k * x + f
    u = u * x + coefficients[4]
    return u * x + coefficients[5], f * x + u, 2 * k


@compiled
def between_nodes(table: Any, column: int, depth: float, compression: Any) -> Any:
    """A column of a table (elements, cells + 1, columns) at compressions [m] >= 0, (elements,)."""
    result, cells = np.empty(compression.size), table.shape[1] - 1
    for i in range(compression.size):
        cell, x = cell_of(compression[i], depth, cells)
        result[i] = table[i, cell, column]
        if cell < cells:
            width = depth * (2 * cell + 1) / cells**2
            result[i] += (table[i, cell + 1, column] - result[i]) * min(x / width, 1.0)
    return result
