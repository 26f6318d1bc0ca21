"""Gauss-Legendre rules on [0, 1] for the integral equations of the punches."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy import special

#: nodes of a panel: those of a rule of many hundred are dear to find
PANEL = 64


@lru_cache(maxsize=128)
def gauss(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights, both shape (count,)."""
    x, weight = special.roots_legendre(count)
    return (x + 1) / 2, weight / 2


def panels(least: float) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and weights, at least so many, on equal panels with a rule of `PANEL` each."""
    count, (x, weight) = int(np.ceil(least / PANEL)), gauss(PANEL)
    return ((np.arange(count)[:, None] + x) / count).ravel(), np.tile(weight / count, count)
