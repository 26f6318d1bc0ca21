r"""A flat circular punch on an elastic layer bonded to a rigid base (physics, section 2).

The force is F = 2 E a delta kappa / (1 - nu^2), with kappa the factor by which the layer of
thickness h is stiffer than a half-space. Frictionless punch (Lebedev and Ufliand):

    phi(x) + int_0^1 K(x, t) phi(t) dt = 1,    kappa = int_0^1 phi dt,
    K(x, t) = (2 / pi)(a/h) int_0^inf [L(u) - 1] cos(u x a/h) cos(u t a/h) du,
    L(u) = (2 k0 sinh 2u - 4u) / (2 k0 cosh 2u + 4 u^2 + 1 + k0^2),    k0 = 3 - 4 nu.

A punch that does not slip is solved for in road/bonded_punch.py.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline

from tyrecontact.errors import InputError
from tyrecontact.road import bonded_punch
from tyrecontact.road.quadrature import PANEL, gauss, panels

#: a/h where kappa is solved for; below them it is taken as linear in a/h, above as a power of it
_RATIOS = np.geomspace(1e-3, 64, 97)
#: L(u) - 1 is below 1e-15 beyond this u
_CUT_OFF = 24.0


def stiffness_factor(
    radius_over_thickness: np.ndarray, poissons_ratio: float = 0.5, bonded: bool = False
) -> np.ndarray:
    """kappa, how much stiffer than a half-space the layer is under a flat circular punch.

    Parameters
    ----------
    radius_over_thickness : a/h >= 0 [-], any shape.
    poissons_ratio : of the layer [-], 0 <= nu <= 0.5.
    bonded : the punch does not slip on the layer, as one that sticks; else it is frictionless.

    Returns
    -------
    kappa [-], shape of `radius_over_thickness`: the force over that of a frictionless punch on a
    half-space. Solved once per Poisson's ratio on a logarithmic grid and interpolated: relative
    error below 1e-6 (4e-6 next to a/h = 64), where it goes on as the power law that it has there
    (at a/h = 500, if incompressible, 9 % too low, and 3 % if bonded).

    Raises
    ------
    InputError : a ratio that is negative or NaN, a Poisson's ratio out of bounds.

    Source: Lebedev and Ufliand, PMM 22 (1958) 320-326; Yang, Mech. Mater. 30 (1998) 275-286.
    """
    kappa, _ = factor_and_exponent(radius_over_thickness, poissons_ratio, bonded)
    return kappa


def stiffness_exponent(
    radius_over_thickness: np.ndarray, poissons_ratio: float = 0.5, bonded: bool = False
) -> np.ndarray:
    """d ln kappa / d ln(a/h) [-]: 0 on a half-space, towards 3 on a thin incompressible film.

    Parameters and errors as those of `stiffness_factor`, of which it is the derivative. The
    stiffness of a punch, k = 2 E a kappa / (1 - nu^2), grows with its radius as
    dk/da = (k / a)(1 + exponent) while the layer's thickness stays.
    """
    _, exponent = factor_and_exponent(radius_over_thickness, poissons_ratio, bonded)
    return exponent


def factor_and_exponent(
    radius_over_thickness: np.ndarray, poissons_ratio: float = 0.5, bonded: bool = False
) -> tuple[np.ndarray, np.ndarray]:
    """`stiffness_factor` and `stiffness_exponent` at once."""
    if not 0 <= poissons_ratio <= 0.5:
        raise InputError(f"poissons_ratio must lie in [0, 0.5], got {poissons_ratio}")
    ratio = np.asarray(radius_over_thickness, float)
    if not np.all(ratio >= 0):
        raise InputError("radius_over_thickness must not be negative or NaN")
    log_kappa = _table(poissons_ratio, bonded)
    log_ratio = np.log(np.clip(ratio, _RATIOS[0], _RATIOS[-1]))
    kappa, exponent = np.exp(log_kappa(log_ratio)), log_kappa(log_ratio, 1)
    half_space = bonded_punch.half_space_factor(poissons_ratio) if bonded else 1.0
    below = half_space + (kappa - half_space) * ratio / _RATIOS[0]
    exponent = np.where(ratio < _RATIOS[0], 1 - half_space / below, exponent)
    kappa = np.where(ratio < _RATIOS[0], below, kappa)
    return kappa * np.maximum(ratio / _RATIOS[-1], 1.0) ** exponent, exponent


@lru_cache(maxsize=16)
def _table(poissons_ratio: float, bonded: bool) -> CubicSpline:
    solve = bonded_punch.solve if bonded else _solve
    kappa = np.array([solve(ratio, poissons_ratio) for ratio in _RATIOS])
    return CubicSpline(np.log(_RATIOS), np.log(kappa))


def _solve(ratio: float, poissons_ratio: float) -> float:
    """kappa at one a/h by Nystrom's method.

    The kernel is entire, so convergence is exponential once its width of h/a is resolved.
    """
    t, weight = gauss(PANEL * int(np.ceil((40 + 6 * ratio) / PANEL)))
    u, du = panels(64 + 16 * ratio)
    u, du = u * _CUT_OFF, du * _CUT_OFF
    root = np.cos(ratio * np.outer(t, u)) * np.sqrt((1 - _layer(u, poissons_ratio)) * du)  # L < 1
    kernel = -2 / np.pi * ratio * (root @ root.T)
    phi = np.linalg.solve(np.eye(t.size) + kernel * weight, np.ones(t.size))
    return float(weight @ phi)


def _layer(u: np.ndarray, poissons_ratio: float) -> np.ndarray:
    """L(u): the layer's static compliance over that of a half-space, u = k h."""
    k0 = 3 - 4 * poissons_ratio
    return (2 * k0 * np.sinh(2 * u) - 4 * u) / (2 * k0 * np.cosh(2 * u) + 4 * u**2 + 1 + k0**2)
