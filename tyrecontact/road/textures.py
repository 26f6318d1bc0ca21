r"""Roads that are made: self-affine, worn and clipped surfaces (physics, section 1).

A self-affine surface has the power spectrum

    C(q) = C0 for q < q0,    C0 (q / q0)^(-2 (1 + H)) for q0 < q < q1,    0 above,

with random phases; q0 = 2 pi / roll-off wavelength, q1 = 2 pi / short cut-off. A worn road is
the lower of two such surfaces: the plateau to which traffic has polished the stones, and the
pits and valleys that are left in it,

    z = min(valleys + offset + polish * plateau, plateau).

What stands higher is polished more: with `polish` the highest parts of the plateau have lost
their pits, the lowest have kept them. The heights are skewed to the negative.
A clipped road is a self-affine one cut at a height: stones with flat tops, all equally high.
"""

from __future__ import annotations

import numpy as np
from scipy import fft

from tyrecontact.errors import InputError
from tyrecontact.road.heights import Patch

#: heights of a road that is made; four times as many are made and cropped
MAX_HEIGHTS = 16_000_000


def self_affine(
    size: float,
    pitch: float,
    rms: float,
    *,
    roll_off_wavelength: float,
    hurst: float = 0.8,
    cut_off_wavelength: float = 20e-6,
    seed: int | np.random.Generator = 1,
) -> Patch:
    """A square random-phase surface with a self-affine spectrum.

    Parameters
    ----------
    size : side [m]; twice as much is generated and cropped, so that the edges are unrelated.
    pitch : [m].
    rms : of the surface before it is cropped [m].
    roll_off_wavelength : where the spectrum turns flat [m]: the size of the stones.
    hurst : exponent H [-], 0 < H <= 1.
    cut_off_wavelength : shortest wavelength [m].
    seed : of the random phases; the same seed gives the same road.
    """
    _require_sensible(size, pitch, rms, hurst, roll_off_wavelength, cut_off_wavelength)
    pixels = int(np.ceil(size / pitch * (1 - 1e-9)))
    if pixels**2 > MAX_HEIGHTS:
        raise InputError(
            f"a made road must have at most {MAX_HEIGHTS:g} heights, got {pixels**2:g}"
        )
    count = 2 * pixels
    rng = np.random.default_rng(seed)
    frequency = np.fft.rfftfreq(count, pitch)
    q = np.hypot(frequency[:, None], frequency)
    amplitude = np.maximum(q * roll_off_wavelength, 1.0) ** -(1 + hurst)
    amplitude[q > 1 / cut_off_wavelength] = 0.0
    amplitude[0, 0] = 0.0
    spectrum = fft.rfft2(rng.standard_normal((count, count)))
    spectrum[: len(q)] *= amplitude
    spectrum[len(q) :] *= amplitude[-2:0:-1]  # of negative frequencies the same
    heights = fft.irfft2(spectrum, s=(count, count))
    return Patch((heights * (rms / heights.std()))[:pixels, :pixels].copy(), pitch)


def _require_sensible(
    size: float,
    pitch: float,
    rms: float,
    hurst: float,
    roll_off_wavelength: float,
    cut_off_wavelength: float,
) -> None:
    for name, value in (("size", size), ("pitch", pitch), ("rms", rms)):
        if not 0 < value < np.inf:
            raise InputError(f"{name} of a road must be positive and finite, got {value} m")
    if not 0 < hurst <= 1:
        raise InputError(f"hurst must lie in (0, 1], got {hurst}")
    if not 0 < cut_off_wavelength < roll_off_wavelength:
        raise InputError(
            f"roll_off_wavelength must exceed the cut-off of {cut_off_wavelength} m, "
            f"got {roll_off_wavelength} m"
        )


def worn(
    size: float,
    pitch: float,
    *,
    valley_rms: float,
    plateau_rms: float,
    offset: float,
    stone_size: float,
    plateau_wavelength: float,
    polish: float = 0.0,
    hurst: float = 0.8,
    seed: int = 1,
) -> Patch:
    """A worn road: the lower of stones with valleys and of the plateau they are polished to.

    Parameters
    ----------
    size, pitch : [m].
    valley_rms, plateau_rms : of the two surfaces [m].
    offset : how high the mean of the valley surface lies above that of the plateau [m]: the
        larger, the more worn.
    stone_size, plateau_wavelength : their roll-off wavelengths [m].
    polish : offset gained per height of the plateau above its mean [-], not negative; 0: wear
        is the same everywhere.
    hurst, seed : as in `self_affine`.
    """
    if not 0 <= polish < np.inf:
        raise InputError(f"polish must be finite and not negative, got {polish}")
    rng = np.random.default_rng(seed)
    valleys = self_affine(
        size, pitch, valley_rms, roll_off_wavelength=stone_size, hurst=hurst, seed=rng
    )
    plateau = self_affine(
        size, pitch, plateau_rms, roll_off_wavelength=plateau_wavelength, hurst=hurst, seed=rng
    )
    unworn = valleys.heights + offset + polish * plateau.heights
    return Patch(np.minimum(unworn, plateau.heights), pitch)


def clipped(
    size: float,
    pitch: float,
    rms: float,
    *,
    clip_height: float,
    stone_size: float,
    hurst: float = 0.8,
    seed: int = 1,
) -> Patch:
    """A self-affine road whose stones are cut off flat.

    Parameters
    ----------
    size, pitch : [m].
    rms : of the surface before it is cut [m].
    clip_height : above the mean of that surface, where it is cut [m]; the lower, the more flat.
    stone_size : roll-off wavelength [m].
    hurst, seed : as in `self_affine`.

    Raises
    ------
    InputError : a cut so low that it leaves a plane.
    """
    whole = self_affine(size, pitch, rms, roll_off_wavelength=stone_size, hurst=hurst, seed=seed)
    lowest = float(whole.heights.min())
    if not clip_height > lowest:
        raise InputError(
            f"clip_height must lie above the lowest valley at {lowest:.4g} m, got {clip_height:g} m"
        )
    return Patch(np.minimum(whole.heights, clip_height), pitch)
