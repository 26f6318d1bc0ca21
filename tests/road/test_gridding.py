"""Triangles on a grid: exact on planes, the upper of two surfaces, the largest square."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road.gridding import largest_square, rasterised

MOST = 1_000_000


def sheet(nodes: np.ndarray) -> np.ndarray:
    """Triangles of a net of nodes, shape (ny, nx, 3) to (n, 3, 3)."""
    a, b, c, d = nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]
    return np.concatenate([np.stack(three, axis=2).reshape(-1, 3, 3) for three in
                           ((a, b, c), (a, c, d))])  # fmt: skip


def net(width: float, length: float, count: int, height: float = 0.0) -> np.ndarray:
    x, y = np.meshgrid(np.linspace(0, width, count), np.linspace(0, length, count))
    return np.stack([x, y, height + 0.3 * x - 0.1 * y], axis=-1)


def turned(triangles: np.ndarray, degrees: float) -> np.ndarray:
    c, s = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    return triangles @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]]).T


@pytest.mark.parametrize("count", [2, 5, 40])
def test_a_plane_is_met_exactly_whatever_the_triangles(count: int) -> None:
    heights = rasterised(sheet(net(10.0, 6.0, count)), 0.25, MOST)
    y, x = np.indices(heights.shape) * 0.25
    inside = np.isfinite(heights)
    assert inside.all()
    np.testing.assert_allclose(heights, 0.3 * x - 0.1 * y, atol=1e-12)  # rounding


def test_the_upper_of_two_surfaces_is_taken() -> None:
    low, high = sheet(net(10.0, 10.0, 11)), sheet(net(5.0, 10.0, 11, height=2.0))
    heights = rasterised(np.concatenate([low, high]), 0.5, MOST)
    x = np.arange(heights.shape[1]) * 0.5
    upper = heights[3] - (0.3 * x - 0.1 * 1.5)
    np.testing.assert_allclose(upper, np.where(x <= 5.0, 2.0, 0.0), atol=1e-12)


def test_the_grid_is_as_fine_as_the_triangles_unless_it_is_told() -> None:
    triangles = sheet(net(10.0, 10.0, 41))
    assert largest_square(triangles, None, MOST).step == pytest.approx(0.25)
    assert largest_square(triangles, 0.1, MOST).heights.shape == (101, 101)


def test_an_upright_square_is_used_whole_and_a_turned_one_is_turned_back() -> None:
    triangles = sheet(net(10.0, 10.0, 41))
    straight = largest_square(triangles, 0.25, MOST)
    assert straight.heights.shape == (41, 41)
    assert not any("turned" in clause for clause in straight.done)
    found = largest_square(turned(triangles, 63.0), 0.25, MOST)
    assert min(found.heights.shape) >= 38  # upright it would be 10 / (sin + cos of 63) = 7.4 wide
    assert any("turned by" in clause for clause in found.done)
    gradient = np.hypot(*(np.diff(found.heights, axis=axis).mean() / 0.25 for axis in (0, 1)))
    assert gradient == pytest.approx(np.hypot(0.3, 0.1), rel=1e-6)  # a turn keeps the slope


def test_holes_stay_missing_and_do_not_shrink_the_square() -> None:
    triangles = sheet(net(10.0, 10.0, 41))
    middle = triangles[..., :2].mean(axis=1)
    holed = triangles[np.hypot(*(middle - 5.0).T) > 0.8]
    found = largest_square(holed, 0.25, MOST)
    assert found.heights.shape == (41, 41)
    assert 0.005 < np.isnan(found.heights).mean() < 0.03  # pi 0.8^2 of 100, less the rim


def test_an_irregular_outline_gives_the_square_inside_it() -> None:
    triangles = sheet(net(10.0, 10.0, 81))
    middle = triangles[..., :2].mean(axis=1) - 5.0
    disc = triangles[np.hypot(*middle.T) < 4.9]
    found = largest_square(disc, 0.125, MOST)
    # the square in a circle, less a facet at each corner
    assert min(found.heights.shape) * 0.125 == pytest.approx(4.9 * np.sqrt(2), abs=0.4)
    assert np.isfinite(found.heights).all()


def test_coordinates_far_from_the_origin_keep_their_digits() -> None:
    triangles = sheet(net(10.0, 10.0, 41)) + np.array([4.5e6, 5.7e6, 0.0])
    found = largest_square(triangles, 0.25, MOST)
    y, x = np.indices(found.heights.shape) * 0.25
    np.testing.assert_allclose(found.heights, 0.3 * x - 0.1 * y, atol=1e-8)  # 1e-16 of 5e6


def test_what_cannot_be_gridded_is_refused() -> None:
    with pytest.raises(InputError, match="seen from above"):
        largest_square(np.zeros((0, 3, 3)), None, MOST)
    with pytest.raises(InputError, match="seen from above"):
        largest_square(sheet(net(10.0, 10.0, 5))[..., [0, 0, 2]], None, MOST)
    with pytest.raises(InputError, match="at most 100 heights"):
        largest_square(sheet(net(10.0, 10.0, 5)), 0.1, 100)
    with pytest.raises(InputError, match="pitch must be positive"):
        largest_square(sheet(net(10.0, 10.0, 5)), -0.1, MOST)
