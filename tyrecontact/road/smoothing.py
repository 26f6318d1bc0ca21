r"""From what a scan's pixels give to a spring that a solver can use: k >= 0 that never falls.

`monotone` takes the punch's own stiffness at the table's nodes. Read as F = k_p delta, a spring
softens wherever few points come into touch; then the greatest convex curve below takes its place.

`polynomial` is of the tenth order in F, up to the spring's own full compression c. Its slope in
Bernstein's basis, x = delta / c,

    F'(x) = sum_m b_m B_m,9(x),    0 <= b_0 <= b_1 <= ... <= b_9,    F(0) = 0,

is non-negative and does not fall; the b_m make the sum of (F / F_raw - 1)^2 over graded x least.
(Not of F - F_raw: full compression is so stiff that all below 10 um would be lost in it.)
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import scipy  # its parts are loaded where they are first used

_ORDER = 10
#: compressions, as shares of the full one, at which the polynomial is fitted
_SHARES = (np.arange(1, 65) / 64) ** 2


def convex_stiffness(delta: np.ndarray, force: np.ndarray, full: np.ndarray) -> np.ndarray:
    """Slope at the nodes of the greatest convex curve below each F(delta).

    Parameters
    ----------
    delta : nodes [m], from 0 up, shape (nodes,).
    force : at the nodes [N], shape (elements, nodes).
    full : compression [m] of each element beyond which it goes on with its last slope.

    Returns
    -------
    k [N/m], shape of `force`, 0 at delta = 0 and never falling.
    """
    width = np.diff(delta)
    slope = np.diff(force, axis=1) / width
    inside = np.maximum(np.searchsorted(delta, full, side="right") - 1, 1)
    for row, cells in zip(slope, inside, strict=True):
        # slopes averaged where they fall, by width: the convex curve below
        row[:cells] = scipy.optimize.isotonic_regression(row[:cells], weights=width[:cells]).x
        row[cells:] = row[cells - 1]
    stiffness = np.zeros_like(force)
    share = width[:-1] / (width[:-1] + width[1:])  # of the way between two cells' middles
    stiffness[:, 1:-1] = slope[:, :-1] + share * np.diff(slope, axis=1)
    stiffness[:, -1] = slope[:, -1]
    return stiffness


def polynomial_stiffness(delta: np.ndarray, force: np.ndarray, full: np.ndarray) -> np.ndarray:
    """k [N/m] at the nodes of a tenth-order polynomial fitted to each F(delta).

    Parameters and shapes as those of `convex_stiffness`; beyond the full compression k stays.

    Source: thesis, chapter 3.2 ("a polynomial fit of order ten, derivative positive").
    """
    integral, log_delta = _rising_integrals(_SHARES), np.log(delta[1:])
    slopes = np.empty((full.size, _ORDER))  # b_m
    for i, (log_force, end) in enumerate(zip(np.log(force[:, 1:]), full, strict=True)):
        known = _SHARES * end >= delta[1]
        # between nodes a power of delta
        raw = np.exp(np.interp(np.log(_SHARES[known] * end), log_delta, log_force))
        relative = integral[known] / raw[:, None]
        size = np.linalg.norm(relative, axis=0)
        steps, _ = scipy.optimize.nnls(relative / size, np.ones(raw.size), maxiter=1000)
        slopes[i] = np.cumsum(steps / size) / end
    return _bernstein(slopes, np.minimum(delta / full[:, None], 1.0))


def _rising_integrals(x: np.ndarray) -> np.ndarray:
    """Integrals from 0 to x of B_m,9 + ... + B_9,9, m = 0 .. 9, shape (x, 10).

    With these steps of b >= 0 the b rise; the integral of B_m,9 is (B_m+1,10 + ... + B_10,10) / 10.
    """
    above = scipy.special.bdtrc(np.arange(_ORDER), _ORDER, x[:, None]) / _ORDER
    return above[:, ::-1].cumsum(axis=1)[:, ::-1]


def _bernstein(coefficients: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Sum of b_m B_m,9(x), one polynomial a row of x, by de Casteljau's convex combinations."""
    levels = [coefficients[:, m, None] for m in range(coefficients.shape[1])]
    while len(levels) > 1:
        levels = [low + x * (high - low) for low, high in pairwise(levels)]
    return levels[0]
