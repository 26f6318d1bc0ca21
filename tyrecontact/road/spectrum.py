r"""Power spectra of roads, and the isotropic spectrum behind that of a profile.

With f in waves per metre, S1 the two-sided spectrum of a profile [m^3] and S2 that of an isotropic
surface [m^4],

    int S1 df = int S2 2 pi f df = <z^2>,    S1(fx) = 2 int_fx^inf S2(f) f / sqrt(f^2 - fx^2) df.

The last is an Abel transform. With S2 constant on rings it is a triangular matrix, whose inverse
subtracts large numbers; non-negative least squares (relative residuals) keeps S2 a spectrum.
Persson's C(q), q = 2 pi f, is S2 / (4 pi^2); SurfaceTopography's is S2 itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy  # its parts are loaded where they are first used

from tyrecontact.errors import InputError

#: rings per octave on which an isotropic spectrum is constant
_PER_OCTAVE = 3


@dataclass(frozen=True)
class Isotropic:
    """Spectrum S2 of an isotropic surface on rings: edges [1/m], shape (n + 1,); density [m^4]."""

    edges: np.ndarray
    density: np.ndarray

    @property
    def variance(self) -> float:
        """Mean square height [m^2]."""
        return float(np.pi * np.sum(self.density * np.diff(self.edges**2)))

    def at(self, frequency: np.ndarray) -> np.ndarray:
        """Density at frequencies [1/m], any shape: log-log between rings, 0 outside them."""
        middles = np.sqrt(self.edges[1:] * self.edges[:-1])
        held = self.density > 0
        if not held.any():
            return np.zeros(np.shape(frequency))
        inside = (frequency >= self.edges[0]) & (frequency <= self.edges[-1])
        safe = np.where(inside, frequency, middles[0])
        logs = np.interp(np.log(safe), np.log(middles[held]), np.log(self.density[held]))
        return np.where(inside, np.exp(logs), 0.0)


def of_profile(heights: np.ndarray, pitch: float, longest: float) -> tuple[np.ndarray, np.ndarray]:
    """Two-sided spectrum of a profile (Welch, Hann windows four longest waves long).

    Parameters
    ----------
    heights : z [m], shape (n,), none missing. pitch : [m].
    longest : wavelength that is to be resolved [m].

    Returns
    -------
    Frequencies [1/m], from 1/longest up, and S1 [m^3] at them.
    """
    segment = min(len(heights), int(np.ceil(4 * longest / pitch)))
    if segment < 64:
        raise InputError(
            f"profile must have at least 64 heights to give a spectrum, got {len(heights)}"
        )
    frequency, one_sided = scipy.signal.welch(heights, 1 / pitch, nperseg=segment, detrend="linear")
    kept = (frequency >= (1 - 1e-9) / longest) & (frequency > 0)
    return frequency[kept], one_sided[kept] / 2


def of_map(heights: np.ndarray, pitch: float, rings: int = 24) -> tuple[np.ndarray, np.ndarray]:
    """Spectrum S2 of a map, averaged over rings (Hann window in both directions).

    Parameters
    ----------
    heights : z [m], shape (ny, nx). pitch : [m].

    Returns
    -------
    Frequencies [1/m] and S2 [m^4], shape (rings,) less those that hold no wave.
    """
    window = np.multiply.outer(*(scipy.signal.windows.hann(n, sym=False) for n in heights.shape))
    seen = (heights - heights.mean()) * window
    power = np.abs(np.fft.fft2(seen)) ** 2 * pitch**2 / np.sum(window**2)
    axes = [np.fft.fftfreq(n, pitch) for n in heights.shape]
    frequency = np.hypot(*np.meshgrid(*axes, indexing="ij"))
    edges = np.geomspace(2 / (min(heights.shape) * pitch), 0.5 / pitch, rings + 1)
    found = [(low, high, (frequency >= low) & (frequency < high)) for low, high in pairwise(edges)]
    full = [(np.sqrt(low * high), power[ring].mean()) for low, high, ring in found if ring.any()]
    return np.array([f for f, _ in full]), np.array([density for _, density in full])


def isotropic(frequency: np.ndarray, density: np.ndarray) -> Isotropic:
    """The isotropic spectrum whose profiles have the given one.

    Parameters
    ----------
    frequency : [1/m], growing, shape (n,). density : S1, two-sided [m^3], shape (n,).

    Raises
    ------
    InputError : a profile without any height, or with fewer than 8 frequencies.
    """
    if len(frequency) < 8 or not density.max() > 0:
        raise InputError(
            f"profile must have a spectrum of at least 8 waves, got {len(frequency)} with "
            f"a largest density of {density.max(initial=0.0):g} m^3"
        )
    octaves = np.log2(frequency[-1] / frequency[0])
    edges = np.geomspace(frequency[0], frequency[-1], int(np.ceil(_PER_OCTAVE * octaves)) + 1)
    bins = np.clip(np.searchsorted(edges, frequency, side="right") - 1, 0, len(edges) - 2)
    held = np.bincount(bins, minlength=len(edges) - 1) > 0
    places = [np.flatnonzero(bins == n) for n in np.flatnonzero(held)]
    middle = np.array([np.exp(np.log(frequency[place]).mean()) for place in places])
    profile = np.maximum([density[place].mean() for place in places], 1e-12 * density.max())
    matrix = abel_matrix(middle, edges)
    # a typical S2 of each ring scales its column, so that all unknowns are of the order of one
    typical = np.interp(np.sqrt(edges[1:] * edges[:-1]), middle, profile / middle)
    scaled = matrix * typical / profile[:, None]
    solution, _ = scipy.optimize.nnls(scaled, np.ones(len(middle)))
    return Isotropic(edges, solution * typical)


def abel_matrix(frequency: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """S1 at frequencies from a unit S2 on each ring [1/m], shape (frequencies, rings).

    2 int_a^b f / sqrt(f^2 - fx^2) df = 2 [sqrt(b^2 - fx^2) - sqrt(a^2 - fx^2)], from fx on.
    """
    root = np.sqrt(np.maximum(edges**2 - frequency[:, None] ** 2, 0.0))
    return 2 * np.diff(root, axis=1)
