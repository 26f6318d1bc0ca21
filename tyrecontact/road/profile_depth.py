r"""Mean profile depth of a road (ISO 13473-1:2019).

A profile is low-passed at a wavelength of 2.4 mm (Butterworth of second order, there and back), cut
into segments of 100 mm, and each freed from its slope. With the highest peak of each half,

    depth of a segment = (peak of first half + peak of second half) / 2 - mean,

and the mean profile depth is the mean over segments. A segment with more than 10 % drop-outs is
left out. Where a road is shorter than 100 mm its own length is the segment: peaks found on less
road are lower, so that figure is for comparing patches of one length.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy  # its parts are loaded where they are first used

#: length of a segment in the standard [m]
SEGMENT = 0.1
_LOW_PASS = 2.4e-3
_MOST_MISSING = 0.1
#: rows of a map that are taken at most
_ROWS = 200


@dataclass(frozen=True)
class ProfileDepth:
    """Mean profile depth [m], over segments of a length [m], and how many there were."""

    depth: float
    segment: float
    segments: int

    @property
    def standard(self) -> bool:
        """Whether segments have the length of ISO 13473-1."""
        return self.segment == SEGMENT


def mean_profile_depth(heights: np.ndarray, pitch: float) -> ProfileDepth | None:
    """Mean profile depth of a profile, or of the rows of a map.

    Parameters
    ----------
    heights : z [m], shape (n,) or (rows, n), positive up, NaN where missing.
    pitch : [m].

    Returns
    -------
    None if no segment can be judged: fewer than 16 heights, or too many missing.
    """
    rows = np.atleast_2d(heights)
    rows = rows[:: max(1, len(rows) // _ROWS)]
    length = rows.shape[1] * pitch
    segment = SEGMENT if length >= SEGMENT * (1 - 1e-6) else length
    pixels = min(round(segment / pitch), rows.shape[1])
    if pixels < 16:
        return None
    depths = [depth for row in rows for depth in _depths(row, pitch, pixels)]
    return ProfileDepth(float(np.mean(depths)), segment, len(depths)) if depths else None


def _depths(row: np.ndarray, pitch: float, pixels: int) -> list[float]:
    """Depths [m] of the segments of one profile that can be judged."""
    valid = np.isfinite(row)
    if np.count_nonzero(valid) < 16:
        return []
    place = np.arange(len(row))
    bridged = np.interp(place, place[valid], row[valid])
    whole = _low_passed(scipy.signal.detrend(bridged), pitch)
    found = []
    for start in range(0, len(row) - pixels + 1, pixels):
        part = slice(start, start + pixels)
        if valid[part].mean() < 1 - _MOST_MISSING:
            continue
        flat = scipy.signal.detrend(whole[part])
        half = pixels // 2
        found.append(float((flat[:half].max() + flat[half:].max()) / 2))
    return found


def _low_passed(row: np.ndarray, pitch: float) -> np.ndarray:
    """Without wavelengths below 2.4 mm; as it is where its pitch hardly resolves them."""
    if pitch > _LOW_PASS / 3 or len(row) < 16:
        return row
    sections = scipy.signal.butter(2, 2 * pitch / _LOW_PASS, output="sos")
    padding = min(len(row) - 1, int(np.ceil(_LOW_PASS / pitch)))
    # mirrored beyond its ends: the usual odd extension would hold on to the very last height
    return np.asarray(scipy.signal.sosfiltfilt(sections, row, padtype="even", padlen=padding))
