"""What is done to a scan before it is used: levelled, cut, filled, trimmed, and all of it told."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import prepare
from tyrecontact.road.scan import Scan

PITCH = 1e-4


def scan(heights: np.ndarray) -> Scan:
    return Scan(heights, PITCH, name="road.npy")


def rough(*shape: int) -> np.ndarray:
    return np.random.default_rng(1).standard_normal(shape) * 1e-5


def tilt(ny: int, nx: int) -> np.ndarray:
    y, x = np.indices((ny, nx)) * PITCH
    return 2e-3 + 0.02 * x - 0.05 * y


@pytest.mark.parametrize("missing", [False, True])
def test_a_plane_is_taken_off_and_told(missing: bool) -> None:
    heights = tilt(30, 40)
    if missing:
        heights[3:9, 20:] = np.nan
    found = prepare.levelled(scan(heights))
    assert np.nanmax(np.abs(found.heights)) < 1e-15  # rounding of 4 mm
    assert np.array_equal(np.isnan(found.heights), np.isnan(heights))
    assert found.done == ("levelled: 20 mm/m along x and -50 mm/m along y taken off",)


def test_levelling_leaves_a_surface_no_tilt_and_its_roughness() -> None:
    heights = rough(50, 60)
    found = prepare.levelled(scan(heights + tilt(50, 60))).heights
    again = prepare.levelled(scan(found)).heights
    np.testing.assert_allclose(again, found, atol=1e-16)  # a projection
    np.testing.assert_allclose(
        found, prepare.levelled(scan(heights)).heights, atol=1e-15
    )  # whatever the tilt was


def test_a_profile_is_levelled_by_a_line() -> None:
    heights = rough(200)
    found = prepare.levelled(scan(heights + 0.01 * PITCH * np.arange(200)))
    slope = np.polyfit(np.arange(200), found.heights, 1)[0]
    assert abs(slope) < 1e-17
    assert found.done[0].endswith("along x taken off")


@pytest.mark.parametrize("shape", [(30, 40), (500,)])
def test_filling_meets_a_plane_exactly(shape: tuple[int, ...]) -> None:
    """A linear function solves Laplace's equation; holes away from the edge fill to rounding."""
    place = sum((n + 1) * axis for n, axis in enumerate(np.indices(shape).astype(float)))
    holed = place * 1e-5
    inner = np.zeros(shape, bool)
    inner[tuple(slice(5, 12) for _ in shape)] = True
    found = prepare.filled(scan(np.where(inner, np.nan, holed)), 0.5)
    np.testing.assert_allclose(found.heights, holed, atol=1e-16 * 100)


def test_filling_makes_no_new_top_and_keeps_what_is_there() -> None:
    heights = rough(60, 60)
    missing = np.random.default_rng(2).random(heights.shape) < 0.3
    missing[:4, :4] = True  # a corner too
    found = prepare.filled(scan(np.where(missing, np.nan, heights)), 0.5).heights
    np.testing.assert_array_equal(found[~missing], heights[~missing])
    assert heights[~missing].min() <= found[missing].min()
    assert found[missing].max() <= heights[~missing].max()


def test_filling_is_told_and_limited() -> None:
    heights = rough(20, 20)
    heights[2, 2:12] = np.nan
    found = prepare.filled(scan(heights), 0.025)
    assert found.done == ("2.50% of the heights (10) filled from around them",)
    assert prepare.filled(found, 0.0) is found  # nothing left to do
    with pytest.raises(InputError, match=r"at most 2\.4% of the part .* got 2\.5% of road\.npy"):
        prepare.filled(scan(heights), 0.024)


@pytest.mark.parametrize(("dx", "dy"), [(0, 0), (7, -3), (-10, 10)])
def test_a_patch_off_the_middle_is_cut_where_it_is_asked_for(dx: int, dy: int) -> None:
    heights = np.add.outer(1000.0 * np.arange(61), np.arange(81))
    part = prepare.cut(scan(heights), 30 * PITCH, dx * PITCH, dy * PITCH)
    ny, nx = part.heights.shape
    middle = part.heights[ny // 2, nx // 2]
    assert middle == 1000 * (30 + dy) + 40 + dx  # 61 and 81 heights: the middle is a height
    assert 30 <= min(ny, nx) <= max(ny, nx) <= 36


def test_a_patch_that_leaves_the_scan_is_refused_with_where_it_was() -> None:
    road = scan(rough(61, 81))
    with pytest.raises(InputError, match=r"road must cover 6\.2 x 6\.2 mm, got 8\.1 x 6\.1 mm"):
        prepare.cut(road, 62 * PITCH, 0.0, 0.0)
    with pytest.raises(InputError, match=r"with its centre 3 mm off the middle"):
        prepare.cut(road, 30 * PITCH, 30 * PITCH, 0.0)
    with pytest.raises(InputError, match="centre_y must be 0 for a profile"):
        prepare.cut(scan(rough(81)), 30 * PITCH, 0.0, 1e-3)


def test_a_profile_loses_its_ends() -> None:
    found = prepare.trimmed(scan(np.arange(100.0)), 10 * PITCH, 20 * PITCH)
    assert (found.heights[0], found.heights[-1]) == (10.0, 79.0)
    assert found.done == ("trimmed by 1 mm at the start and 2 mm at the end",)
    with pytest.raises(InputError, match=r"must leave some of the 0\.01 m"):
        prepare.trimmed(scan(np.arange(100.0)), 60 * PITCH, 40 * PITCH)
    with pytest.raises(InputError, match=r"must leave some of the 0\.01 m"):
        prepare.trimmed(scan(np.arange(100.0)), 0.0, 120 * PITCH)  # more than there is
    with pytest.raises(InputError, match="must be 0 for a map"):
        prepare.trimmed(scan(rough(9, 9)), PITCH, 0.0)


def test_depths_become_heights() -> None:
    found = prepare.turned_over(scan(np.array([1.0, -2.0])))
    assert found.heights.tolist() == [-1.0, 2.0]
    assert "positive down" in found.done[0]
