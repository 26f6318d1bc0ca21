"""Roughness springs: force, stiffness and energy belong together, and to the heights."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from tyrecontact.errors import InputError
from tyrecontact.road.punch import stiffness_factor
from tyrecontact.road.springs import Springs, from_heights

PITCH, MODULUS = 5e-5, 10e6
COUNT = 30


def rough_heights() -> np.ndarray:
    """Elements of 20 x 20 heights each, of increasing roughness."""
    rng = np.random.default_rng(4)
    return rng.standard_normal((COUNT, 400)) * np.linspace(2e-6, 9e-6, COUNT)[:, None]


@pytest.fixture(scope="module")
def springs() -> Springs:
    return from_heights(rough_heights(), PITCH, MODULUS)


def curve(springs: Springs, points: int = 3001, beyond: float = 1.2) -> np.ndarray:
    """Compressions (points, elements) from zero to beyond the table's end."""
    delta = springs.depth * beyond * np.linspace(0, 1, points) ** 2
    return np.repeat(delta[:, None], springs.count, axis=1)


def test_an_untouched_spring_has_neither_force_nor_stiffness(springs: Springs) -> None:
    zero = np.zeros(COUNT)
    for value in (springs.force(zero), springs.stiffness(zero), springs.energy(zero)):
        np.testing.assert_array_equal(value, 0)


def test_stiffness_never_falls_and_force_rises(springs: Springs) -> None:
    delta = curve(springs)
    stiffness = springs.stiffness(delta)
    # rounding: a spring that has reached its last stiffness keeps it to 1e-12
    assert np.all(np.diff(stiffness, axis=0) >= -1e-12 * stiffness.max(axis=0))
    assert np.all(np.diff(springs.force(delta), axis=0) > 0)


@pytest.mark.parametrize(("integral", "integrand"), [("energy", "force"), ("force", "stiffness")])
def test_the_rise_of_one_is_the_integral_of_the_other(
    springs: Springs, integral: str, integrand: str
) -> None:
    """Simpson's rule over short intervals that cut across the cells of the table."""
    edges = curve(springs)
    middles = (edges[1:] + edges[:-1]) / 2
    rate, width = getattr(springs, integrand), np.diff(edges, axis=0)
    simpson = width * (rate(edges[1:]) + rate(edges[:-1]) + 4 * rate(middles)) / 6
    rise = np.diff(getattr(springs, integral)(edges), axis=0)
    # Simpson's rule is exact but for the kinks of k at cell ends; their share shrinks with width
    scale = rise.max(axis=0)
    np.testing.assert_allclose(rise / scale, simpson / scale, atol=1e-5)


def test_one_look_up_gives_what_two_give(springs: Springs) -> None:
    delta = springs.depth * np.linspace(0, 1.5, COUNT)
    force, stiffness = springs.respond(delta, np.ones(COUNT, bool))[:2]
    np.testing.assert_allclose(force, springs.force(delta), rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(stiffness, springs.stiffness(delta), rtol=1e-12, atol=1e-9)


def test_beyond_full_compression_the_last_stiffness_stays(springs: Springs) -> None:
    full = np.full(COUNT, springs.depth)
    last = springs.stiffness(full)
    for depth in (1.01, 3.0, 1e3):
        beyond = depth * full
        np.testing.assert_allclose(springs.stiffness(beyond), last, rtol=1e-9)
        expected = springs.force(full) + last * (beyond - full)
        np.testing.assert_allclose(springs.force(beyond), expected, rtol=1e-9)


def test_force_is_proportional_to_the_modulus(springs: Springs) -> None:
    delta = np.full(COUNT, 0.3 * springs.depth)
    twice = from_heights(rough_heights(), PITCH, 2 * MODULUS)
    np.testing.assert_allclose(twice.force(delta), 2 * springs.force(delta), rtol=1e-12)


def test_numbers_do_not_depend_on_the_unit_of_length(springs: Springs) -> None:
    delta = np.full(COUNT, 0.3 * springs.depth)
    in_mm = from_heights(rough_heights() * 1e3, PITCH * 1e3, MODULUS * 1e-6)
    np.testing.assert_allclose(in_mm.force(delta * 1e3), springs.force(delta), rtol=1e-9)


@pytest.mark.parametrize("plateau", [9, 100, 225])
def test_a_flat_stud_on_a_flat_floor(plateau: int) -> None:
    """A does not change between top and floor, h = floor - delta: F by quadrature of k."""
    floor = 40e-6
    heights = np.full((1, 400), -floor)
    heights[0, :plateau] = 0
    spring = from_heights(heights, 1e-5, MODULUS)
    radius = 1e-5 * np.sqrt(plateau / np.pi)

    def stiffness(delta: float) -> float:
        ratio = radius / max(floor - delta, 1e-5)
        return 8 / 3 * MODULUS * radius * float(stiffness_factor(np.array(ratio)))

    for share in (0.1, 0.5, 0.7, 0.95):
        force = quad(stiffness, 0, share * floor, points=[min(0.74, share) * floor])[0]
        # the table blurs the start over its first cell, 1.5e-5 of the depth, and the kink
        # where the layer gets thinner than a pixel over one cell, 0.7 % of the depth
        assert spring.force(np.array([share * floor]))[0] == pytest.approx(force, rel=1e-3)


def test_flat_elements_among_rough_ones_are_stiff_not_broken() -> None:
    heights = np.vstack([rough_heights()[:1], np.zeros((1, 400))])
    springs = from_heights(heights, PITCH, MODULUS)
    rough, flat = springs.force(np.full(2, springs.depth / 2))
    assert np.isfinite(flat)
    assert flat > rough > 0


@pytest.mark.parametrize("modulus", [0.0, -1.0, np.nan])
def test_an_impossible_modulus_is_refused(modulus: float) -> None:
    with pytest.raises(InputError, match="youngs_modulus"):
        from_heights(rough_heights(), PITCH, modulus)


def test_a_road_without_roughness_is_refused() -> None:
    with pytest.raises(InputError, match="rough inside its elements"):
        from_heights(np.ones((3, 16)), PITCH, MODULUS)
