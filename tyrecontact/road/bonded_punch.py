r"""A flat circular punch that does not slip, on an elastic layer bonded to a rigid base.

Under the punch the surface moves down by delta and not sideways. With nu the layer's Poisson's
ratio, k0 = 3 - 4 nu, and u = k h, pressure p and shear q displace the layer's surface by

    (u_z, u_r) = 2 (1 - nu^2) / (E k)  [[A, B], [B, D]]  (p, q)    (Hankel transforms, orders 0, 1)

    A = (2 k0 sinh 2u - 4u) / N,    D = (2 k0 sinh 2u + 4u) / N,
    B = (2 k0 (k0 - 1) (cosh 2u - 1) - 8 u^2) / ((k0 + 1) N),
    N = 2 k0 cosh 2u + 4 u^2 + 1 + k0^2,    A, D -> 1 and B -> b = (k0 - 1) / (k0 + 1) for large u.

p = int_0^1 phi(x) cos(k x) dx and q = int_0^1 psi(x) sin(k x) dx (a = 1) leave the surface outside
the punch free. Inside, Abel's transform gives for w = phi + i psi, phi even and psi odd,

    w(x) - (i b / pi) int_-1^1 w(t) / (t - x) dt + (smooth kernels of A - 1, B - b, D - 1) = 1.

The singular part maps ((1 - x) / (1 + x))^alpha P_n^(alpha, -alpha)(x) to sqrt(1 - b^2)
P_n^(-alpha, alpha)(x), with alpha = i ln(k0) / 2 pi and Jacobi's polynomials: in that basis the
oscillation at the edge is exact, and the rest converges exponentially. alpha = 0 at nu = 1/2.
"""

from __future__ import annotations

import numpy as np

from tyrecontact.road.quadrature import gauss, panels

#: A - 1, B - b and D - 1 are below 1e-15 beyond this u
_CUT_OFF = 24.0
#: nodes crowd towards the edge as the fourth power of their distance, for what oscillates there
_CROWDING = 4


def half_space_factor(poissons_ratio: float) -> float:
    """kappa of a half-space [-]: ln(3 - 4 nu) (1 - nu) / (1 - 2 nu), 1 at nu = 1/2.

    Source: Mossakovskii, PMM 18 (1954); Spence, Proc. R. Soc. A 305 (1968) 55-80.
    """
    x = 2 - 4 * poissons_ratio  # k0 - 1
    return float((1 - poissons_ratio) * 2 * (np.log1p(x) / x if x > 0 else 1.0))


def solve(ratio: float, poissons_ratio: float) -> float:
    """kappa [-] at one a/h, by collocation.

    Source: the dual integral equations as in Gladwell, Contact Problems in the Classical Theory
    of Elasticity (1980), chapter 10; the singular part as in Muskhelishvili, Singular Integral
    Equations (1953), chapter 14.
    """
    k0 = 3 - 4 * poissons_ratio
    theta, b = np.log(k0) / (2 * np.pi), (k0 - 1) / (k0 + 1)
    count = 2 * int(np.ceil(10 + 2 * ratio))
    x = 2 * gauss(count)[0][count // 2 :] - 1
    rest, weight = _crowded(2 * count if poissons_ratio == 0.5 else 4 * count)
    t = 1 - rest
    u, du = panels(64 + 16 * ratio)
    u, du = u * _CUT_OFF, du * _CUT_OFF * 2 / np.pi * ratio
    edge = (rest / (1 + t)) ** (1j * theta)
    basis = edge * _jacobi(count, theta, t) * weight
    cosine, sine = np.cos(ratio * np.outer(u, t)), np.sin(ratio * np.outer(u, t))
    normal, shear = cosine @ basis.real.T, sine @ basis.imag.T
    a_part, b_part, d_part = (part[:, None] for part in _layer(u, k0) * du)
    up = np.cos(ratio * np.outer(x, u)) @ (a_part * normal + b_part * shear)
    side = np.sin(ratio * np.outer(x, u)) @ (b_part * normal + d_part * shear)
    singular = np.sqrt(1 - b**2) * _jacobi(count, -theta, x).T
    matrix = np.vstack([singular.real + up, singular.imag + side])
    right = np.repeat([1.0, 0.0], count // 2)
    return float(basis.real.sum(axis=1) @ np.linalg.solve(matrix, right))


def _layer(u: np.ndarray, k0: float) -> np.ndarray:
    """A - 1, B - b and D - 1, shape (3, u)."""
    bottom = 2 * k0 * np.cosh(2 * u) + 4 * u**2 + 1 + k0**2
    normal = (2 * k0 * np.sinh(2 * u) - 4 * u) / bottom
    shear = (2 * k0 * np.sinh(2 * u) + 4 * u) / bottom
    # B - b with its leading parts taken off each other by hand
    coupling = 2 * k0 * (k0 - 1) + 8 * u**2 + (k0 - 1) * (4 * u**2 + 1 + k0**2)
    return np.array([normal - 1, -coupling / (k0 + 1) / bottom, shear - 1])


def _jacobi(count: int, theta: float, x: np.ndarray) -> np.ndarray:
    """i^n P_n^(alpha, -alpha)(x), alpha = i theta, shape (count, x): even + i odd in x."""
    values = np.empty((count, x.size), complex)
    values[0], values[1] = 1.0, 1j * x - theta
    for n in range(2, count):
        values[n] = 1j * (2 * n - 1) / n * x * values[n - 1]
        values[n] += ((n - 1) ** 2 + theta**2) / (n * (n - 1)) * values[n - 2]
    return values


def _crowded(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Distances from 1 of nodes on [0, 1] that crowd there, and weights."""
    gap, weight = gauss(count)
    return gap**_CROWDING, weight * _CROWDING * gap ** (_CROWDING - 1)
