r"""When time stepping with an element kernel is stable, known before any run (physics, section 5).

With the z-transform G(z) = sum_n g_n z^-n of a kernel, the power that forces of angular
frequency theta / dt put into the tread in a step is their form in

    H(theta) = Herm[(1 - e^{-i theta}) G(e^{i theta})]

and time stepping is energy-stable on every monotone spring where H >= 0. Springs of stiffness
K on the contact set keep it so as long as 1 + lambda_min(K^1/2 H K^1/2) / (1 - cos theta) >= 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from scipy import fft
from scipy.linalg import eigvalsh, toeplitz
from scipy.sparse.linalg import LinearOperator, eigsh

from tyrecontact.errors import InputError

if TYPE_CHECKING:
    from tyrecontact.tread.kernels import Kernel

#: frequencies between 0 and Nyquist at which `critical_stiffness` looks
_ANGLES = 60
#: frequencies at which `critical_angle` looks, and its blocks a side
_TRIED, _BLOCKS = 96, 10
#: up to so many elements eigenvalues are those of a dense matrix
_DENSE_UP_TO = 600
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
    # Re[(1 - z) z^n], z = e^{-i theta}
    waves = np.cos(np.asarray(theta, float)[..., None] * np.arange(kernel.lags + 1))
    return np.tensordot(-np.diff(waves, axis=-1), kernel.values, axes=1)


def critical_angle(kernel: Kernel) -> float:
    """The angle theta at which springs are worst for a kernel [rad], 0 < theta <= pi.

    It is pi where forces that change sign every step draw energy (as with `band_limited`):
    there instability of linear springs sets in. Otherwise it is where
    lambda_min(H(theta)) / (1 - cos theta) is least. Found for forces that are alike on blocks
    of elements, 10 x 10 blocks at most: energy is drawn by long waves. Takes
    0.02 s where it is pi, up to 0.3 s elsewhere.
    """
    step = np.pi / _TRIED
    angles = step * np.arange(1, _TRIED + 1)
    symbols = _of_blocks(hermitian_symbol(kernel, angles))
    draws = _embedded(symbols).min(axis=(1, 2)) < -_ROUNDING * kernel.values[0, 0, 0]
    if draws[-1] and lowest_power(symbols[-1]) < 0:
        return float(np.pi)
    lowest = _plane_waves(symbols).min(axis=(1, 2))
    lowest[draws] = [lowest_power(symbol) for symbol in symbols[draws]]
    found = angles[np.argmin(lowest / (1 - np.cos(angles)))]
    if not draws.any():
        return float(found)
    finer = np.minimum(found + step * np.linspace(-0.9, 0.9, 10), np.pi)
    symbols = _of_blocks(hermitian_symbol(kernel, finer))
    lowest = np.array([lowest_power(symbol) for symbol in symbols])
    return float(finer[np.argmin(lowest / (1 - np.cos(finer)))])


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
    at_nyquist = _limit(kernel, shape, np.pi)
    if np.isfinite(at_nyquist):
        return at_nyquist
    step = np.pi / _ANGLES
    angles = step * np.arange(1, _ANGLES)
    limits = [_limit(kernel, shape, theta) for theta in angles]
    least = min(limits)
    if np.isinf(least):
        return np.inf
    finer = angles[np.argmin(limits)] + step * np.linspace(-0.9, 0.9, 10)
    return min(least, *(_limit(kernel, shape, theta) for theta in finer))


def _limit(kernel: Kernel, shape: tuple[int, int], theta: float) -> float:
    """Stiffness [N/m] up to which forces of an angle draw no energy; inf where none ever does."""
    rounding = _ROUNDING * kernel.values[0, 0, 0]
    symbol = hermitian_symbol(kernel, theta)[: shape[0], : shape[1]]
    if _embedded(symbol).min() >= -rounding:
        return np.inf  # a periodic lattice that holds this one takes power, and so does this one
    lowest = lowest_power(symbol)
    return float((1 - np.cos(theta)) / -lowest) if lowest < -rounding else np.inf


def lowest_power(symbol: np.ndarray) -> float:
    """Least eigenvalue [m/N] of the matrix between elements that a symbol (ny, nx) generates.

    Of more than 600 elements it may come out too high by 1e-4 of the largest, never too low.
    """
    ny, nx = symbol.shape
    if symbol.size > _DENSE_UP_TO:
        return _lowest_by_products(symbol)
    blocks = np.array([toeplitz(row) for row in symbol])
    rows = np.abs(np.subtract.outer(np.arange(ny), np.arange(ny)))
    matrix = blocks[rows].transpose(0, 2, 1, 3).reshape(ny * nx, ny * nx)
    return float(eigvalsh(matrix, subset_by_index=(0, 0))[0])


def _lowest_by_products(symbol: np.ndarray) -> float:
    """`lowest_power` of many elements, by Lanczos' method on products by transforms.

    The eigenvalue sought is the largest of (top - H): what is negative by less than 1e-4 of the
    largest may come out too high, never too low.
    """
    (ny, nx), spectrum = symbol.shape, _embedded(symbol)
    top, padded = spectrum.max(), (2 * ny, 2 * nx)

    def product(vector: np.ndarray) -> np.ndarray:
        force = vector.reshape(ny, nx)
        transform = fft.rfft2(force, s=padded) * spectrum[:, : nx + 1]
        return (top * force - fft.irfft2(transform, s=padded)[:ny, :nx]).ravel()

    operator = LinearOperator((symbol.size, symbol.size), matvec=product, dtype=float)
    start = np.random.default_rng(0).standard_normal(symbol.size)  # the same every time
    found = eigsh(operator, k=1, which="LA", tol=1e-4, v0=start, return_eigenvectors=False)
    return float(top - found[0])


def _embedded(symbol: np.ndarray) -> np.ndarray:
    """Eigenvalues [m/N] on the periodic lattice of twice the size, (..., 2 ny, 2 nx).

    The matrix that the symbol generates is a part of that lattice's: none of its own is below
    their least.
    """
    ny, nx = symbol.shape[-2:]
    row, column = (np.minimum(np.arange(2 * n), 2 * n - np.arange(2 * n)) for n in (ny, nx))
    padded = np.pad(symbol, [(0, 0)] * (symbol.ndim - 2) + [(0, 1), (0, 1)])
    return fft.fft2(padded[..., row[:, None], column]).real


def _of_blocks(symbols: np.ndarray) -> np.ndarray:
    """Symbols (..., ny, nx) on blocks of elements whose forces are alike, 10 x 10 at most."""
    over_y, over_x = (_block_weights(n) for n in symbols.shape[-2:])
    return over_y @ symbols @ over_x.T


def _block_weights(elements: int) -> np.ndarray:
    """Matrix (blocks, elements): of s x s pairs of elements of two blocks s - |d| are d off."""
    side = -(-elements // _BLOCKS)
    weights = np.zeros((elements // side, elements))
    for block in range(len(weights)):
        for off in range(-side + 1, side):
            weights[block, abs(block * side + off)] += 1 - abs(off) / side
    return weights


def _plane_waves(symbols: np.ndarray) -> np.ndarray:
    """Rayleigh quotients of plane waves on the lattice [m/N]: none is below the least eigenvalue.

    Of n elements in a row n - d pairs are d apart, so that the quotient is a cosine transform.
    """
    _, ny, nx = symbols.shape
    shares = np.outer(1 - np.arange(ny) / ny, 1 - np.arange(nx) / nx)
    padded = np.pad(symbols * shares, ((0, 0), (0, 1), (0, 1)))
    return fft.dctn(padded, type=1, axes=(1, 2))
