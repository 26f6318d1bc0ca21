r"""When time stepping with an element kernel is stable, known before any run (physics, section 5).

With the z-transform G(z) = sum_n g_n z^-n of a kernel, the power that forces of angular
frequency theta / dt put into the tread in a step is their form in

    H(theta) = Herm[(1 - e^{-i theta}) G(e^{i theta})]

and time stepping is energy-stable on every monotone spring where H >= 0. Springs of stiffness
K on the contact set keep it so as long as 1 + lambda_min(K^1/2 H K^1/2) / (1 - cos theta) >= 0.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from scipy import fft
from scipy.linalg import eigvalsh, toeplitz

from tyrecontact.errors import InputError

if TYPE_CHECKING:
    from tyrecontact.tread.kernels import Kernel

#: frequencies between 0 and Nyquist at which `critical_stiffness` looks
_ANGLES = 60
#: frequencies at which `critical_angle` tries plane waves, and how many of them it looks into
_TRIED, _LOOKED_INTO = 128, 6
#: side of the largest lattice on which it does so [elements]
_SMALL = 12
#: what is negative by less than this share of the self compliance is rounding
_ROUNDING = 1e-13


def hermitian_symbol(kernel: Kernel, theta: float | np.ndarray) -> np.ndarray:
    """H(theta) by offset: the generator of a symmetric block-Toeplitz matrix of elements.

    Parameters
    ----------
    theta : angle that the phase of the forces advances in a step [rad]; any shape.

    Returns
    -------
    [m/N], shape (..., ny, nx): entry (i, j) stands between elements |i| rows and |j| columns
    apart. The kernel is even in both, hence Herm is the real part.
    """
    z = np.exp(-1j * np.asarray(theta, float))[..., None]
    weight = ((1 - z) * z ** np.arange(kernel.lags)).real
    return np.tensordot(weight, kernel.values, axes=1)


def critical_angle(kernel: Kernel) -> float:
    """The angle theta at which springs are worst for a kernel [rad], 0 < theta <= pi.

    It is pi where forces that change sign every step draw energy (as with `band_limited`):
    there instability of linear springs sets in. Otherwise it is where
    lambda_min(H(theta)) / (1 - cos theta) is least. Found on 12 x 12 elements at most, by plane
    waves first, since it hardly depends on the contact: some milliseconds.
    """
    small = replace(kernel, values=kernel.values[:, :_SMALL, :_SMALL])
    angles = np.linspace(np.pi / _TRIED, np.pi, _TRIED)
    symbols = hermitian_symbol(small, angles)
    shape = symbols.shape[1:]
    if _lowest(symbols[-1], shape) < -_ROUNDING * kernel.values[0, 0, 0]:
        return float(np.pi)
    per_stiffness = _plane_waves(symbols).min(axis=(1, 2)) / (1 - np.cos(angles))
    worst = np.argsort(per_stiffness)[:_LOOKED_INTO]
    exact = [_lowest(symbols[i], shape) / (1 - np.cos(angles[i])) for i in worst]
    return float(angles[worst[np.argmin(exact)]])


def critical_stiffness(kernel: Kernel, shape: tuple[int, int]) -> float:
    """Spring stiffness from which on time stepping may be unstable, all elements in contact.

    Where the force may change sign every second step (as for `band_limited`) it is the stiffness
    k of all springs on `shape` (ny, nx) elements at which it begins to grow,
    1 / lambda_max(-sum_n (-1)^n g_n). Otherwise it is the largest stiffness for which the
    scheme is energy-stable with every monotone spring (sufficient, 10-30 % below the onset),

        k = min over theta of (cos theta - 1) / lambda_min(Herm[(1 - z^-1) G(z)]), z = e^{i theta}.

    Returns
    -------
    [N/m]; inf where no stiffness is too much.
    """
    ny, nx = shape
    if not (0 < ny <= kernel.values.shape[1] and 0 < nx <= kernel.values.shape[2]):
        held = kernel.values.shape[1:]
        raise InputError(f"shape must lie within the kernel's {held}, got {shape}")
    least = np.inf
    for theta in np.linspace(np.pi, np.pi / _ANGLES, _ANGLES):
        lowest = _lowest(hermitian_symbol(kernel, theta), shape)
        if lowest < -_ROUNDING * kernel.values[0, 0, 0]:
            least = min(least, (1 - np.cos(theta)) / -lowest)
            if theta == np.pi:
                break
    return float(least)


def _lowest(symbol: np.ndarray, shape: tuple[int, int]) -> float:
    """Least eigenvalue [m/N] of the matrix between `shape` elements that `symbol` generates."""
    ny, nx = shape
    blocks = np.array([toeplitz(row) for row in symbol[:ny, :nx]])
    rows = np.abs(np.subtract.outer(np.arange(ny), np.arange(ny)))
    matrix = blocks[rows].transpose(0, 2, 1, 3).reshape(ny * nx, ny * nx)
    return float(eigvalsh(matrix, subset_by_index=(0, 0))[0])


def _plane_waves(symbols: np.ndarray) -> np.ndarray:
    """Rayleigh quotients of plane waves on the lattice [m/N]: none is below the least eigenvalue.

    Of n elements in a row n - d pairs are d apart, so that the quotient is a cosine transform.
    """
    _, ny, nx = symbols.shape
    shares = np.outer(1 - np.arange(ny) / ny, 1 - np.arange(nx) / nx)
    padded = np.pad(symbols * shares, ((0, 0), (0, 1), (0, 1)))
    return fft.dctn(padded, type=1, axes=(1, 2))
