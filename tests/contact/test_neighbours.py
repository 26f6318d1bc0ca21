"""The preconditioner: positive definite for every road, exact where it can be, and worth it."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact import linear
from tyrecontact.contact.lattice import Compliance, LatticeKernel
from tyrecontact.contact.neighbours import Neighbours, convolved
from tyrecontact.contact.transforms import kernel_waves

SHAPE = (6, 5)


def dense_stencil(neighbours: Neighbours, scale: np.ndarray) -> np.ndarray:
    """h as a matrix."""
    stencil = neighbours.stencil(scale)
    units = np.eye(scale.size).reshape(-1, *SHAPE)
    return np.stack([convolved(stencil, unit).ravel() for unit in units], axis=1)


def short_ranged(seed: int) -> np.ndarray:
    """A compliance that reaches to the nearest neighbours, positive definite [m/N]."""
    values = np.zeros(SHAPE)
    values[0, 0] = 2e-5
    values[:2, :2] += np.random.default_rng(seed).uniform(-3e-6, 3e-6, (2, 2)) * [[0, 1], [1, 0.5]]
    return values


def test_the_stencil_is_the_sum_over_nine_elements() -> None:
    field, stencil = np.random.default_rng(1).standard_normal(SHAPE), np.array([1.0, 2, 3, 4])
    expected = np.zeros(SHAPE)
    for i, j in np.ndindex(SHAPE):
        for p, q in np.ndindex(SHAPE):
            dy, dx = abs(i - p), abs(j - q)
            if max(dy, dx) < 2:
                expected[i, j] += stencil[2 * dy + dx] * field[p, q]
    np.testing.assert_allclose(convolved(stencil, field), expected, atol=1e-13)


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("decades", [0, 2, 6])
def test_it_is_positive_definite_whatever_the_springs(seed: int, decades: int) -> None:
    values, random = short_ranged(seed), np.random.default_rng(seed)
    own = values[0, 0]
    neighbours = Neighbours(kernel_waves(values) - own, own)
    stiffness = 10 ** (4 + decades * random.random(values.size)) * (
        random.random(values.size) > 0.3
    )
    scale = np.sqrt(stiffness / (1 + own * stiffness))
    inverse = np.eye(scale.size) - scale[:, None] * dense_stencil(neighbours, scale) * scale
    np.testing.assert_allclose(inverse, inverse.T, atol=1e-13)
    assert np.linalg.eigvalsh(inverse)[0] > 0.04


def test_it_is_the_inverse_where_springs_are_alike_and_soft() -> None:
    """To the first order in s^2 g' it is, and what is left is of the second."""
    values = short_ranged(3)
    own, others = (
        values[0, 0],
        Compliance(values).matrix(np.arange(values.size)) - np.eye(30) * 2e-5,
    )
    left = []
    for stiffness in (1e3, 1e2):
        square = stiffness / (1 + own * stiffness)
        scale = np.full(values.size, np.sqrt(square))
        approximate = np.eye(30) - square * dense_stencil(
            Neighbours(kernel_waves(values) - own, own), scale
        )
        left.append(np.abs(approximate @ (np.eye(30) + square * others) - np.eye(30)).max())
    assert left[1] < left[0] < 0.01


@pytest.mark.parametrize("at_rest", [False, True])
def test_it_saves_a_third_of_the_products(
    tread: LatticeKernel, at_rest: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    compliance = tread.at_rest if at_rest else tread.now
    random = np.random.default_rng(4)
    stiffness = 10 ** random.uniform(4, 6, 64) * (random.random(64) > 0.2)
    scale = np.sqrt(stiffness / (1 + compliance.self_compliance * stiffness))
    products, solutions = [], []
    for few in (0, 1024):
        monkeypatch.setattr(linear, "_FEW", few)
        counted, plain = [], Compliance.from_others
        monkeypatch.setattr(
            Compliance, "from_others", lambda *both, c=counted, p=plain: (c.append(1), p(*both))[1]
        )
        y = linear._conjugate_gradients(compliance, scale, scale, 1e-6)
        monkeypatch.setattr(Compliance, "from_others", plain)
        products.append(len(counted))
        solutions.append(y)
    assert products[0] < 0.7 * products[1]
    np.testing.assert_allclose(*solutions, atol=1e-4 * np.abs(solutions[0]).max())
