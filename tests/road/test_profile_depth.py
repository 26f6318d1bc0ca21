"""Mean profile depth: closed forms, and what cannot be judged."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.road.profile_depth import SEGMENT, mean_profile_depth

PITCH = 1e-4


def wave(length: float, wavelength: float, amplitude: float = 1e-3) -> np.ndarray:
    """A cosine: whole waves of it have no slope."""
    return amplitude * np.cos(2 * np.pi * np.arange(round(length / PITCH)) * PITCH / wavelength)


def test_a_wave_is_as_deep_as_its_amplitude() -> None:
    """Peaks of both halves are the amplitude, the mean is zero, and 10 mm pass the filter.

    The filter, there and back, takes (2.4/10)^4 = 0.3 % off.
    """
    found = mean_profile_depth(wave(1.0, 0.01), PITCH)
    assert found is not None
    assert found.depth == pytest.approx(1e-3, rel=0.01)
    assert (found.segment, found.segments, found.standard) == (SEGMENT, 10, True)


def test_slope_and_short_waves_do_not_count() -> None:
    rough = wave(1.0, 0.01)
    tilted = rough + 0.05 * np.arange(rough.size) * PITCH + wave(1.0, 0.5e-3, 5e-4)
    plain, found = mean_profile_depth(rough, PITCH), mean_profile_depth(tilted, PITCH)
    assert plain is not None
    assert found is not None
    assert found.depth == pytest.approx(plain.depth, rel=0.01)  # (0.5/2.4)^4 of half the amplitude


def test_a_map_gives_the_mean_of_its_rows() -> None:
    rows = np.stack([wave(0.2, 0.01, amplitude) for amplitude in (1e-3, 2e-3, 3e-3)])
    found = mean_profile_depth(rows, PITCH)
    assert found is not None
    assert found.depth == pytest.approx(2e-3, rel=0.01)
    assert found.segments == 6


def test_a_short_road_is_its_own_segment_and_says_so() -> None:
    found = mean_profile_depth(wave(0.02, 0.004), PITCH)
    assert found is not None
    assert found.segment == pytest.approx(0.02)
    assert not found.standard


def test_segments_with_many_drop_outs_are_left_out() -> None:
    heights = wave(0.5, 0.01)
    heights[1000:1200] = np.nan  # 20 % of the second
    heights[::25] = np.nan  # 4 % everywhere: taken
    found = mean_profile_depth(heights, PITCH)
    assert found is not None
    assert found.segments == 4


def test_what_cannot_be_judged_is_none() -> None:
    assert mean_profile_depth(np.zeros(10), PITCH) is None
    assert mean_profile_depth(np.full(500, np.nan), PITCH) is None
