r"""Transforms in which a sum over elements is a product, element by element of the transform.

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


class Transform(Protocol):
    """Between fields on the lattice, shape (ny, nx), and coefficients, shape (parts, waves).

    All `parts` of a coefficient (real and imaginary, or one alone) share a wave, and with it a
    number of the kernel's, shape (waves,).
    """

    parts: int
    waves: int

    def forward(self, field: np.ndarray) -> np.ndarray:
        """Coefficients (parts, waves) of a field (ny, nx)."""

    def backward(self, coefficients: np.ndarray) -> np.ndarray:
        """The field (ny, nx) of coefficients (parts, waves)."""

    def of_kernel(self, values: np.ndarray) -> np.ndarray:
        """What a kernel by offset (..., ny, nx) multiplies each wave with, (..., waves)."""

    def product(self, kernel: np.ndarray, field: np.ndarray) -> np.ndarray:
        """The sum over elements (ny, nx): there, times the kernel's numbers (waves,), and back."""


def transform(shape: tuple[int, int]) -> Transform:
    """The faster transform for a patch of (ny, nx) elements; made once for each shape."""
    return _matrices(shape) if max(shape) <= MATRICES_UP_TO else Fourier(shape)


class Matrices:
    """Real waves, by a product with a matrix in each direction."""

    parts = 1

    def __init__(self, shape: tuple[int, int]) -> None:
        self._across, self._along = (_waves(count) for count in shape)
        self._across_back = np.ascontiguousarray(self._across.T)
        self._along_back = np.ascontiguousarray(self._along.T)
        self._numbers = tuple(_wave_numbers(count) for count in shape)
        self._sums = tuple(_kernel_sums(count) for count in shape)
        self._grid = (2 * shape[0], 2 * shape[1])
        self.waves = self._grid[0] * self._grid[1]

    def forward(self, field: np.ndarray) -> np.ndarray:
        return (self._across @ field @ self._along_back).reshape(1, -1)

    def backward(self, coefficients: np.ndarray) -> np.ndarray:
        field: np.ndarray = self._across_back @ coefficients.reshape(self._grid) @ self._along
        return field

    def of_kernel(self, values: np.ndarray) -> np.ndarray:
        quarter = self._sums[0] @ values @ self._sums[1].T
        whole = quarter[..., self._numbers[0][:, None], self._numbers[1]]
        return whole.reshape(*values.shape[:-2], -1)

    def product(self, kernel: np.ndarray, field: np.ndarray) -> np.ndarray:
        waves = self._across @ field @ self._along_back
        waves *= kernel.reshape(self._grid)
        result: np.ndarray = self._across_back @ waves @ self._along
        return result


@lru_cache(maxsize=8)
def _matrices(shape: tuple[int, int]) -> Matrices:
    return Matrices(shape)


def _wave_numbers(count: int) -> np.ndarray:
    """k of each row of `_waves`: all cosines and sines that are not zero on the lattice."""
    last = count - 1 + count % 2  # about the centre, k = n is a sine if n is even, else a cosine
    return np.concatenate([np.arange(last + 1), np.arange(1, 2 * count - last)])


def _waves(count: int) -> np.ndarray:
    """B, shape (2 count, count)."""
    k = _wave_numbers(count)[:, None]
    phase = np.pi * k * (np.arange(count) - (count - 1) / 2) / count
    cosine = np.arange(2 * count)[:, None] < count + count % 2
    weight = np.sqrt(np.where((k == 0) | (k == count), 1, 2) / (2 * count))
    waves: np.ndarray = weight * np.where(cosine, np.cos(phase), np.sin(phase))
    return waves


def _kernel_sums(count: int) -> np.ndarray:
    """From g_x to lambda_k, shape (count + 1, count)."""
    k, x = np.arange(count + 1)[:, None], np.arange(count)
    sums: np.ndarray = np.where(x > 0, 2, 1) * np.cos(np.pi * k * x / count)
    return sums


class Fourier:
    """Complex waves by the fast transform; rows and columns of zeros are left out."""

    parts = 2

    def __init__(self, shape: tuple[int, int]) -> None:
        self._shape, self._padded = shape, (2 * shape[0], 2 * shape[1])
        self._grid = (2 * shape[0], shape[1] + 1)
        self.waves = self._grid[0] * self._grid[1]

    def forward(self, field: np.ndarray) -> np.ndarray:
        waves = self._forward(field).ravel()
        return np.stack([waves.real, waves.imag])

    def backward(self, coefficients: np.ndarray) -> np.ndarray:
        waves = np.empty(self._grid, complex)
        waves.real, waves.imag = coefficients.reshape(2, *self._grid)
        return self._backward(waves)

    def of_kernel(self, values: np.ndarray) -> np.ndarray:
        sums = [_kernel_sums(count) for count in self._shape]
        quarter = sums[0] @ values @ sums[1].T
        mirrored = quarter[..., -2:0:-1, :]
        return np.concatenate([quarter, mirrored], axis=-2).reshape(*values.shape[:-2], -1)

    def product(self, kernel: np.ndarray, field: np.ndarray) -> np.ndarray:
        waves = self._forward(field)
        waves *= kernel.reshape(self._grid)
        return self._backward(waves)

    def _forward(self, field: np.ndarray) -> np.ndarray:
        rows = fft.rfft(field, self._padded[1], axis=1)
        waves: np.ndarray = fft.fft(rows, self._padded[0], axis=0, overwrite_x=True)
        return waves

    def _backward(self, waves: np.ndarray) -> np.ndarray:
        rows = fft.ifft(waves, axis=0, overwrite_x=True)[: self._shape[0]]
        field: np.ndarray = fft.irfft(rows, self._padded[1], axis=1)[:, : self._shape[1]]
        return field
