"""Products of kernel and element forces on the lattice, and the memory of past forces.

The displacement of an element depends on its distance to the loaded one alone, so that every
sum over elements is a convolution: a product after a Fourier transform of the patch padded to
twice its size. Kernels are even in x and in y, their transforms real.
"""

from __future__ import annotations

from copy import copy
from functools import cached_property

import numpy as np

from tyrecontact.tread.kernels import Kernel

#: up to this many elements a product with the dense g_0 is faster than one by transforms
_DENSE_UP_TO = 1024


class Compliance:
    """Compliance between all elements within a step, ready for products with element forces.

    Parameters
    ----------
    values : displacement per force by offset [m/N], shape (ny, nx).
    shared : displacement of all elements per unit of the total force [m/N]: a rigid motion.

    Attributes
    ----------
    shape : (ny, nx) elements.
    self_compliance : displacement of an element under its own force [m/N].
    """

    def __init__(self, values: np.ndarray, shared: float = 0.0) -> None:
        self.values, self.shared = values, shared
        self.shape: tuple[int, int] = values.shape
        self.self_compliance = float(values[0, 0]) + shared
        self._spectrum = transform_even(values[None])[0]
        every = np.arange(values.size)
        self._dense = self._between(every) if values.size <= _DENSE_UP_TO else None

    def with_shared(self, shared: float) -> Compliance:
        """The same with another rigid motion [m/N]; nothing is computed anew."""
        if shared == self.shared:
            return self
        other = copy(self)
        other.self_compliance = self.self_compliance - self.shared + shared
        other.shared = shared
        return other

    def displacement(self, force: np.ndarray) -> np.ndarray:
        """Displacement [m] under element forces [N], both (ny nx,)."""
        if self._dense is not None:
            near = self._dense @ force
            return near + self.shared * force.sum() if self.shared else near
        padded = (2 * self.shape[0], 2 * self.shape[1])
        spectrum = self._spectrum * np.fft.rfft2(force.reshape(self.shape), s=padded)
        near = np.fft.irfft2(spectrum, s=padded)[: self.shape[0], : self.shape[1]]
        return near.ravel() + self.shared * force.sum()

    def matrix(self, elements: np.ndarray) -> np.ndarray:
        """Dense matrix between the listed elements (flat indices) [m/N]."""
        return self._between(elements) + self.shared

    def _between(self, elements: np.ndarray) -> np.ndarray:
        row, column = np.divmod(elements, self.shape[1])
        dy = np.abs(np.subtract.outer(row, row))
        dx = np.abs(np.subtract.outer(column, column))
        return self.values[dy, dx]


class LatticeKernel:
    """A kernel ready for products with element forces.

    Attributes
    ----------
    kernel : the `Kernel`, values (lags, ny, nx) [m/N].
    shape : (ny, nx) elements.
    now : compliance within a step, g_0.
    """

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.shape: tuple[int, int] = kernel.values.shape[1:]
        self.padded = (2 * self.shape[0], 2 * self.shape[1])
        self.spectra = transform_even(kernel.values)
        self.now = Compliance(kernel.values[0])

    @cached_property
    def at_rest(self) -> Compliance:
        """Compliance under forces that have not changed for as long as the kernel remembers."""
        return Compliance(self.kernel.static_compliance)

    def spectrum(self, force: np.ndarray) -> np.ndarray:
        """Transform of the padded element forces [N], (ny, nx) -> (2 ny, nx + 1), complex."""
        return np.fft.rfft2(force, s=self.padded)

    def displacement(self, spectrum: np.ndarray) -> np.ndarray:
        """Displacement [m], (ny, nx), from the product of a kernel's and forces' transforms."""
        return np.fft.irfft2(spectrum, s=self.padded)[: self.shape[0], : self.shape[1]]


def transform_even(values: np.ndarray) -> np.ndarray:
    """Real transforms of kernels by offset, (lags, ny, nx) -> (lags, 2 ny, nx + 1)."""
    ny, nx = values.shape[1:]
    padded = np.zeros((values.shape[0], 2 * ny, 2 * nx))
    padded[:, :ny, :nx] = values
    padded[:, ny + 1 :, :nx] = values[:, :0:-1, :]
    padded[:, :, nx + 1 :] = padded[:, :, nx - 1 : 0 : -1]
    return np.fft.rfft2(padded).real


class History:
    """Past element forces, and the displacement that they still cause.

    u_n = sum_(j=1)^(lags-1) g_j * F_(n-j), over all elements that carried force then.
    """

    def __init__(self, kernel: LatticeKernel) -> None:
        self._kernel = kernel
        lagged = kernel.spectra[1:].reshape(-1, kernel.spectra[0].size)
        # real and imaginary parts side by side: the sum over lags is then one of real numbers
        self._lagged = np.repeat(lagged, 2, axis=1)
        self._past = np.zeros_like(self._lagged)
        self._newest = 0  # row of the last step; the one before is the next row, around the end
        self._steps = 0

    def displacement(self) -> np.ndarray:
        """Displacement of the coming step due to all past forces [m], (ny, nx)."""
        rows = len(self._past)
        count = min(self._steps, rows)
        if count == 0:
            return np.zeros(self._kernel.shape)
        split = min(count, rows - self._newest)
        newer = self._past[self._newest : self._newest + split]
        total = np.einsum("lm,lm->m", self._lagged[:split], newer)
        if split < count:
            older = self._past[: count - split]
            total += np.einsum("lm,lm->m", self._lagged[split:count], older)
        return self._kernel.displacement(
            total.view(complex).reshape(self._kernel.spectra.shape[1:])
        )

    def remember(self, force: np.ndarray) -> None:
        """Take the element forces [N], (ny, nx), of the step that has been solved."""
        self._steps += 1
        if len(self._past):
            self._newest = (self._newest - 1) % len(self._past)
            self._past[self._newest] = self._kernel.spectrum(force).ravel().view(float)

    def settle(self, force: np.ndarray) -> None:
        """Take element forces [N], (ny, nx), that have acted for longer than is remembered."""
        if len(self._past):
            self._past[:] = self._kernel.spectrum(force).ravel().view(float)
        self._steps = len(self._past)
