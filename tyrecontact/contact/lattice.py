"""Products of kernel and element forces on the lattice, and the memory of past forces.

The displacement of an element depends on its distance to the loaded one alone, so that every
sum over elements is a convolution: a product after a Fourier transform of the patch padded to
twice its size. Kernels are even in x and in y, their transforms real.
"""

from __future__ import annotations

import numpy as np

from tyrecontact.tread.kernels import Kernel

#: up to this many elements a product with the dense g_0 is faster than one by transforms
_DENSE_UP_TO = 1024


class LatticeKernel:
    """A kernel ready for products with element forces.

    Attributes
    ----------
    kernel : the `Kernel`, values (lags, ny, nx) [m/N].
    shape : (ny, nx) elements.
    """

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.shape: tuple[int, int] = kernel.values.shape[1:]
        self._padded = (2 * self.shape[0], 2 * self.shape[1])
        self.spectra = self._transform_even(kernel.values)
        count = self.shape[0] * self.shape[1]
        self._dense = self.instant_matrix(np.arange(count)) if count <= _DENSE_UP_TO else None

    @property
    def self_compliance(self) -> float:
        """Displacement of an element under its own force, within the step [m/N]."""
        return float(self.kernel.values[0, 0, 0])

    def spectrum(self, force: np.ndarray) -> np.ndarray:
        """Transform of the padded element forces [N], (ny, nx) -> (2 ny, nx + 1), complex."""
        return np.fft.rfft2(force, s=self._padded)

    def displacement(self, spectrum: np.ndarray) -> np.ndarray:
        """Displacement [m], (ny, nx), from the product of a kernel's and forces' transforms."""
        return np.fft.irfft2(spectrum, s=self._padded)[: self.shape[0], : self.shape[1]]

    def instant(self, force: np.ndarray) -> np.ndarray:
        """Displacement within the same step [m] under element forces [N], both (ny nx,)."""
        if self._dense is not None:
            return self._dense @ force
        spectrum = self.spectra[0] * self.spectrum(force.reshape(self.shape))
        return self.displacement(spectrum).ravel()

    def instant_matrix(self, elements: np.ndarray) -> np.ndarray:
        """g_0 between the listed elements (flat indices) as a dense matrix [m/N]."""
        row, column = np.divmod(elements, self.shape[1])
        dy = np.abs(np.subtract.outer(row, row))
        dx = np.abs(np.subtract.outer(column, column))
        return self.kernel.values[0][dy, dx]

    def _transform_even(self, values: np.ndarray) -> np.ndarray:
        ny, nx = self.shape
        padded = np.zeros((values.shape[0], *self._padded))
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
