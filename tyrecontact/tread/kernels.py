r"""Element kernels in time: displacement per force, by lag and by offset (physics, section 5).

A kernel g turns the history of element forces into displacements of the tread,

    u_n = sum_j g_j * F_(n-j),    j = 0 .. lags - 1,   * a convolution over the elements,

the time step included in g. Its z-transform G(z) decides on stability: with every monotone
spring the scheme is energy-stable if Herm[(1 - e^{-i theta}) G(e^{i theta})] >= 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import fft

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.tread.elements import BLOCK, ElementLattice
from tyrecontact.tread.materials import Layer
from tyrecontact.tread.plate import surface_compliance
from tyrecontact.tread.stability import critical_angle, critical_stiffness, hermitian_symbol

__all__ = [
    "Kernel",
    "band_frequencies",
    "band_limited",
    "critical_angle",
    "critical_stiffness",
    "hermitian_symbol",
    "interpolated",
    "passive",
    "passive_mobility",
    "quadrature_frequencies",
    "static",
]

#: convolution quadratures of `passive`
QUADRATURES = ("BDF1", "BDF2")
#: a kernel whose making takes more memory is refused
MAX_BYTES = 8e9


@dataclass(frozen=True)
class Kernel:
    """Displacement per force by lag and offset.

    Attributes
    ----------
    values : [m/N], shape (lags, ny, nx); entry (n, i, j) is the displacement n steps later
        and |i|, |j| elements away; the time step is included.
    spacing : side of an element [m].
    time_step : [s]; inf for a static kernel.
    """

    values: np.ndarray
    spacing: float
    time_step: float

    @property
    def lags(self) -> int:
        return self.values.shape[0]

    @property
    def static_compliance(self) -> np.ndarray:
        """Displacement per constant force [m/N], shape (ny, nx): the sum over the lags."""
        return self.values.sum(axis=0)


def passive(
    layers: Sequence[Layer],
    shape: tuple[int, int],
    spacing: float,
    time_step: float,
    lags: int = 256,
    quadrature: str = "BDF2",
) -> Kernel:
    """Kernel by convolution quadrature: exact in the statics, energy-stable as told below.

        g_n = 1 / (L r^n) sum_l C(delta(zeta_l) / dt) e^{2 pi i n l / L},
        zeta_l = r e^{-2 pi i l / L},  L = 2 lags,  r = eps^(1/L),
        delta = (1 - z) + (1 - z)^2 / 2 (BDF2, second order in dt)  or  1 - z (BDF1, first order)

    What the plate has still to creep after the last lag is spread over the last quarter of the
    lags, so that the kernel's sum is the static compliance. (Added to a single lag it would come
    back as an echo that is not passive.) Energy-stable holds for lags that outlast the ringing and
    the creep of the plate, and with BDF1. With BDF2 (1 - z) C = s C dt 2 / (3 - z), whose phase may
    leave the right half-plane where a plate is mass-like and hardly damped: at fine steps on large
    patches stiff springs may draw energy. `critical_stiffness` tells.

    Parameters
    ----------
    layers : from the top down, rigid below the last; their moduli causal, for complex s.
    shape : (ny, nx) elements.  spacing : their side [m].
    time_step : [s].  lags : number of lags kept.
    quadrature : "BDF2" or "BDF1".

    Source: C. Lubich, Numer. Math. 52 (1988) 129-145 and 413-425.
    """
    frequency = quadrature_frequencies(time_step, lags, quadrature)
    spectrum = _element_spectrum(np.append(frequency, 0), layers, shape, spacing)
    growth, window = _contour_radius(lags) ** -np.arange(lags), _tail_window(lags)
    values = np.empty((lags, *shape))
    for row in range(shape[0]):  # a row at a time takes little memory
        turned = np.fft.irfft(spectrum[:-1, row], n=2 * lags, axis=0)[:lags] * growth[:, None]
        creep = spectrum[-1, row].real - turned.sum(axis=0)
        values[:, row] = turned + np.multiply.outer(window, creep)
    return Kernel(values, spacing, time_step)


def passive_mobility(
    layers: Sequence[Layer],
    shape: tuple[int, int],
    spacing: float,
    time_step: float,
    lags: int = 256,
) -> Kernel:
    """Kernel by "two times the real part" of the mobility i w C, and a backward sum.

        m_n = 2 x causal half of the inverse transform of Re(i w C),   g_n = dt sum_(j<=n) m_j

    (1 - z^-1) G(z) is then dt M(z), whose Hermitian part is Re(i w C) >= 0 at every frequency of
    the transform: energy-stable for any layers with losses, a tabulated modulus included. What it
    pays is the statics, as the mobility above half the sampling rate is missing: for the default
    tread at 51.2 kHz an element's own compliance at rest is 16 % low, that of the patch 3 % high.

    Parameters as `band_limited`.
    """
    frequency = band_frequencies(time_step, lags)
    spectrum = _element_spectrum(frequency, layers, shape, spacing)
    mobility = (frequency[:, None, None] * spectrum).real
    return Kernel(time_step * _causal_half(mobility).cumsum(axis=0), spacing, time_step)


def band_limited(
    layers: Sequence[Layer],
    shape: tuple[int, int],
    spacing: float,
    time_step: float,
    lags: int = 256,
) -> Kernel:
    """Kernel by "two times the real part" of the transfer functions up to half the sampling rate.

    The thesis' kernel (chapter 3.3). The real part of C(2 pi i f), f = 0 .. 1 / (2 dt), has an
    even inverse transform; twice its causal half, the first sample once, is the kernel. At the
    Nyquist frequency its transform is Re C alone, which is not positive: the plate is mass-like
    there. That is why time stepping with it is unstable on stiff springs (`critical_stiffness`).

    Parameters as `passive`; moduli need be known at s = 2 pi i f alone.
    """
    frequency = band_frequencies(time_step, lags)
    spectrum = _element_spectrum(frequency, layers, shape, spacing)
    return Kernel(_causal_half(spectrum.real), spacing, time_step)


def static(layers: Sequence[Layer], shape: tuple[int, int], spacing: float) -> Kernel:
    """Kernel of one lag: the tread at rest under its forces. Parameters as `passive`."""
    spectrum = _element_spectrum(np.zeros(1), layers, shape, spacing)
    return Kernel(spectrum.real.copy(), spacing, np.inf)


def interpolated(kernel: Kernel, factor: int) -> Kernel:
    """The kernel at a time step `factor` times shorter, by the thesis' linear interpolation.

    (N - 1) factor + 1 lags. The statics change: the sum falls by
    (1 - 1/factor)(g_0 + g_(N-1)) / 2, about 10 % of the self compliance at factor 2.
    """
    if factor not in (1, 2, 4):
        raise InputError(f"time_resolution_factor must be 1, 2 or 4 to interpolate, got {factor}")
    old = np.arange(kernel.lags) * factor
    new = np.arange((kernel.lags - 1) * factor + 1)
    left = np.minimum(new // factor, kernel.lags - 2) if kernel.lags > 1 else new
    share = ((new - old[left]) / factor)[:, None, None]
    right = np.minimum(left + 1, kernel.lags - 1)
    values = (1 - share) * kernel.values[left] + share * kernel.values[right]
    return replace(kernel, values=values / factor, time_step=kernel.time_step / factor)


def quadrature_frequencies(time_step: float, lags: int, quadrature: str = "BDF2") -> np.ndarray:
    """Where `passive` needs the compliance: delta(zeta_l) / dt [1/s], shape (lags + 1,)."""
    _require_time(time_step, lags)
    if quadrature not in QUADRATURES:
        raise unknown_name("quadrature", quadrature, QUADRATURES)
    backward = 1 - _contour_radius(lags) * np.exp(-1j * np.pi * np.arange(lags + 1) / lags)
    return (backward + (backward**2 / 2 if quadrature == "BDF2" else 0)) / time_step


def band_frequencies(time_step: float, lags: int) -> np.ndarray:
    """Where `band_limited` needs the compliance: 2 pi i f [1/s], f up to 1 / (2 dt)."""
    _require_time(time_step, lags)
    return 2j * np.pi * np.fft.rfftfreq(2 * lags, time_step)


def _causal_half(spectrum: np.ndarray) -> np.ndarray:
    """Twice the causal half of the inverse transform of a real spectrum, the first sample once."""
    lags = spectrum.shape[0] - 1
    values = fft.dct(spectrum, type=1, axis=0)[:lags] / lags
    values[0] /= 2
    return values


def _tail_window(lags: int) -> np.ndarray:
    """A smooth window over the last quarter of the lags, of sum one."""
    window = np.zeros(lags)
    tail = max(lags // 4, 1)
    window[-tail:] = np.sin(np.pi * (np.arange(tail) + 0.5) / tail) ** 2
    return window / window.sum()


def _contour_radius(lags: int) -> float:
    return float(np.finfo(float).eps ** (1 / (2 * lags)))


def _element_spectrum(
    laplace_frequency: np.ndarray,
    layers: Sequence[Layer],
    shape: tuple[int, int],
    spacing: float,
) -> np.ndarray:
    """Element compliance [m/N] at each s [1/s], shape (frequencies, ny, nx), complex."""
    if not 0 < spacing < np.inf:
        raise InputError(f"spacing must be positive and finite, got {spacing} m")
    lattice = ElementLattice.around(shape, spacing, sum(layer.thickness for layer in layers))
    size = lattice.bytes_needed(laplace_frequency.size)
    if size > MAX_BYTES:
        raise InputError(
            f"a kernel must take at most {MAX_BYTES / 1e9:.0f} GB, got {size / 1e9:.0f} GB: "
            "use fewer lags, fewer elements or thinner layers"
        )
    k = lattice.wavenumbers[:, None]
    spectrum = np.empty((laplace_frequency.size, *shape), complex)
    for first in range(0, laplace_frequency.size, BLOCK):
        block = slice(first, first + BLOCK)
        spectrum[block] = lattice.kernel(
            surface_compliance(k, laplace_frequency[None, block], layers)
        )
    return spectrum


def _require_time(time_step: float, lags: int) -> None:
    if not 0 < time_step < np.inf:
        raise InputError(f"time_step must be positive and finite, got {time_step} s")
    if not lags >= 2:
        raise InputError(f"lags must be at least 2, got {lags}")
