"""What springs know of their punch: radius, frozen stiffness, its slope, and plateaus' onset."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road.punch import stiffness_factor
from tyrecontact.road.springs import Springs, from_heights, linear

PITCH, MODULUS = 5e-5, 10e6
COUNT = 12


@pytest.fixture(scope="module")
def springs() -> Springs:
    """Elements of 20 x 20 heights each, of increasing roughness."""
    rng = np.random.default_rng(4)
    heights = rng.standard_normal((COUNT, 400)) * np.linspace(2e-6, 9e-6, COUNT)[:, None]
    return from_heights(heights, PITCH, MODULUS)


def at(springs: Springs, points: int = 1500) -> np.ndarray:
    """Compressions from zero to beyond the depth, on no node, shape (points, elements)."""
    delta = springs.depth * 1.2 * np.linspace(1e-4, 1, points) ** 2
    return np.repeat(delta[:, None], springs.count, axis=1)


def test_the_frozen_punch_is_as_stiff_as_the_spring(springs: Springs) -> None:
    delta = at(springs)
    np.testing.assert_array_equal(springs.punch_stiffness(delta), springs.stiffness(delta))


def test_the_table_of_the_frozen_punch_agrees_with_the_spring(springs: Springs) -> None:
    """Without the promise that they are one, straight lines between nodes stand for k."""
    delta = at(springs)
    by_table = Springs(springs.depth, springs.energy_table, springs.contact_table)
    error = np.abs(by_table.punch_stiffness(delta) - springs.stiffness(delta))
    # a chord of a monotone curve lies between its ends: no more off than k rises in the cell
    rise = np.abs(np.diff(springs.contact_table[..., 1], axis=1)).max(axis=1)
    assert np.all(error <= rise)
    nodes = np.repeat(springs.nodes[:, None], springs.count, axis=1)
    expected = springs.stiffness(nodes)
    # rounding of coefficients over the width of a cell
    np.testing.assert_allclose(by_table.punch_stiffness(nodes), expected, rtol=1e-9, atol=1e-6)


def test_radius_is_that_of_the_area_above(springs: Springs) -> None:
    """At the nodes, where the table holds it; between them it is between theirs."""
    rng = np.random.default_rng(4)
    heights = rng.standard_normal((COUNT, 400)) * np.linspace(2e-6, 9e-6, COUNT)[:, None]
    below = heights.max(axis=1)[:, None] - heights
    for node in springs.nodes[[1, 20, 100, 200]]:
        area = (below < node).sum(axis=1) * PITCH**2
        found = springs.radius(np.full(COUNT, node))
        np.testing.assert_allclose(found, np.sqrt(area / np.pi), rtol=1e-12)  # rounding
    assert np.all(np.diff(springs.radius(at(springs)), axis=0) >= 0)


def test_slope_of_the_frozen_punch_is_the_derivative_of_its_stiffness() -> None:
    """A stud of one area: k = (8/3) E a kappa(a / h), differentiated in a at the same h."""
    floor = 40e-6
    heights = np.full((1, 400), -floor)
    heights[0, :49] = 0
    spring = from_heights(heights, 1e-5, MODULUS)
    a = 1e-5 * np.sqrt(49 / np.pi)
    for node in spring.nodes[[5, 60, 150, 200]]:

        def stiffness(radius: float, node: float = node) -> float:
            thickness = max(floor - node, 1e-5)
            factor = stiffness_factor(np.array(radius / thickness))
            return float(8 / 3 * MODULUS * radius * factor)

        step = 1e-5 * a
        slope = (stiffness(a + step) - stiffness(a - step)) / (2 * step)
        # central difference: its own error is of the order of the step squared
        assert spring.punch_stiffness_slope(np.array([node]))[0] == pytest.approx(slope, rel=1e-6)


def test_untouched_the_slope_is_that_of_a_half_space(springs: Springs) -> None:
    zero = np.zeros(COUNT)
    assert np.all(springs.radius(zero) == 0)
    slope = springs.punch_stiffness_slope(zero)
    np.testing.assert_allclose(slope, 8 / 3 * MODULUS, rtol=1e-12)  # rounding


def test_beyond_the_depth_the_punch_stays(springs: Springs) -> None:
    for name in ("radius", "punch_stiffness", "punch_stiffness_slope"):
        of = getattr(springs, name)
        last = of(np.full(COUNT, springs.depth))
        np.testing.assert_allclose(of(np.full(COUNT, 7 * springs.depth)), last, rtol=1e-9)


def test_onset_is_the_least_compression_of_that_radius(springs: Springs) -> None:
    delta = at(springs)
    onset, radius = springs.onset(delta), springs.radius(delta)
    assert np.all(onset <= delta)
    np.testing.assert_allclose(springs.radius(onset), radius, rtol=1e-12)  # rounding
    lower = np.maximum(onset - 1e-6 * springs.depth, 0)
    assert np.all(springs.radius(lower)[onset > 0] < radius[onset > 0])


def test_onset_by_hand() -> None:
    """Radius 1, 1, 2, 2, 3 at the nodes 0, 1, 4, 9, 16: powers of two, exact at the nodes."""
    table = np.zeros((1, 5, 3))
    table[0, :, 0] = [1, 1, 2, 2, 3]
    springs = Springs(16.0, np.zeros((1, 5, 6)), table)
    where = [0.0, 0.5, 1.0, 2.0, 4.0, 6.0, 9.0, 12.0, 16.0, 20.0]
    expected = [0.0, 0.0, 0.0, 2.0, 4.0, 4.0, 4.0, 12.0, 16.0, 16.0]
    np.testing.assert_array_equal(springs.onset(np.array(where)[:, None])[:, 0], expected)


def test_a_flat_stud_touches_wholly_from_its_first_cell_on() -> None:
    heights = np.full((1, 100), -40e-6)
    heights[0, :25] = 0
    spring = from_heights(heights, 1e-5, MODULUS)
    first = spring.nodes[1]
    assert spring.onset(np.array([20e-6]))[0] == first
    assert spring.onset(np.array([first / 3]))[0] == first / 3


def test_springs_taken_keep_their_punch(springs: Springs) -> None:
    index = np.array([3, 3, 0])
    delta = np.full(COUNT, springs.depth / 5)
    few = springs.take(index)
    for name in ("force", "radius", "punch_stiffness", "punch_stiffness_slope", "onset"):
        expected = getattr(springs, name)(delta)[index]
        np.testing.assert_array_equal(getattr(few, name)(delta[:3]), expected)


def test_linear_springs_are_linear() -> None:
    stiffness = np.array([1e4, 3e5])
    springs = linear(stiffness, 1e-4, np.array([1e-4, 2e-4]))
    for delta in (0.0, 3e-5, 1e-4, 5e-4):
        d = np.full(2, delta)
        np.testing.assert_allclose(springs.force(d), stiffness * delta, rtol=1e-12)
        np.testing.assert_allclose(springs.energy(d), stiffness * delta**2 / 2, rtol=1e-12)
        np.testing.assert_array_equal(springs.stiffness(d), stiffness)
        np.testing.assert_array_equal(springs.punch_stiffness(d), stiffness)
        np.testing.assert_array_equal(springs.radius(d), [1e-4, 2e-4])
        np.testing.assert_allclose(springs.punch_stiffness_slope(d), [1e8, 1.5e9], rtol=1e-12)
        np.testing.assert_array_equal(springs.onset(d), 0)


@pytest.mark.parametrize(
    ("stiffness", "depth", "radius", "name"),
    [
        ([1.0, 0.0], 1e-4, 1e-4, "stiffness"),
        ([1.0, np.nan], 1e-4, 1e-4, "stiffness"),
        ([1.0, 1.0], 0.0, 1e-4, "depth"),
        ([1.0, 1.0], 1e-4, -1e-4, "radius"),
    ],
)
def test_impossible_linear_springs_are_refused(
    stiffness: list[float], depth: float, radius: float, name: str
) -> None:
    with pytest.raises(InputError, match=f"{name} of linear springs must be positive"):
        linear(np.array(stiffness), depth, radius)
