"""A square element on a thick layer: closed form of the half-space, first correction."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.integrate import quad

from tyrecontact.tread.kernels import static
from tyrecontact.tread.materials import Layer

MODULUS, SIDE = 25e6, 1e-3
MakeLayer = Callable[[float, float], Layer]


def potential(x: float, y: float) -> float:
    """Fourth integral of 1/r, twice in x and twice in y."""
    x, y = abs(x), abs(y)
    total = -(np.hypot(x, y) ** 3) / 6
    if x > 0:
        total += x**2 * y * np.arcsinh(y / x) / 2
    if y > 0:
        total += x * y**2 * np.arcsinh(x / y) / 2
    return float(total)


def mean_inverse_distance(i: int, j: int) -> float:
    """Mean of 1/r between two unit squares, i and j sides apart."""
    second = {-1: 1, 0: -2, 1: 1}
    return sum(second[p] * second[q] * potential(i + p, j + q) for p in second for q in second)


def deficit(poissons_ratio: float) -> float:
    """int (1 - L) du, by which h weakens the far field of the half-space."""
    k0 = 3 - 4 * poissons_ratio

    def integrand(u: float) -> float:
        decay = np.exp(-2 * u)
        rest = (4 * u**2 + 4 * u + 1 + k0**2) * decay + 2 * k0 * decay**2
        return rest / (k0 * (1 + decay**2) + (4 * u**2 + 1 + k0**2) * decay)

    return quad(integrand, 0, 40)[0]


def scale(poissons_ratio: float) -> float:
    return (1 - poissons_ratio**2) / (np.pi * MODULUS * SIDE)


def test_the_closed_form_itself() -> None:
    known = 4 * (np.log(1 + np.sqrt(2)) - (np.sqrt(2) - 1) / 3)
    assert mean_inverse_distance(0, 0) == pytest.approx(known, rel=1e-12)
    # far squares are points: 1/r, with a correction of (side / r)^2 / 12
    assert mean_inverse_distance(20, 0) == pytest.approx(1 / 20, rel=1e-3)


@pytest.mark.parametrize("poissons_ratio", [0.3, 0.499])
@pytest.mark.parametrize("thickness", [10, 20])
def test_an_element_on_a_thick_layer(
    elastic_layer: MakeLayer, poissons_ratio: float, thickness: int
) -> None:
    layer = elastic_layer(thickness * SIDE, poissons_ratio)
    compliance = static([layer], (3, 3), SIDE).values[0]
    for i, j in ((0, 0), (0, 1), (2, 1)):
        half_space = mean_inverse_distance(i, j)
        expected = scale(poissons_ratio) * (half_space - deficit(poissons_ratio) / thickness)
        # left out: the third order in r / h, with r the larger of distance and side; found: the
        # interpolation over wavenumbers and the tail of the aliases, 2e-5 of the self compliance
        error = scale(poissons_ratio) * (2 * (i**2 + j**2 + 1) / thickness**3 + 6e-5)
        assert compliance[i, j] == pytest.approx(expected, abs=error)


def test_thicker_layers_tend_to_the_half_space(elastic_layer: MakeLayer) -> None:
    """One over the thickness, extrapolated to nothing."""
    thin, thick = (
        static([elastic_layer(h * SIDE, 0.3)], (1, 1), SIDE).values[0, 0, 0] for h in (10, 20)
    )
    half_space = scale(0.3) * mean_inverse_distance(0, 0)
    assert thin < thick < half_space
    # third order left by the extrapolation, and the 2e-5 of above
    assert 2 * thick - thin == pytest.approx(half_space, rel=1e-4)


def test_a_rigid_block_on_the_default_tread(
    elastic_layer: MakeLayer, element_matrix: Callable[[np.ndarray], np.ndarray]
) -> None:
    """20 x 20 mm on 10 mm of 25 MPa: 3.1-3.2 MN/m (physics, section 3)."""
    kernel = static([elastic_layer(0.01, 0.499)], (20, 20), SIDE)
    force = np.linalg.solve(element_matrix(kernel.values[0]), np.ones(400))
    assert 3.1e6 < force.sum() < 3.2e6
    assert force.min() > 0
    assert force.argmax() in (0, 19, 380, 399)  # a punch's pressure peaks in its corners
