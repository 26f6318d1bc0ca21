r"""From the compliance of the surface, C(k), to the compliance between square elements.

The pressure is uniform over the loaded element, the displacement is the mean over the
receiving one, both a x a and centred on a lattice of pitch a:

    g(x, y) = (1 / 4 pi^2) int int C(|k|) sinc^2(k_x a / 2) sinc^2(k_y a / 2) e^{i k.x} dk_x dk_y

The integral becomes a sum by taking the surface as periodic, with a period long enough for
the waves to have died; on the lattice, wavenumbers that differ by 2 pi / a are one and the
same and are added up. C is computed at a few hundred wavenumbers and interpolated; that, the
weights and the sum are one real matrix that depends on the geometry alone, so that a kernel
costs one product of matrices and one cosine transform a frequency.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import fft, special

#: aliases k + 2 pi m / a are added up to |m| = this in x and in y; a closed form does the rest
_ALIASES = 6
#: steps of ln k between the wavenumbers where C is computed: fine where waves travel
_FINE_STEP, _COARSE_STEP = 0.02, 0.06
#: frequencies taken at a time, so that fine lattices fit into memory
BLOCK = 32
#: wavenumber x element side above which C(k) is smooth
_SMOOTH_ABOVE = 3.0


@dataclass(frozen=True)
class ElementLattice:
    """The geometry: `shape` (ny, nx) elements of side `spacing` [m], repeated every `period`.

    `period` counts elements, is even, and holds the patch and room for the waves to die. With
    room for 10 thicknesses (`around`) kernels are accurate to 2e-5 of the self compliance.
    """

    shape: tuple[int, int]
    spacing: float
    period: int

    @classmethod
    def around(cls, shape: tuple[int, int], spacing: float, thickness: float) -> ElementLattice:
        """The lattice for a patch on a plate: at least 10 thicknesses to its next image."""
        wanted = max(shape) + int(np.ceil(10 * thickness / spacing))
        return cls(shape, spacing, 2 * fft.next_fast_len((wanted + 1) // 2, real=True))

    @property
    def wavenumbers(self) -> np.ndarray:
        """Where C(k) has to be known [rad/m]: zero, then rising geometrically."""
        lowest = 2 * np.pi / (self.period * self.spacing)
        smooth = max(_SMOOTH_ABOVE / self.spacing, 2 * lowest)
        highest = 2 * np.pi * (_ALIASES + 0.5) * np.sqrt(2) / self.spacing
        fine = np.geomspace(lowest, smooth, _count(lowest, smooth, _FINE_STEP))
        coarse = np.geomspace(smooth, highest, _count(smooth, highest, _COARSE_STEP))
        return np.concatenate([[0.0], fine, coarse[1:]])

    def bytes_needed(self, frequencies: int) -> float:
        """Memory that a kernel of so many frequencies takes to make, roughly."""
        half = self.period // 2 + 1
        weights = 8.0 * half * (half + 1) / 2 * self.wavenumbers.size
        one_block = 16.0 * BLOCK * (3 * half**2 + 40 * self.wavenumbers.size)
        return weights + one_block + 48.0 * frequencies * self.shape[0] * self.shape[1]

    def kernel(self, compliance: np.ndarray) -> np.ndarray:
        """Element compliance g [m/N] by offset, from C(k) at `wavenumbers`.

        Parameters
        ----------
        compliance : C [m/Pa], shape (wavenumbers, frequencies), complex; some `BLOCK`
            frequencies at a time take little memory.

        Returns
        -------
        g, shape (frequencies, ny, nx), complex: the displacement |di|, |dj| elements away
        from a unit force.
        """
        half = self.period // 2 + 1
        row, column = np.indices((half, half))
        larger, smaller = np.maximum(row, column), np.minimum(row, column)
        packed = larger * (larger + 1) // 2 + smaller
        # elements beyond half a period are far: the symmetry of the period serves there
        fold = [np.minimum(np.arange(n), self.period - np.arange(n)) for n in self.shape]
        area = (self.period * self.spacing) ** 2
        result = np.empty((compliance.shape[1], *self.shape), complex)
        for part, values in ((result.real, compliance.real), (result.imag, compliance.imag)):
            for place, symbol in zip(part, values.T @ _symbol_weights(self).T, strict=True):
                # even in x and y, so that the Fourier sum is a cosine transform (DCT-I)
                place[...] = fft.dctn(symbol[packed], type=1)[np.ix_(*fold)] / area
        return result


def _count(low: float, high: float, step: float) -> int:
    return int(np.ceil(np.log(high / low) / step)) + 1


@lru_cache(maxsize=2)
def _symbol_weights(lattice: ElementLattice) -> np.ndarray:
    """Matrix from C(k) at the wavenumbers to the Fourier symbol [m3/Pa / m2] of the lattice.

    A row stands for a wavenumber (q_y, q_x) of the lattice, q = 2 pi i / period, with
    q_x <= q_y: the symbol is symmetric.
    """
    nodes = lattice.wavenumbers
    fraction = np.arange(lattice.period // 2 + 1) / lattice.period
    aliases = np.arange(-_ALIASES, _ALIASES + 1)
    weights = np.zeros((fraction.size * (fraction.size + 1) // 2, nodes.size))
    last = 0
    for row, fy in enumerate(fraction):
        ky, kx = (fy + aliases)[None, :, None], (fraction[: row + 1, None] + aliases)[:, None, :]
        wavenumber = 2 * np.pi / lattice.spacing * np.hypot(ky, kx)
        weight = (np.sinc(ky) * np.sinc(kx)) ** 2
        first, last = last, last + row + 1
        shape = (row + 1, aliases.size**2)
        weights[first:last] = _interpolated(nodes, wavenumber.reshape(shape), weight.reshape(shape))
    rest = _tail(fraction)[np.tril_indices(fraction.size)]
    weights[:, -1] += rest * nodes[-1] * lattice.spacing
    return weights


def _interpolated(nodes: np.ndarray, k: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Rows r of sum_j weight[r, j] C(k[r, j]), C interpolated between the nodes.

    k C is taken as a cubic in ln k through the four nearest nodes (it is flat where the plate
    is deep, and C itself is 1/k there); C(0) is a node of its own.
    """
    log_nodes, positive = np.log(nodes[1:]), k > 0
    k = np.where(positive, k, nodes[1])
    log_k = np.log(k)
    first = np.clip(np.searchsorted(log_nodes, log_k) - 2, 0, log_nodes.size - 4)
    rows = np.zeros(k.shape[0] * nodes.size)
    place = np.arange(k.shape[0])[:, None] * nodes.size + first + 1
    for i in range(4):
        basis = weight * positive * nodes[1:][first + i] / k
        for j in range(4):
            if j != i:
                x_i, x_j = log_nodes[first + i], log_nodes[first + j]
                basis = basis * (log_k - x_j) / (x_i - x_j)
        rows += np.bincount((place + i).ravel(), basis.ravel(), minlength=rows.size)
    rows = rows.reshape(k.shape[0], nodes.size)
    rows[:, 0] = (weight * ~positive).sum(axis=1)
    return rows


def _tail(fraction: np.ndarray) -> np.ndarray:
    """What aliases beyond the last add to the symbol, per (k C) / a at the last node.

    There C is that of a half-space, c / k. For a far alias in x the weights sinc^2(k_y a / 2)
    of all aliases in y add up to one, which leaves sum_m sin^2(k_x a / 2) / (k_x a / 2)^2 c / k_x:
    two Hurwitz zeta functions. The same in y.
    """
    far = special.zeta(3, _ALIASES + 1 + fraction) + special.zeta(3, _ALIASES + 1 - fraction)
    one = np.sin(np.pi * fraction) ** 2 * far / (2 * np.pi**3)
    return one[:, None] + one[None, :]
