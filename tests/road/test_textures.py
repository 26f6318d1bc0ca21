"""Roads that are made: repeatable, of the wanted roughness, spectrum and skewness."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tyrecontact import presets
from tyrecontact.errors import InputError
from tyrecontact.road.heights import Patch
from tyrecontact.road.profile_depth import mean_profile_depth
from tyrecontact.road.textures import clipped, self_affine, worn

SIZE, PITCH, RMS = 10e-3, 25e-6, 30e-6
WORN = {
    "valley_rms": 40e-6, "plateau_rms": 8e-6, "offset": 20e-6,
    "stone_size": 2e-3, "plateau_wavelength": 0.5e-3,
}  # fmt: skip


def spectrum_slope(roads: list[Patch], longest: float, shortest: float) -> float:
    """Slope of log C over log q between two wavelengths, C averaged over rings and roads."""
    n, pitch = roads[0].heights.shape[0], roads[0].pitch
    window = np.hanning(n)[:, None] * np.hanning(n)  # a crop is not periodic
    power = sum(np.abs(np.fft.fft2(road.heights * window)) ** 2 for road in roads)
    frequency = np.fft.fftfreq(n, pitch)
    q = np.hypot(frequency[:, None], frequency)
    edges = np.geomspace(1 / longest, 1 / shortest, 13)
    middles = np.sqrt(edges[1:] * edges[:-1])
    rings = [power[(q >= low) & (q < high)].mean() for low, high in pairwise(edges)]
    return float(np.polyfit(np.log(middles), np.log(rings), 1)[0])


@pytest.fixture(scope="module")
def roads() -> list[Patch]:
    return [
        self_affine(SIZE, PITCH, RMS, roll_off_wavelength=0.5e-3, hurst=0.6, seed=seed)
        for seed in range(6)
    ]


def test_the_same_seed_makes_the_same_road() -> None:
    first, again = (worn(SIZE, PITCH, **WORN, seed=5) for _ in range(2))
    np.testing.assert_array_equal(first.heights, again.heights)


def test_another_seed_makes_another_road(roads: list[Patch]) -> None:
    correlation = np.corrcoef([road.heights.ravel() for road in roads])
    # some 20 x 20 independent stones: correlations by chance are of the order of 1/20
    assert np.abs(correlation - np.eye(len(roads))).max() < 0.25


def test_size_and_pitch_are_those_asked_for(roads: list[Patch]) -> None:
    assert roads[0].heights.shape == (400, 400)
    assert roads[0].pitch == PITCH


def test_rms_is_that_of_the_road_before_it_is_cropped(roads: list[Patch]) -> None:
    crops = np.sqrt(np.mean([(road.heights**2).mean() for road in roads]))
    # the crops hold 6 x 400 independent stones: their mean square scatters by some 3 %
    assert crops == pytest.approx(RMS, rel=0.06)
    assert roads[0].rms != pytest.approx(RMS, rel=1e-6)  # a crop is not scaled again


def test_the_spectrum_falls_as_self_affine_roads_do(roads: list[Patch]) -> None:
    slope = spectrum_slope(roads, 0.4e-3, 0.07e-3)
    assert slope == pytest.approx(-2 * (1 + 0.6), abs=0.1)  # scatter of 12 rings: 0.03


def test_the_spectrum_is_flat_below_the_roll_off(roads: list[Patch]) -> None:
    slope = spectrum_slope(roads, 4e-3, 0.6e-3)
    assert slope == pytest.approx(0, abs=0.3)  # the inner rings hold few waves


def test_nothing_is_shorter_than_the_cut_off() -> None:
    road = self_affine(
        SIZE, PITCH, RMS, roll_off_wavelength=2e-3, cut_off_wavelength=0.2e-3, seed=1
    )
    window = np.hanning(400)[:, None] * np.hanning(400)
    power = np.abs(np.fft.fft2(road.heights * window)) ** 2
    q = np.hypot(np.fft.fftfreq(400, PITCH)[:, None], np.fft.fftfreq(400, PITCH))
    # what the window leaks beyond the cut-off is orders below the road's own last waves
    assert power[q > 1.3 / 0.2e-3].mean() < 1e-4 * power[(q > 0.8 / 0.2e-3) & (q < 5e3)].mean()


def test_a_worn_road_is_the_lower_of_stones_and_plateau() -> None:
    rng = np.random.default_rng(7)
    stones = self_affine(SIZE, PITCH, 40e-6, roll_off_wavelength=2e-3, seed=rng)
    plateau = self_affine(SIZE, PITCH, 8e-6, roll_off_wavelength=0.5e-3, seed=rng)
    expected = np.minimum(stones.heights + 20e-6, plateau.heights)
    np.testing.assert_array_equal(worn(SIZE, PITCH, **WORN, seed=7).heights, expected)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_worn_road_has_more_pits_than_peaks(seed: int) -> None:
    assert worn(SIZE, PITCH, **WORN, seed=seed).skewness < -0.5


def test_polish_takes_the_pits_from_the_highest_parts_and_leaves_them_in_the_lowest() -> None:
    even = worn(SIZE, PITCH, **WORN, seed=7).heights
    polished = worn(SIZE, PITCH, **WORN, polish=10.0, seed=7).heights
    rng = np.random.default_rng(7)
    self_affine(SIZE, PITCH, 40e-6, roll_off_wavelength=2e-3, seed=rng)
    plateau = self_affine(SIZE, PITCH, 8e-6, roll_off_wavelength=0.5e-3, seed=rng).heights
    high, low = (plateau > np.quantile(plateau, 0.8), plateau < np.quantile(plateau, 0.2))
    assert polished.max() == plateau.max()  # no part of the plateau is raised or lowered itself
    assert np.mean(even[high] < plateau[high]) > 0.2  # pits to begin with
    assert np.mean(polished[high] < plateau[high]) < 0.02  # 80 um more offset than 40 um of rms
    assert np.mean(polished[low] < plateau[low]) > np.mean(even[low] < plateau[low])


@pytest.mark.parametrize("polish", [-1.0, np.nan, np.inf])
def test_an_impossible_polish_is_refused(polish: float) -> None:
    with pytest.raises(InputError, match="polish must be finite and not negative"):
        worn(SIZE, PITCH, **WORN, polish=polish)


@pytest.mark.parametrize(
    ("setting", "value"),
    [("size", 0.0), ("pitch", -1e-5), ("rms", np.nan), ("hurst", 0.0), ("hurst", 1.5),
     ("roll_off_wavelength", 1e-5), ("cut_off_wavelength", 0.0)],
)  # fmt: skip
def test_impossible_settings_are_refused(setting: str, value: float) -> None:
    settings = {"size": SIZE, "pitch": PITCH, "rms": RMS, "roll_off_wavelength": 1e-3}
    sentence = {"cut_off_wavelength": "cut-off"}.get(setting, setting)
    with pytest.raises(InputError, match=sentence):
        self_affine(**(settings | {setting: value}))


def test_a_clipped_road_is_a_self_affine_one_cut_off() -> None:
    whole = self_affine(SIZE, PITCH, RMS, roll_off_wavelength=2e-3, seed=4)
    found = clipped(SIZE, PITCH, RMS, clip_height=15e-6, stone_size=2e-3, seed=4)
    np.testing.assert_array_equal(found.heights, np.minimum(whole.heights, 15e-6))
    assert found.heights.max() == 15e-6
    with pytest.raises(InputError, match="clip_height must lie above the lowest valley"):
        clipped(SIZE, PITCH, RMS, clip_height=-1e-3, stone_size=2e-3)


@pytest.mark.parametrize(
    ("preset", "depth"),
    [("road-iso-10844", 0.5e-3), ("road-sma-11", 1.0e-3), ("road-dac-16", 0.9e-3)],
)
def test_illustrative_roads_have_the_profile_depth_of_their_captions(
    preset: str, depth: float
) -> None:
    """On a road long enough for ISO 13473-1; the patch itself holds too few stones."""
    road = presets.get(preset).road
    made = worn(
        0.12, 0.2e-3, valley_rms=road.valley_rms, plateau_rms=road.plateau_rms,
        offset=road.valley_offset, stone_size=road.stone_size,
        plateau_wavelength=road.plateau_wavelength, hurst=road.hurst, seed=1,
    )  # fmt: skip
    found = mean_profile_depth(made.heights, made.pitch)
    assert found is not None
    assert found.standard
    assert found.depth == pytest.approx(depth, rel=0.15)
