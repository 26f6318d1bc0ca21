r"""From the compliance of the surface, C(k), to the compliance between square elements.

The pressure is uniform over the loaded element, the displacement is the mean over the
receiving one, both a x a and centred on a lattice of pitch a:

    g(x, y) = (1 / 4 pi^2) int int C(|k|) sinc^2(k_x a / 2) sinc^2(k_y a / 2) e^{i k.x} dk_x dk_y

The integral becomes a sum by taking the surface as periodic, with a period long enough for
the waves to have died; on the lattice, wavenumbers that differ by 2 pi / a are one and the
same and are added up. C is computed at a few hundred wavenumbers and interpolated; that, the
weights and the sum over the lattice's wavenumbers are one real matrix that depends on the
geometry alone, so that a kernel costs one product of matrices.
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
        side, nodes, block = max(self.shape), self.wavenumbers.size, min(frequencies, BLOCK)
        weights = 8.0 * nodes * side * (2 * side + BLOCK)
        one_row = 8.0 * (self.period // 2) * (15 * (2 * _ALIASES + 1) ** 2 + 4 * nodes)
        plate = 16.0 * 40 * block * nodes
        return weights + one_row + plate + 40.0 * frequencies * self.shape[0] * self.shape[1]

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
        row, column = np.indices(self.shape)
        larger, smaller = np.maximum(row, column), np.minimum(row, column)
        packed = larger * (larger + 1) // 2 + smaller
        weights = _offset_weights(self)
        result = np.empty((compliance.shape[1], *self.shape), complex)
        for part, values in ((result.real, compliance.real), (result.imag, compliance.imag)):
            part[...] = (np.ascontiguousarray(values.T) @ weights.T)[:, packed]
        return result


def _count(low: float, high: float, step: float) -> int:
    return int(np.ceil(np.log(high / low) / step)) + 1


@lru_cache(maxsize=2)
def _offset_weights(lattice: ElementLattice) -> np.ndarray:
    """Matrix from C(k) at the wavenumbers to g [m/N per m/Pa] at the offsets.

    A row stands for an offset (i, j), j <= i: g is the same at (j, i). So is the Fourier symbol,
    whose cosine sum over the lattice's wavenumbers (q_y, q_x) is taken over q_x <= q_y and at
    both offsets.
    """
    half, side = lattice.period // 2 + 1, max(lattice.shape)
    turns = np.outer(np.arange(side), np.arange(half)) % lattice.period / lattice.period
    cosines = 2 * np.cos(2 * np.pi * turns)
    cosines[:, [0, -1]] /= 2  # of +q and -q there is but one
    total = np.zeros((side, side * lattice.wavenumbers.size))
    for first in range(0, half, BLOCK):
        rows = range(first, min(first + BLOCK, half))
        inner = np.stack([cosines[:, : row + 1] @ _symbol_weights(lattice, row) for row in rows])
        total += cosines[:, rows.start : rows.stop] @ inner.reshape(len(rows), -1)
    i, j = np.tril_indices(side)
    sums = total.reshape(side, side, -1)
    return (sums[i, j] + sums[j, i]) / (lattice.period * lattice.spacing) ** 2


def _symbol_weights(lattice: ElementLattice, row: int) -> np.ndarray:
    """Matrix from C(k) at the wavenumbers to the Fourier symbol [m3/Pa / m2] of the lattice.

    Of the symbol at (q_y, q_x), q = 2 pi i / period, for the q_y of a row and q_x <= q_y; half
    of it at q_x = q_y.
    """
    nodes, fraction = lattice.wavenumbers, np.arange(row + 1) / lattice.period
    aliases = np.arange(-_ALIASES, _ALIASES + 1)
    ky, kx = (fraction[-1] + aliases)[None, :, None], (fraction[:, None] + aliases)[:, None, :]
    wavenumber = 2 * np.pi / lattice.spacing * np.hypot(ky, kx)
    weight = (np.sinc(ky) * np.sinc(kx)) ** 2
    shape = (row + 1, aliases.size**2)
    weights = _interpolated(nodes, wavenumber.reshape(shape), weight.reshape(shape))
    weights[:, -1] += (_tail(fraction) + _tail(fraction[-1])) * nodes[-1] * lattice.spacing
    weights[-1] /= 2
    return weights


def _interpolated(nodes: np.ndarray, k: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Rows r of sum_j weight[r, j] C(k[r, j]), C interpolated between the nodes.

    k C is taken as a cubic in ln k through the four nearest nodes (it is flat where the plate
    is deep, and C itself is 1/k there); C(0) is a node of its own.
    """
    log_nodes, factors = _lagrange(nodes[1:].tobytes())
    positive = k > 0
    k = np.where(positive, k, nodes[1])
    log_k = np.log(k)
    first = np.clip(np.searchsorted(log_nodes, log_k) - 2, 0, log_nodes.size - 4)
    d = [log_k - log_nodes[first + i] for i in range(4)]
    scaled = weight * positive / k
    low, high = scaled * d[0] * d[1], scaled * d[2] * d[3]
    rows = np.zeros(k.shape[0] * nodes.size)
    place = np.arange(k.shape[0])[:, None] * nodes.size + first + 1
    for i, product in enumerate((high * d[1], high * d[0], low * d[3], low * d[2])):
        basis = product * factors[i, first]
        rows += np.bincount((place + i).ravel(), basis.ravel(), minlength=rows.size)
    rows = rows.reshape(k.shape[0], nodes.size)
    rows[:, 0] = (weight * ~positive).sum(axis=1)
    return rows


@lru_cache(maxsize=2)
def _lagrange(positive_nodes: bytes) -> tuple[np.ndarray, np.ndarray]:
    """ln k of the nodes, and k_i / prod (ln k_i - ln k_j) of each four, shape (4, fours)."""
    nodes = np.frombuffer(positive_nodes)
    log_nodes = np.log(nodes)
    x = np.stack([log_nodes[i : log_nodes.size - 3 + i] for i in range(4)])
    k = np.stack([nodes[i : nodes.size - 3 + i] for i in range(4)])
    gaps = x[:, None] - x[None] + np.eye(4)[..., None]
    return log_nodes, k / gaps.prod(axis=1)


def _tail(fraction: np.ndarray) -> np.ndarray:
    """What aliases beyond the last add to the symbol, per (k C) / a at the last node.

    There C is that of a half-space, c / k. For a far alias in x the weights sinc^2(k_y a / 2)
    of all aliases in y add up to one, which leaves sum_m sin^2(k_x a / 2) / (k_x a / 2)^2 c / k_x:
    two Hurwitz zeta functions. The same in y, here the sum over one of the two.
    """
    far = special.zeta(3, _ALIASES + 1 + fraction) + special.zeta(3, _ALIASES + 1 - fraction)
    return np.sin(np.pi * fraction) ** 2 * far / (2 * np.pi**3)
