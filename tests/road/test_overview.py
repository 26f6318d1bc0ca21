"""A whole road at a glance keeps its extremes and what is missing."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.road.overview import MAP, PROFILE, overview
from tyrecontact.road.scan import Scan


@pytest.mark.parametrize("shape", [(30, 20), (401, 1203), (2000, 3)])
def test_a_map_becomes_means_of_its_blocks(shape: tuple[int, int]) -> None:
    heights = np.random.default_rng(1).normal(0, 1e-3, shape)
    seen = overview(Scan(heights, 1e-4))
    assert max(seen.heights.shape) <= MAP
    assert seen.extent == (shape[0] * 1e-4, shape[1] * 1e-4)
    every = -(-max(shape) // MAP)
    assert seen.heights[0, 0] == pytest.approx(heights[:every, :every].mean())
    assert seen.heights[-1, -1] == pytest.approx(
        heights[(shape[0] - 1) // every * every :, (shape[1] - 1) // every * every :].mean()
    )
    assert seen.low < seen.high


def test_missing_heights_do_not_pull_a_block_and_a_block_of_them_is_missing() -> None:
    heights = np.ones((800, 800))
    heights[:2, :3] = np.nan
    seen = overview(Scan(heights, 1e-4)).heights
    assert np.isnan(seen[0, 0])
    assert seen[0, 1] == 1.0


def test_a_long_profile_keeps_each_peak_and_each_gap() -> None:
    heights = np.zeros(100_003)
    heights[54_321], heights[100_002] = 7.0, -3.0
    heights[20_000:21_000] = np.nan
    seen = overview(Scan(heights, 1e-5))
    assert seen.is_profile
    assert len(seen.heights) <= 2 * PROFILE
    assert np.nanmax(seen.heights) == 7.0
    assert np.nanmin(seen.heights) == -3.0
    assert np.isnan(seen.heights).any()
    assert seen.place[np.nanargmax(seen.heights)] == pytest.approx(54_321.5e-5)
    assert (np.diff(seen.place) >= 0).all()


def test_a_short_profile_is_as_it_is() -> None:
    seen = overview(Scan(np.arange(5.0), 1e-3))
    assert seen.heights.tolist() == [0, 1, 2, 3, 4]
    assert seen.place == pytest.approx([0.5e-3, 1.5e-3, 2.5e-3, 3.5e-3, 4.5e-3])
