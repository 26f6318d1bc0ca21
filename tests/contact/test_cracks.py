"""Where cracks get to, against looking at every compression of a fine grid."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tyrecontact.contact.cracks import CrackTable
from tyrecontact.road.springs import Springs, linear

TOUGH = 0.05


def release(springs: Springs, reach: np.ndarray, depth: float) -> np.ndarray:
    """G [J/m2] by the springs' own look-up."""
    slope = springs.punch_stiffness_slope(reach)
    return slope * (depth - reach) ** 2 / (4 * np.pi * springs.radius(reach))


def every(springs: Springs, value: float) -> np.ndarray:
    return np.full(springs.count, value)


@pytest.mark.parametrize("reach", [1e-9, 3e-6, 2e-5, 1.0])
def test_radius_and_release_are_those_of_the_springs(rough_springs: Springs, reach: float) -> None:
    places, table = every(rough_springs, reach), CrackTable(rough_springs)
    radius, found = table.radius_and_release(
        np.arange(rough_springs.count), places, every(rough_springs, -1e-6)
    )
    np.testing.assert_allclose(radius, rough_springs.radius(places), rtol=1e-12)  # rounding
    np.testing.assert_allclose(found, release(rough_springs, places, -1e-6), rtol=1e-12)


def test_without_area_nothing_is_released(rough_springs: Springs) -> None:
    element, zero = np.arange(64), np.zeros(64)
    assert not np.any(CrackTable(rough_springs).radius_and_release(element, zero, zero - 1))


@pytest.mark.parametrize("share", [1.0, 1 - 1e-9, 0.9, 0.3, 1e-3])
def test_a_crack_that_is_driven_all_the_way_stops_at_its_radius(
    rough_springs: Springs, share: float
) -> None:
    """And at the smallest compression of that radius."""
    start = rough_springs.onset(every(rough_springs, 2e-5))
    radius, tough = rough_springs.radius(start), every(rough_springs, 1e-9)
    reach = CrackTable(rough_springs).receded(
        np.arange(64), radius, share * radius, start, every(rough_springs, -1e-5), tough
    )
    np.testing.assert_allclose(rough_springs.radius(reach), share * radius, rtol=1e-12)
    # less than its smallest compression is a smaller radius
    assert np.all(rough_springs.radius(reach * (1 - 1e-6)) < share * radius)
    assert np.all(reach <= start)


def test_a_contact_whose_radius_shrinks_to_nothing_is_gone(rough_springs: Springs) -> None:
    start, deep = every(rough_springs, 2e-5), every(rough_springs, -1e-3)
    radius, tough = rough_springs.radius(start), every(rough_springs, 1e-9)
    for left in (0.0, -1.0, -np.inf):
        gone = CrackTable(rough_springs).receded(
            np.arange(64), radius, every(rough_springs, left), start, deep, tough
        )
        np.testing.assert_array_equal(gone, 0)


@pytest.mark.parametrize("depth", [1e-5, 1e-6, 0.0, -3e-7, -1e-6])
def test_a_fast_crack_rests_at_the_first_g_below_w(rough_springs: Springs, depth: float) -> None:
    """The first on the way: nowhere above it is G less, and there G = w, or it is gone."""
    start = every(rough_springs, 2e-5)
    element = np.flatnonzero(release(rough_springs, start, depth) > TOUGH)
    assert element.size > 20
    springs = rough_springs.take(element)
    start, nothing = every(springs, 2e-5), every(springs, -np.inf)
    reach = CrackTable(rough_springs).receded(
        element, springs.radius(start), nothing, start, every(springs, depth), every(springs, TOUGH)
    )
    rests = reach > 0
    assert rests.any() or depth < -5e-7
    left = release(springs, np.where(rests, reach, start), depth)
    # a root of a cubic is exact to rounding of G, whose terms cancel near d
    np.testing.assert_allclose(left[rests], TOUGH, rtol=1e-9)
    for share in np.linspace(1e-4, 1, 2000):
        assert np.all(release(springs, reach + share * (start - reach), depth) > TOUGH)


def test_a_rest_between_two_nodes_is_found() -> None:
    """Where a radius grows fast in a cell G has its least inside, and is above w at both ends."""
    springs = linear(np.array([1e5]), 1e-6, 1e-4)
    table = springs.contact_table.copy()
    table[0, :, 0], table[0, :, 2] = (1e-5, 4e-4), 1e9
    springs = replace(springs, contact_table=table)
    depth = -0.2e-6
    places = np.linspace(0, 1e-6, 100_001)
    driven = 1e9 * (places - depth) ** 2 / (4 * np.pi * np.interp(places, [0, 1e-6], [1e-5, 4e-4]))
    least = int(driven.argmin())
    assert 0 < least < 100_000
    assert driven[least] < 0.9 * driven[0]
    tough = (driven[least] + driven[0]) / 2
    reach = CrackTable(springs).receded(
        np.zeros(1, int), np.array([4e-4]), np.array([-1.0]), np.array([1e-6]),
        np.array([depth]), np.array([tough]),
    )  # fmt: skip
    expected = places[np.flatnonzero(driven <= tough)[-1]]
    assert reach[0] == pytest.approx(expected, abs=2e-11)  # twice the grid
