r"""Transforms in which a sum over elements is a product, wave by wave.

What an element feels depends on its distance (i, j) to the loaded one, and alike on both sides. On
a line of n elements continued with the period 2 n, waves are then multiplied by one real number
each (no two elements being n apart, the period is not felt):

    u = B' diag(lambda) B F,   B = sqrt(w_k / 2n) { cos, sin } pi k (x - c) / n,   k = 0 .. n,
    lambda_k = g_0 + 2 sum_(x=1)^(n-1) g_x cos(pi k x / n),    w_0 = w_n = 1, w_k = 2.

Two matrices stand for the two directions of a patch. Up to some elements a side products with them
are faster than the fast Fourier transform; beyond, it does the same with complex waves.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Protocol

import numpy as np
from scipy import fft

#: up to this many elements a side products with matrices are faster than fast transforms
MATRICES_UP_TO = 96
#: coefficients that belong to one pair of wave numbers: cosine and sine in both directions
PARTS = 4


class Transform(Protocol):
    """Between fields on the lattice, (ny, nx), and coefficients, (PARTS, (ny + 1) (nx + 1))."""

    def forward(self, field: np.ndarray) -> np.ndarray:
        """Coefficients of a field."""

    def backward(self, coefficients: np.ndarray) -> np.ndarray:
        """The field of coefficients."""

    def grid(self, waves: np.ndarray) -> np.ndarray:
        """`kernel_waves` (ny + 1, nx + 1) as `product` wants them."""

    def product(self, grid: np.ndarray, field: np.ndarray) -> np.ndarray:
        """The sum over elements of kernel and field: there, times the waves, and back."""


@lru_cache(maxsize=8)
def transform(shape: tuple[int, int]) -> Transform:
    """The faster transform for a patch of (ny, nx) elements; made once for each shape."""
    return Matrices(shape) if max(shape) <= MATRICES_UP_TO else Fourier(shape)


def kernel_waves(values: np.ndarray) -> np.ndarray:
    """lambda of kernels by offset, (..., ny, nx) -> (..., ny + 1, nx + 1)."""
    across, along = (_sums(count) for count in values.shape[-2:])
    waves: np.ndarray = across @ values @ along.T
    return waves


def near_values(waves: np.ndarray) -> np.ndarray:
    """g of waves (..., ny + 1, nx + 1) for offsets 0 and 1, shape (..., 2, 2)."""
    across, along = (_means(count - 1) for count in waves.shape[-2:])
    values: np.ndarray = across @ waves @ along.T
    return values


class Matrices:
    """Real waves, by a product with a matrix in each direction.

    Attributes
    ----------
    across, along : B of the rows that are not zero, shapes (2 ny, ny) and (2 nx, nx).
    """

    def __init__(self, shape: tuple[int, int]) -> None:
        self._shape = shape
        (self._all_across, y), (self._all_along, x) = (_waves(count) for count in shape)
        self.across, self.along = self._all_across[y], self._all_along[x]
        self._numbers = np.ix_(y % (shape[0] + 1), x % (shape[1] + 1))

    def forward(self, field: np.ndarray) -> np.ndarray:
        ny, nx = self._shape
        parts = (self._all_across @ field @ self._all_along.T).reshape(2, ny + 1, 2, nx + 1)
        return parts.transpose(0, 2, 1, 3).reshape(PARTS, -1)

    def backward(self, coefficients: np.ndarray) -> np.ndarray:
        ny, nx = self._shape
        parts = coefficients.reshape(2, 2, ny + 1, nx + 1).transpose(0, 2, 1, 3)
        waves = parts.reshape(2 * ny + 2, 2 * nx + 2)
        field: np.ndarray = self._all_across.T @ waves @ self._all_along
        return field

    def grid(self, waves: np.ndarray) -> np.ndarray:
        return waves[self._numbers]

    def product(self, grid: np.ndarray, field: np.ndarray) -> np.ndarray:
        waves = self.across @ field @ self.along.T
        waves *= grid
        result: np.ndarray = self.across.T @ waves @ self.along
        return result


def _waves(count: int) -> tuple[np.ndarray, np.ndarray]:
    """B with all cosines and sines, (2 count + 2, count), and the rows that are not zero."""
    k = np.tile(np.arange(count + 1), 2)[:, None]
    phase = np.pi * k * (np.arange(count) - (count - 1) / 2) / count
    cosine = np.arange(2 * count + 2)[:, None] <= count
    weight = np.sqrt(np.where((k == 0) | (k == count), 1, 2) / (2 * count))
    waves = weight * np.where(cosine, np.cos(phase), np.sin(phase))
    # about the centre: no sine of k = 0, and of k = n the one that is not zero there
    zero = [count + 1, 2 * count + 1 if count % 2 else count]
    waves[zero] = 0
    return waves, np.delete(np.arange(2 * count + 2), zero)


def _sums(count: int) -> np.ndarray:
    """From g_x to lambda_k, shape (count + 1, count)."""
    k, x = np.arange(count + 1)[:, None], np.arange(count)
    sums: np.ndarray = np.where(x > 0, 2, 1) * np.cos(np.pi * k * x / count)
    return sums


def _means(count: int) -> np.ndarray:
    """From lambda_k to g_0 and g_1, shape (2, count + 1)."""
    k, x = np.arange(count + 1), np.arange(2)[:, None]
    weight = np.where((k == 0) | (k == count), 1, 2) / (2 * count)
    means: np.ndarray = weight * np.cos(np.pi * k * x / count)
    return means


class Fourier:
    """Complex waves by the fast transform; rows and columns of zeros are left out."""

    def __init__(self, shape: tuple[int, int]) -> None:
        self._shape, self._padded = shape, (2 * shape[0], 2 * shape[1])

    def forward(self, field: np.ndarray) -> np.ndarray:
        waves, ny = self._forward(field), self._shape[0]
        back = -np.arange(ny + 1) % (2 * ny)  # of k = 0 and n twice the same
        parts = [part for half in (waves[: ny + 1], waves[back]) for part in (half.real, half.imag)]
        return np.stack(parts).reshape(PARTS, -1)

    def backward(self, coefficients: np.ndarray) -> np.ndarray:
        ny, nx = self._shape
        parts = coefficients.reshape(PARTS, ny + 1, nx + 1)
        waves = np.empty((2 * ny, nx + 1), complex)
        waves.real[: ny + 1], waves.imag[: ny + 1] = parts[0], parts[1]
        waves.real[ny + 1 :], waves.imag[ny + 1 :] = parts[2, -2:0:-1], parts[3, -2:0:-1]
        return self._backward(waves)

    def grid(self, waves: np.ndarray) -> np.ndarray:
        return np.concatenate([waves, waves[-2:0:-1]])

    def product(self, grid: np.ndarray, field: np.ndarray) -> np.ndarray:
        waves = self._forward(field)
        waves *= grid
        return self._backward(waves)

    def _forward(self, field: np.ndarray) -> np.ndarray:
        rows = fft.rfft(field, self._padded[1], axis=1)
        waves: np.ndarray = fft.fft(rows, self._padded[0], axis=0, overwrite_x=True)
        return waves

    def _backward(self, waves: np.ndarray) -> np.ndarray:
        rows = fft.ifft(waves, axis=0, overwrite_x=True)[: self._shape[0]]
        field: np.ndarray = fft.irfft(rows, self._padded[1], axis=1)[:, : self._shape[1]]
        return field
