"""The flat punch on a bonded layer: published anchors, both limits, and a second solution."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from tyrecontact.road.punch import stiffness_exponent, stiffness_factor


def kappa(ratio: float, poissons_ratio: float = 0.5, bonded: bool = False) -> float:
    return float(stiffness_factor(np.array(ratio), poissons_ratio, bonded))


def layer_function(u: np.ndarray, poissons_ratio: float) -> np.ndarray:
    """1 - L(u), written with decaying exponentials."""
    k0, decay = 3 - 4 * poissons_ratio, np.exp(-2 * u)
    rest = (4 * u**2 + 4 * u + 1 + k0**2) * decay + 2 * k0 * decay**2
    return rest / (k0 * (1 + decay**2) + (4 * u**2 + 1 + k0**2) * decay)


def panels(count: int, end: float, order: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss-Legendre rule of `order` nodes on each of `count` equal panels of [0, end]."""
    x, weight = np.polynomial.legendre.leggauss(order)
    width = end / count
    nodes = (np.arange(count)[:, None] + (x + 1) / 2) * width
    return nodes.ravel(), np.tile(weight * width / 2, count)


def kappa_by_dense_nystrom(ratio: float, poissons_ratio: float) -> float:
    """The Fredholm equation with far more nodes than needed: 240 in t, 3200 in u."""
    t, weight = panels(10, 1.0, 24)
    u, du = panels(100, 25.0, 32)
    cosine = np.cos(ratio * np.outer(t, u))
    kernel = -2 / np.pi * ratio * (cosine * layer_function(u, poissons_ratio) * du) @ cosine.T
    return float(weight @ np.linalg.solve(np.eye(t.size) + kernel * weight, np.ones(t.size)))


@pytest.mark.parametrize(("ratio", "anchor"), [(0.2, 1.281), (1.0, 3.619), (2.0, 9.150)])
def test_published_values_of_an_incompressible_layer(ratio: float, anchor: float) -> None:
    assert kappa(ratio) == pytest.approx(anchor, abs=6e-4)  # printed to three decimals


@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3, 0.499, 0.5])
@pytest.mark.parametrize("ratio", [0.0137, 0.31, 1.7, 7.3, 17.0, 23.0, 47.0, 63.0])
def test_a_second_solution_agrees(ratio: float, poissons_ratio: float) -> None:
    expected = kappa_by_dense_nystrom(ratio, poissons_ratio)
    # the module promises 1e-6; both solutions lose digits to rounding as the layer gets thin
    assert kappa(ratio, poissons_ratio) == pytest.approx(expected, rel=1e-6 + 2e-7 * ratio)


@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("ratio", [1e-5, 1e-3, 0.02])
def test_a_thick_layer_adds_a_correction_of_first_order(
    ratio: float, poissons_ratio: float
) -> None:
    """K(x, t) = -(2 / pi)(a / h) int (1 - L) du for a << h, hence kappa = 1 / (1 - that)."""
    deficit = quad(layer_function, 0, 40, args=(poissons_ratio,))[0]
    expected = 1 / (1 - 2 / np.pi * ratio * deficit)
    # what is left out is of the third order in a / h, with a factor of order one;
    # below a / h = 0.001 the module takes kappa - 1 as linear, which leaves out 1e-8
    assert kappa(ratio, poissons_ratio) - 1 == pytest.approx(
        expected - 1, rel=3 * ratio**2, abs=2e-8
    )


def test_a_thin_incompressible_film_is_reached_slowly_and_from_above() -> None:
    ratios = np.array([5.0, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60])
    over_film = stiffness_factor(ratios) / (3 * np.pi / 64 * ratios**3)
    assert over_film[1] == pytest.approx(1.717, abs=1e-3)  # the film law holds 58 % of it
    assert np.all(np.diff(over_film) < 0)
    # an edge correction: the rest is about 6 h / a
    np.testing.assert_allclose((over_film[5:] - 1) * ratios[5:], 6.15, atol=0.25)


