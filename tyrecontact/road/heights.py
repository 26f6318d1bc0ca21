"""A patch of road: its heights, its cut into elements, and figures of its texture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import RegularGridInterpolator

from tyrecontact.errors import InputError

#: fewest heights along a side of an element: its roughness spring is read off them
MIN_PIXELS = 4


@dataclass(frozen=True)
class Patch:
    """Heights of a road on a square grid.

    Attributes
    ----------
    heights : z [m], shape (ny, nx), positive up (towards the tread), finite.
    pitch : distance of neighbouring heights [m]; a pixel covers pitch x pitch.

    Raises
    ------
    InputError : heights that are not a 2-D array of finite numbers, or a pitch not positive.
    """

    heights: np.ndarray
    pitch: float

    def __post_init__(self) -> None:
        if self.heights.ndim != 2 or min(self.heights.shape) < 2:
            shape = self.heights.shape
            raise InputError(f"heights must be a 2-D array of at least 2 x 2, got shape {shape}")
        missing = int(np.count_nonzero(~np.isfinite(self.heights)))
        if missing:
            share = missing / self.heights.size
            raise InputError(f"heights must be finite, got {missing} that are not ({share:.1%})")
        if not 0 < self.pitch < np.inf:
            raise InputError(f"pitch must be positive and finite, got {self.pitch} m")

    @property
    def extent(self) -> tuple[float, float]:
        """Size (y, x) [m]: number of pixels times pitch."""
        return self.heights.shape[0] * self.pitch, self.heights.shape[1] * self.pitch

    @property
    def rms(self) -> float:
        """Root mean square height about the mean [m]."""
        return float(self.heights.std())

    @property
    def rms_slope(self) -> float:
        """Root mean square of the gradient's magnitude [-]."""
        dy, dx = (np.diff(self.heights, axis=axis) / self.pitch for axis in (0, 1))
        return float(np.sqrt((dy**2).mean() + (dx**2).mean()))

    @property
    def skewness(self) -> float:
        """Third standardised moment of the heights [-]; negative for a worn road; 0 if flat."""
        if self.rms == 0:
            return 0.0
        return float((((self.heights - self.heights.mean()) / self.rms) ** 3).mean())


def centred(patch: Patch, elements: int, size: float) -> Patch:
    """The middle of a patch, resampled so that each element gets a whole number of pixels.

    Parameters
    ----------
    elements : number of elements a side.
    size : side of the wanted square [m].

    Returns
    -------
    A patch of that size whose pitch is the nearest whole fraction of the element's side that is
    not coarser than the given one. Heights between the given ones are bilinear.

    Raises
    ------
    InputError : the patch is smaller than `size`, or has fewer than 4 pixels an element side.
    """
    height, width = patch.extent
    if min(height, width) < size * (1 - 1e-9):
        raise InputError(
            f"road must cover {size * 1e3:.4g} x {size * 1e3:.4g} mm, "
            f"got {width * 1e3:.4g} x {height * 1e3:.4g} mm"
        )
    side = size / elements
    pixels = int(np.ceil(side / patch.pitch * (1 - 1e-9)))
    if side < MIN_PIXELS * patch.pitch * (1 - 1e-9):
        raise InputError(
            f"pitch must give at least {MIN_PIXELS} heights a side of an element "
            f"({side * 1e3 / MIN_PIXELS:.4g} mm), got {patch.pitch * 1e3:.4g} mm"
        )
    pitch = side / pixels
    count = pixels * elements
    if np.isclose(pitch, patch.pitch, rtol=1e-9, atol=0):
        row, column = ((n - count) // 2 for n in patch.heights.shape)
        return Patch(patch.heights[row : row + count, column : column + count], pitch)
    return _resampled(patch, count, pitch)


def _resampled(patch: Patch, count: int, pitch: float) -> Patch:
    """The middle count x count heights of another pitch [m], bilinear between the given ones."""
    axes = [(np.arange(n) + 0.5 - n / 2) * patch.pitch for n in patch.heights.shape]
    wanted = (np.arange(count) + 0.5 - count / 2) * pitch
    # the outermost new pixels may lie up to half an old pixel outside the old centres
    inside = [np.clip(wanted, axis[0], axis[-1]) for axis in axes]
    heights = RegularGridInterpolator(axes, patch.heights)(np.meshgrid(*inside, indexing="ij"))
    return Patch(heights, pitch)


def element_heights(patch: Patch, elements: int) -> np.ndarray:
    """The heights of each element [m], shape (elements, elements, pixels of an element)."""
    pixels, rest = divmod(patch.heights.shape[0], elements)
    if rest or patch.heights.shape[0] != patch.heights.shape[1]:
        shape = patch.heights.shape
        raise InputError(f"patch must be square and divide into {elements} elements, got {shape}")
    blocks = patch.heights.reshape(elements, pixels, elements, pixels).swapaxes(1, 2)
    return blocks.reshape(elements, elements, pixels**2)


def element_tops(patch: Patch, elements: int) -> np.ndarray:
    """Height of the outermost point of each element [m], shape (elements, elements)."""
    return element_heights(patch, elements).max(axis=-1)
