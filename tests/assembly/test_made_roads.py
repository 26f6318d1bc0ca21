"""From settings to made roads: that each setting arrives where it belongs."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact import assembly
from tyrecontact.parts.road import Road
from tyrecontact.road import heights

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


def test_a_made_road_has_the_size_and_the_pitch_asked_for() -> None:
    patch = assembly.road_patch(Road(**ROAD))
    assert patch.heights.shape == (120, 120)
    assert patch.pitch == pytest.approx(5e-5, rel=1e-12)  # a division
    assert heights.element_tops(patch, 6).shape == (6, 6)


def test_a_made_road_depends_on_its_seed_alone() -> None:
    first, again = (assembly.road_patch(Road(**ROAD)) for _ in range(2))
    np.testing.assert_array_equal(first.heights, again.heights)
    other = assembly.road_patch(Road(**ROAD, seed=2))
    assert np.abs(other.heights - first.heights).max() > 1e-6


@pytest.mark.parametrize(
    "change",
    [
        {"stone_size": 2e-3},
        {"valley_rms": 100e-6},
        {"valley_offset": 0.0},
        {"plateau_rms": 10e-6},
        {"plateau_wavelength": 4e-3},
        {"polish": 6.0},
        {"hurst": 0.6},
    ],
    ids=lambda change: next(iter(change)),
)
def test_every_setting_of_a_made_road_changes_it(change: dict[str, float]) -> None:
    first, other = assembly.road_patch(Road(**ROAD)), assembly.road_patch(Road(**ROAD, **change))
    assert np.abs(other.heights - first.heights).max() > 1e-6


def test_the_default_road_is_worn_with_tops_as_smooth_as_the_thesis_needs() -> None:
    patch = assembly.road_patch(Road())
    assert patch.skewness < 0
    assert 12e-6 < heights.element_tops(patch, 20).std() < 24e-6  # 15-20 um, and the seed's luck


def test_a_shared_road_cannot_be_written_to() -> None:
    patch = assembly.road_patch(Road(**ROAD))
    with pytest.raises(ValueError, match="read-only"):
        patch.heights[0, 0] = 0.0


def test_kinds_of_made_roads_differ_as_they_should() -> None:
    made = {
        kind: assembly.road_patch(Road(**ROAD, texture=kind, valley_rms=30e-6, clip_height=10e-6))
        for kind in ("self-affine", "worn", "clipped")
    }
    np.testing.assert_array_equal(
        made["clipped"].heights, np.minimum(made["self-affine"].heights, 10e-6)
    )
    assert np.mean(made["clipped"].heights == 10e-6) > 0.1  # flat tops
    assert made["clipped"].skewness < made["self-affine"].skewness
    assert not np.array_equal(made["worn"].heights, made["self-affine"].heights)
