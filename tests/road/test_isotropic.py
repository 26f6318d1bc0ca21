"""From a profile to an isotropic road: its spectrum and its heights must come out."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import isotropic, spectrum, textures

PITCH, SIZE = 1e-4, 10e-3


@pytest.fixture(scope="module")
def profile() -> np.ndarray:
    """A skewed line of 0.4 m: rows of a worn road, one after the other, edges matched."""
    road = textures.worn(
        40e-3, PITCH, valley_rms=100e-6, plateau_rms=15e-6, offset=30e-6, stone_size=3e-3,
        plateau_wavelength=3e-3, seed=3,
    )  # fmt: skip
    rows = road.heights[::40]
    steps = np.cumsum([0.0, *(after[0] - before[-1] for before, after in pairwise(rows))])
    joined = (rows - steps[:, None]).ravel()
    return isotropic.high_passed(joined, PITCH, 2 * SIZE)


def test_heights_and_spectrum_come_out(profile: np.ndarray) -> None:
    frequency, wanted = spectrum.of_profile(profile, PITCH, 2 * SIZE)
    found = spectrum.isotropic(frequency, wanted)
    count = 200
    profile = profile * np.sqrt(isotropic.variance_on_grid(found, count, PITCH)) / profile.std()
    surfaces = [
        isotropic.surface(found, profile, count, PITCH, np.random.default_rng(seed))
        for seed in range(8)
    ]
    # the distribution is exact: each quantile
    share = [0.01, 0.1, 0.5, 0.9, 0.99]
    for surface in surfaces:
        np.testing.assert_allclose(
            np.quantile(surface, share), np.quantile(profile, share), atol=0.01 * profile.std()
        )
    # the spectrum of lines along x and along y, by octaves: scatter of few waves and rank order
    made = np.fft.rfftfreq(count, PITCH)
    for axis in (0, 1):
        power = np.mean(
            [(np.abs(np.fft.rfft(s, axis=axis)) ** 2).mean(axis=1 - axis) for s in surfaces], axis=0
        ) * PITCH / count  # fmt: skip
        for low, high in pairwise([150, 300, 600, 1200, 2400, 4800]):
            ours = power[(made >= low) & (made < high)].mean()
            theirs = wanted[(frequency >= low) & (frequency < high)].mean()
            assert ours == pytest.approx(theirs, rel=0.25)


def test_a_road_is_skewed_like_its_profile_and_repeats_by_its_seed(profile: np.ndarray) -> None:
    first, again, other = (isotropic.from_profile(profile, PITCH, SIZE, seed) for seed in (1, 1, 2))
    assert first.heights.shape == (100, 100)
    np.testing.assert_array_equal(first.heights, again.heights)
    assert np.abs(first.heights - other.heights).max() > 1e-5
    skewness = ((profile / profile.std()) ** 3).mean()
    assert skewness < -0.5  # or the test shows nothing
    mean = np.mean([
        isotropic.from_profile(profile, PITCH, SIZE, seed).skewness for seed in range(6)
    ])  # fmt: skip
    assert mean == pytest.approx(skewness, rel=0.4)  # crops of some ten stones


def test_long_waves_are_taken_off() -> None:
    place = np.arange(4000) * PITCH
    long, short = np.sin(2 * np.pi * place / 0.1), np.sin(2 * np.pi * place / 2e-3)
    found = isotropic.high_passed(0.3 * place + long + 0.1 * short, PITCH, 2 * SIZE)
    # mirrored ends leave a little of the long waves there
    assert found[500:-500].std() == pytest.approx(0.1 / np.sqrt(2), rel=0.03)


def test_a_profile_that_is_too_short_or_a_patch_too_large_is_refused(profile: np.ndarray) -> None:
    with pytest.raises(InputError, match="at least twice as long as the patch, 20 mm, got 15 mm"):
        isotropic.from_profile(profile[:150], PITCH, SIZE, 1)
    with pytest.raises(InputError, match=r"at most 4e\+06 heights"):
        isotropic.from_profile(np.resize(profile, 100_000), PITCH, 0.3, 1)