@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3])
def test_a_thin_compressible_film_is_an_oedometer(poissons_ratio: float) -> None:
    """F = pi a^2 M delta / h with M = E (1 - nu) / ((1 + nu)(1 - 2 nu))."""
    ratios = np.array([20.0, 40.0, 60.0])
    film = np.pi / 2 * ratios * (1 - poissons_ratio) ** 2 / (1 - 2 * poissons_ratio)
    excess = stiffness_factor(ratios, poissons_ratio) / film - 1
    assert np.all(excess > 0)
    assert np.all(excess < 0.4 / ratios)  # an edge correction: a fraction of h / a


@pytest.mark.parametrize("poissons_ratio", [0.1, 0.3, 0.5])
def test_a_sticking_punch_on_a_half_space(poissons_ratio: float) -> None:
    """Mossakovskii's factor ln(3 - 4 nu)(1 - nu) / (1 - 2 nu), 1 if incompressible."""
    x = 1 - 2 * poissons_ratio
    expected = (1 - poissons_ratio) * (np.log1p(2 * x) / x if x > 0 else 2)
    assert kappa(0.0, poissons_ratio, bonded=True) == pytest.approx(expected, rel=1e-12)
    # the layer adds a share of a / h, of order one; solved for, not put in
    slope = (kappa(2e-3, poissons_ratio, True) - kappa(1e-3, poissons_ratio, True)) / 1e-3
    extrapolated = kappa(1e-3, poissons_ratio, True) - 1e-3 * slope
    assert extrapolated == pytest.approx(expected, abs=5e-6)  # the second order in a / h


@pytest.mark.parametrize("poissons_ratio", [0.1, 0.3, 0.5])
def test_sticking_stiffens(poissons_ratio: float) -> None:
    ratios = np.geomspace(0.01, 64, 40)
    sticks = stiffness_factor(ratios, poissons_ratio, bonded=True)
    slips = stiffness_factor(ratios, poissons_ratio)
    assert np.all(sticks > slips)
    if poissons_ratio == 0.5:  # without and with a free upper surface, a film resists 1 : 4
        assert np.all(np.diff(sticks / slips) > 0)
        assert sticks[-1] / slips[-1] < 4


def test_a_thin_film_between_two_that_stick() -> None:
    """F = pi E a^4 delta / (2 h^3): kappa = (3 pi / 16)(a / h)^3, but for the edge."""
    ratios = np.array([10.0, 20, 30, 40, 50, 60])
    over_film = stiffness_factor(ratios, 0.5, bonded=True) / (3 * np.pi / 16 * ratios**3)
    assert np.all(np.diff(over_film) < 0)
    np.testing.assert_allclose((over_film[1:] - 1) * ratios[1:], 1.75, atol=0.1)


def test_a_thin_compressible_film_does_not_mind_sticking() -> None:
    """It is an oedometer either way, but for the edge."""
    excess = stiffness_factor(np.array([20.0, 60.0]), 0.3, bonded=True)
    excess /= stiffness_factor(np.array([20.0, 60.0]), 0.3)
    assert np.all(excess - 1 < 0.02 / np.array([20.0, 60.0]))


@pytest.mark.parametrize("bonded", [False, True])
def test_the_exponent_is_the_derivative(bonded: bool) -> None:
    ratios, step = np.array([5e-4, 0.01, 0.3, 2.0, 20.0, 100.0]), 1e-4
    up, down = (stiffness_factor(ratios * (1 + sign * step), 0.5, bonded) for sign in (1, -1))
    slope = (np.log(up) - np.log(down)) / (np.log1p(step) - np.log1p(-step))
    # the difference's own error, and where it spans the ends of no cell of the table
    np.testing.assert_allclose(stiffness_exponent(ratios, 0.5, bonded), slope, rtol=1e-6)
