"""A patch of road: what is refused, how it is cut, and its figures."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road.heights import Patch, centred, element_heights, element_tops

SLOPE = 0.02


def plane(shape: tuple[int, int], pitch: float) -> Patch:
    """z = SLOPE (x + 2 y), measured from the middle of the patch."""
    y, x = ((np.arange(n) + 0.5 - n / 2) * pitch for n in shape)
    return Patch(SLOPE * (x[None, :] + 2 * y[:, None]), pitch)


def sinusoid(amplitude: float, waves: int, pixels: int, pitch: float) -> Patch:
    phase = 2 * np.pi * waves * np.arange(pixels) / pixels
    return Patch(np.tile(amplitude * np.sin(phase), (pixels, 1)), pitch)


@pytest.mark.parametrize("hole", [np.nan, np.inf])
def test_missing_heights_are_refused_and_counted(hole: float) -> None:
    heights = np.zeros((10, 10))
    heights[2, 3] = heights[4, 5] = hole
    with pytest.raises(InputError, match=r"finite, got 2 that are not \(2\.0%\)"):
        Patch(heights, 1e-5)


@pytest.mark.parametrize("shape", [(100,), (1, 100), (4, 4, 4)])
def test_heights_that_are_no_map_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(InputError, match="2-D array"):
        Patch(np.zeros(shape), 1e-5)


@pytest.mark.parametrize("pitch", [0.0, -1e-5, np.nan, np.inf])
def test_an_impossible_pitch_is_refused(pitch: float) -> None:
    with pytest.raises(InputError, match="pitch must be positive"):
        Patch(np.zeros((4, 4)), pitch)


def test_figures_of_a_sinusoid() -> None:
    amplitude, waves, pixels, pitch = 3e-5, 4, 400, 2e-5
    road = sinusoid(amplitude, waves, pixels, pitch)
    wavenumber = 2 * np.pi * waves / (pixels * pitch)
    assert road.extent == pytest.approx((8e-3, 8e-3))
    assert road.rms == pytest.approx(amplitude / np.sqrt(2))
    # 100 pixels a wave: a difference quotient flattens the slope by (q pitch)^2 / 24 = 2e-4
    assert road.rms_slope == pytest.approx(amplitude * wavenumber / np.sqrt(2), rel=3e-3)
    assert road.skewness == pytest.approx(0, abs=1e-12)  # symmetric up to rounding


def test_slope_of_a_plane_is_its_gradient() -> None:
    assert plane((30, 40), 1e-5).rms_slope == pytest.approx(SLOPE * np.sqrt(5))


def test_skewness_tells_pits_from_peaks_and_forgives_a_flat_road() -> None:
    heights = np.zeros((10, 10))
    heights[0, 0] = -1e-5
    share = 0.01  # a Bernoulli variable: (1 - 2p) / sqrt(p (1 - p)), downwards
    expected = -(1 - 2 * share) / np.sqrt(share * (1 - share))
    assert Patch(heights, 1e-5).skewness == pytest.approx(expected)
    assert Patch(-heights, 1e-5).skewness == pytest.approx(-expected)
    assert Patch(np.full((4, 4), 1e-3), 1e-5).skewness == 0


def test_a_fitting_pitch_is_cropped_and_not_resampled() -> None:
    road = Patch(np.arange(60.0 * 70).reshape(60, 70), 1e-4)
    middle = centred(road, elements=4, size=4e-3)
    assert middle.pitch == pytest.approx(1e-4)
    np.testing.assert_array_equal(middle.heights, road.heights[10:50, 15:55])


def test_a_plane_stays_a_plane_when_resampled() -> None:
    middle = centred(plane((61, 73), 0.9e-4), elements=4, size=4e-3)
    assert middle.extent == pytest.approx((4e-3, 4e-3))
    assert middle.pitch <= 0.9e-4
    expected = plane(middle.heights.shape, middle.pitch).heights
    np.testing.assert_allclose(middle.heights, expected, atol=1e-15)  # rounding of 1e-4 m


def test_a_road_of_just_the_size_is_enough() -> None:
    middle = centred(plane((45, 45), 4e-3 / 45), elements=4, size=4e-3)
    expected = plane(middle.heights.shape, middle.pitch).heights
    # only the outermost pixels reach beyond the last given centres, by less than half a pixel
    np.testing.assert_allclose(middle.heights[1:-1, 1:-1], expected[1:-1, 1:-1], atol=1e-15)
    np.testing.assert_allclose(middle.heights, expected, atol=1.5 * SLOPE * 4e-3 / 45)


def test_a_road_that_is_too_small_is_refused() -> None:
    with pytest.raises(InputError, match=r"road must cover 8 x 8 mm, got 7\.3 x 9 mm"):
        centred(Patch(np.zeros((90, 73)), 1e-4), elements=8, size=8e-3)


def test_a_pitch_that_is_too_coarse_is_refused() -> None:
    with pytest.raises(InputError, match=r"got 0\.5 mm"):
        centred(Patch(np.zeros((20, 20)), 0.5e-3), elements=8, size=8e-3)


def test_elements_of_a_map_made_by_hand() -> None:
    heights = np.array([
        [0, 1, 9, 2],
        [3, 2, 4, 5],
        [-1, -2, 0, 0],
        [-4, -3, 0, 7],
    ], float)  # fmt: skip
    road = Patch(heights, 1e-3)
    np.testing.assert_array_equal(element_tops(road, 2), [[3, 9], [-1, 7]])
    assert element_heights(road, 2).shape == (2, 2, 4)
    assert sorted(element_heights(road, 2)[0, 1]) == [2, 4, 5, 9]


@pytest.mark.parametrize("shape", [(8, 10), (9, 9)])
def test_a_map_that_does_not_divide_is_refused(shape: tuple[int, int]) -> None:
    with pytest.raises(InputError, match="divide into 4 elements"):
        element_heights(Patch(np.zeros(shape), 1e-3), 4)
