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
        symbol = (self.period // 2 + 1) ** 2
        nodes = self.wavenumbers.size
        return 8.0 * symbol * nodes + 16.0 * frequencies * (3 * symbol + 40 * nodes)

    def kernel(self, compliance: np.ndarray) -> np.ndarray:
        """Element compliance g [m/N] by offset, from C(k) at `wavenumbers`.

        Parameters
        ----------
        compliance : C [m/Pa], shape (wavenumbers, frequencies), complex.

        Returns
        -------
        g, shape (frequencies, ny, nx), complex: the displacement |di|, |dj| elements away
        from a unit force.
        """
        half = self.period // 2 + 1
        symbol = self.symbol(compliance).reshape(half, half, -1)
        ny, nx = self.shape
        # even in x and y, so that the Fourier sum over a period is a cosine transform (DCT-I)
        parts = [
            fft.dctn(part, type=1, axes=(0, 1))[:ny, :nx] for part in (symbol.real, symbol.imag)
        ]
        area = (self.period * self.spacing) ** 2
        return np.moveaxis(parts[0] + 1j * parts[1], -1, 0) / area

    def symbol(self, compliance: np.ndarray) -> np.ndarray:
        """Fourier symbol of the lattice [m3/Pa / m2], shape (half^2, frequencies)."""
        weights = _symbol_weights(self)
        return weights @ compliance.real + 1j * (weights @ compliance.imag)


def _count(low: float, high: float, step: float) -> int:
    return int(np.ceil(np.log(high / low) / step)) + 1


@lru_cache(maxsize=2)
def _symbol_weights(lattice: ElementLattice) -> np.ndarray:
    """Matrix from C(k) at the wavenumbers to the symbol at (q_y, q_x), q = 2 pi i / period."""
    nodes = lattice.wavenumbers
    fraction = np.arange(lattice.period // 2 + 1) / lattice.period
    aliases = np.arange(-_ALIASES, _ALIASES + 1)
    kx = fraction[:, None] + aliases
    weights = np.zeros((fraction.size**2, nodes.size))
    for row, fy in enumerate(fraction):
        ky = (fy + aliases)[None, :, None]
        wavenumber = 2 * np.pi / lattice.spacing * np.hypot(ky, kx[:, None, :])
        weight = (np.sinc(ky) * np.sinc(kx[:, None, :])) ** 2
        block = slice(row * fraction.size, (row + 1) * fraction.size)
        shape = (fraction.size, aliases.size**2)
        weights[block] = _interpolated(nodes, wavenumber.reshape(shape), weight.reshape(shape))
    weights[:, -1] += (_tail(fraction) * nodes[-1] * lattice.spacing).ravel()
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
    rows = np.zeros((k.shape[0], nodes.size))
    row = np.arange(k.shape[0])[:, None]
    for i in range(4):
        basis = weight * positive * nodes[1:][first + i] / k
        for j in range(4):
            if j != i:
                x_i, x_j = log_nodes[first + i], log_nodes[first + j]
                basis = basis * (log_k - x_j) / (x_i - x_j)
        np.add.at(rows, (row, first + i + 1), basis)
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
