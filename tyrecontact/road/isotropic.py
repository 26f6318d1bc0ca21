r"""A two-dimensional road with the spectrum and the heights of a measured profile.

Random phases give the spectrum but Gaussian heights. Ranks give the heights (the n-th highest
pixel gets the n-th highest of the profile) and disturb the spectrum a little. Doing both in turn
converges to a surface that has both (Schreiber & Schmitz, Phys. Rev. Lett. 77, 1996).

A line across a wave sees it longer than it is: of waves shorter than a limit, a line has fewer than
the surface. So the profile gives the shape of the distribution, and the spectrum its width.
"""

from __future__ import annotations

import numpy as np
from scipy import fft

from tyrecontact.errors import InputError
from tyrecontact.road import spectrum
from tyrecontact.road.heights import Patch
from tyrecontact.road.spectrum import Isotropic

#: pixels of the surface that is made; a quarter of it is used
MAX_HEIGHTS = 16_000_000
_ROUNDS = 8


def from_profile(heights: np.ndarray, pitch: float, size: float, seed: int) -> Patch:
    """A square isotropic road from a profile, at the profile's pitch.

    Wavelengths beyond twice the side are left out: neither the patch nor the surface of twice its
    side from which it is cut can hold them.

    Parameters
    ----------
    heights : z [m], shape (n,), none missing. pitch : [m].
    size : side of the patch [m].
    seed : of the random phases.

    Raises
    ------
    InputError : a profile shorter than twice the side, or a patch of too many heights.
    """
    period = 2 * size
    if not len(heights) * pitch >= period * (1 - 1e-9):
        raise InputError(
            f"profile must be at least twice as long as the patch, {period * 1e3:.4g} mm, "
            f"got {len(heights) * pitch * 1e3:.4g} mm"
        )
    count = 2 * int(np.ceil(size / pitch * (1 - 1e-9)))
    if not count**2 <= MAX_HEIGHTS:
        raise InputError(
            f"a made road must have at most {MAX_HEIGHTS / 4:g} heights, got {count**2 / 4:g}"
        )
    found = spectrum.isotropic(*spectrum.of_profile(heights, pitch, period))
    values = high_passed(heights, pitch, period)
    values *= np.sqrt(variance_on_grid(found, count, pitch)) / values.std()
    made = surface(found, values, count, pitch, np.random.default_rng(seed))
    half = count // 2
    return Patch(made[:half, :half].copy(), pitch)


def variance_on_grid(wanted: Isotropic, count: int, pitch: float) -> float:
    """Mean square height [m^2] of a periodic surface of count x count pixels with a spectrum."""
    axis = np.fft.fftfreq(count, pitch)
    return float(wanted.at(np.hypot(axis[:, None], axis)).sum() / (count * pitch) ** 2)


def high_passed(heights: np.ndarray, pitch: float, longest: float) -> np.ndarray:
    """A profile [m], shape (n,), less its line and its wavelengths beyond the longest [m]."""
    line = np.polynomial.Polynomial.fit(np.arange(len(heights)), heights, 1)
    flat = heights - line(np.arange(len(heights)))
    # mirrored at its end, so that it is periodic without a step
    both = fft.rfft(np.concatenate([flat, flat[::-1]]))
    both[np.fft.rfftfreq(2 * len(flat), pitch) < (1 - 1e-9) / longest] = 0
    return np.asarray(fft.irfft(both, n=2 * len(flat))[: len(flat)])


def surface(
    wanted: Isotropic, values: np.ndarray, count: int, pitch: float, rng: np.random.Generator
) -> np.ndarray:
    """A periodic surface with a spectrum and a distribution of heights.

    Parameters
    ----------
    wanted : its spectrum. values : heights of the distribution [m], shape (any,).
    count : pixels a side. pitch : [m].

    Returns
    -------
    z [m], shape (count, count): the distribution is exact, the spectrum nearly.
    """
    frequency = np.hypot(np.fft.fftfreq(count, pitch)[:, None], np.fft.rfftfreq(count, pitch))
    # |Z|^2 = S2 N^2 / pitch^2, with N^2 the number of pixels
    amplitude = np.sqrt(wanted.at(frequency)) * count / pitch
    noise = fft.rfft2(rng.standard_normal((count, count))) / count
    amplitude = amplitude * np.abs(noise)  # waves of a random surface differ in size too
    levels = np.arange(count**2) + 0.5
    ranked = np.interp(
        levels / count**2, (np.arange(values.size) + 0.5) / values.size, np.sort(values.ravel())
    )
    waves = noise
    for _ in range(_ROUNDS):
        size = np.abs(waves)
        phases = np.divide(waves, size, out=np.ones_like(waves), where=size > 0)
        heights = fft.irfft2(amplitude * phases, s=(count, count))
        order = np.argsort(heights, axis=None)
        heights = np.empty(count**2)
        heights[order] = ranked
        heights = heights.reshape(count, count)
        waves = fft.rfft2(heights)
    return heights
