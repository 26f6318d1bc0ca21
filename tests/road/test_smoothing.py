"""Both readings, both smoothings: springs a solver can use, close to what the pixels gave."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road.punch import stiffness_factor
from tyrecontact.road.smoothing import convex_stiffness, polynomial_stiffness
from tyrecontact.road.springs import Springs, from_heights

PITCH, MODULUS = 5e-5, 10e6
COUNT = 20
KINDS = list(itertools.product((False, True), ("tangent", "secant"), ("monotone", "polynomial")))


def rough_heights() -> np.ndarray:
    """Elements of 20 x 20 heights each, of increasing roughness; one flat, one a single spike."""
    rng = np.random.default_rng(4)
    heights = rng.standard_normal((COUNT, 400)) * np.linspace(2e-6, 9e-6, COUNT)[:, None]
    heights[3] = 0
    heights[7] = 0
    heights[7, 0] = 30e-6
    return heights


def made(bonded: bool, reading: str, smoothing: str) -> Springs:
    return from_heights(
        rough_heights(), PITCH, MODULUS, bonded=bonded, reading=reading, smoothing=smoothing
    )


@pytest.mark.parametrize(("bonded", "reading", "smoothing"), KINDS)
def test_every_kind_of_spring_can_be_relied_on(bonded: bool, reading: str, smoothing: str) -> None:
    """F(0) = 0 and continuous, k >= 0 and never falling, no end."""
    springs = made(bonded, reading, smoothing)
    delta = np.append(springs.depth * 1.2 * np.linspace(0, 1, 2000) ** 2, 1.0)
    at = np.repeat(delta[:, None], COUNT, axis=1)
    force, stiffness = springs.force(at), springs.stiffness(at)
    assert np.isfinite(force).all()
    assert np.all(force[0] == 0)
    # rounding in the cubics between nodes
    assert np.all(np.diff(stiffness, axis=0) >= -1e-12 * stiffness.max(axis=0))
    assert np.all(stiffness >= 0)
    rise, bound = np.diff(force, axis=0), stiffness[1:] * np.diff(delta)[:, None]
    assert np.all(rise <= bound + 1e-9 * force[-2])  # no jump: F rises by less than k d(delta)
    for name in ("radius", "punch_stiffness", "punch_stiffness_slope", "onset"):
        assert np.isfinite(getattr(springs, name)(at)).all()


@pytest.mark.parametrize("bonded", [False, True])
@pytest.mark.parametrize("smoothing", ["monotone", "polynomial"])
def test_the_frozen_punch_follows_the_reading(bonded: bool, smoothing: str) -> None:
    delta = np.repeat(np.geomspace(1e-6, 60e-6, 50)[:, None], COUNT, axis=1)
    tangent, secant = (made(bonded, reading, smoothing) for reading in ("tangent", "secant"))
    np.testing.assert_array_equal(tangent.punch_stiffness(delta), tangent.stiffness(delta))
    straight = secant.force(delta) / delta
    # linear between nodes, with cells of 1 to 2 % of the compression here
    np.testing.assert_allclose(secant.punch_stiffness(delta), straight, rtol=0.03)
    nodes = np.repeat(secant.nodes[1:, None], COUNT, axis=1)
    exact = secant.force(nodes) / nodes
    np.testing.assert_allclose(secant.punch_stiffness(nodes), exact, rtol=1e-9)  # rounding
    assert np.all(secant.stiffness(nodes) >= exact * (1 - 1e-9))  # F is convex


def test_secant_forces_are_those_of_the_punch_where_they_are_convex() -> None:
    """A flat stud: F = (8/3) E a kappa(a / h) delta until the layer is thinner than a pixel."""
    floor, pitch = 40e-6, 1e-5
    heights = np.full((1, 400), -floor)
    heights[0, :100] = 0
    spring = from_heights(heights, pitch, MODULUS, reading="secant")
    a = pitch * np.sqrt(100 / np.pi)
    for delta in (2e-6, 10e-6, 25e-6):
        kappa = float(stiffness_factor(np.array(a / (floor - delta))))
        expected = 8 / 3 * MODULUS * a * kappa * delta
        # slopes are those of chords, of second order in a cell of 1 % of the depth
        assert spring.force(np.array([delta]))[0] == pytest.approx(expected, rel=1e-3)


def test_the_convex_curve_lies_below_and_touches() -> None:
    delta = np.linspace(0, 1, 201)
    force = (delta + delta**2 + 0.02 * np.sin(40 * delta))[None]
    stiffness = convex_stiffness(delta, force, np.array([1.0]))[0]
    assert np.all(np.diff(stiffness) >= 0)
    width = np.diff(delta)
    below = np.concatenate([[0], np.cumsum(width * (stiffness[1:] + stiffness[:-1]) / 2)])
    # slopes are smeared over a cell of 0.005 where they rise by 0.3: 1.5e-3 of a force of 2, twice
    assert np.all(below <= force[0] + 3e-3)
    assert np.abs(below - force[0])[delta > 0.5].min() < 3e-3


def test_a_curve_that_is_convex_keeps_its_slope() -> None:
    delta = np.linspace(0, 1, 101) ** 2
    stiffness = convex_stiffness(delta, delta[None] ** 3, np.array([1.0]))[0]
    # chords, of second order in the width of a cell, 20 % of delta and less
    np.testing.assert_allclose(stiffness[10:-1], 3 * delta[10:-1] ** 2, rtol=2e-2)


def test_a_spring_that_ends_before_the_table_keeps_its_slope_beyond() -> None:
    delta = np.linspace(0, 1, 401)
    force = np.minimum(delta, 0.5)[None] ** 2
    for smooth in (convex_stiffness, polynomial_stiffness):
        stiffness = smooth(delta, force, np.array([0.5]))[0]
        beyond = stiffness[delta > 0.51]
        np.testing.assert_allclose(beyond, stiffness[-1], rtol=1e-12)  # rounding
        assert stiffness[-1] == pytest.approx(1.0, rel=0.02)  # 2 delta there, but for a cell


@pytest.mark.parametrize("power", [1, 2, 5, 10])
def test_a_polynomial_of_the_tenth_order_is_found_again(power: int) -> None:
    delta = 3e-5 * np.linspace(0, 1, 2001) ** 2
    force = 7.0 * (delta / 3e-5) ** power
    stiffness = polynomial_stiffness(delta, force[None], np.array([3e-5]))[0]
    exact = 7.0 / 3e-5 * power * (delta / 3e-5) ** (power - 1)
    # F between nodes is a chord, and the fit weighs relative errors over nine decades
    np.testing.assert_allclose(stiffness[200:], exact[200:], rtol=5e-3)


def test_the_polynomial_stays_close_in_force() -> None:
    """One curve of ten free coefficients for three decades of force: tens of percent."""
    smooth, raw = made(False, "tangent", "polynomial"), made(False, "tangent", "monotone")
    rough = [i for i in range(COUNT) if i not in (3, 7)]
    for delta in (4e-6, 9e-6, 15e-6):
        at = np.full(COUNT, delta)
        ratio = (smooth.force(at) / raw.force(at))[rough]
        assert np.all((ratio > 0.5) & (ratio < 2))
        assert np.median(ratio) == pytest.approx(1, abs=0.2)


def test_sticking_makes_springs_stiffer() -> None:
    delta = np.repeat(np.geomspace(1e-6, 60e-6, 50)[:, None], COUNT, axis=1)
    sticks, slips = made(True, "tangent", "monotone"), made(False, "tangent", "monotone")
    ratio = sticks.stiffness(delta) / slips.stiffness(delta)
    assert np.all((ratio >= 1) & (ratio < 4))  # 4 is that of a thin film
    assert ratio.max() > 2


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"reading": "tangnt"}, "did you mean 'tangent'"),
        ({"smoothing": "spline"}, "smoothing of springs must be one of"),
    ],
)
def test_unknown_kinds_are_refused(change: dict[str, str], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        from_heights(rough_heights(), PITCH, MODULUS, **change)
