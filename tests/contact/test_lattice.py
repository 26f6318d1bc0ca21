"""Products on the lattice and the memory of past forces, against sums written out."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact.lattice import History, LatticeKernel
from tyrecontact.tread.kernels import Kernel

LAGS, NY, NX = 5, 3, 4


def kernel(lags: int = LAGS) -> Kernel:
    """Values without any symmetry but that of |di|, |dj|."""
    values = np.random.default_rng(1).standard_normal((lags, NY, NX))
    return Kernel(values, 1e-3, 1e-5)


def forces(steps: int) -> np.ndarray:
    return np.random.default_rng(2).standard_normal((steps, NY, NX))


def displacement(values: np.ndarray, force: np.ndarray) -> np.ndarray:
    """sum over elements of g(|di|, |dj|) F, written out."""
    total = np.zeros((NY, NX))
    for i, j in np.ndindex(NY, NX):
        for p, q in np.ndindex(NY, NX):
            total[i, j] += values[abs(i - p), abs(j - q)] * force[p, q]
    return total


def test_products_are_those_of_the_dense_matrix() -> None:
    tread, force = LatticeKernel(kernel()), forces(1)[0]
    expected = displacement(kernel().values[0], force)
    np.testing.assert_allclose(tread.now.displacement(force.ravel()), expected.ravel(), atol=1e-13)


def test_of_others_is_without_what_a_force_does_to_its_own_element() -> None:
    now, force = LatticeKernel(kernel()).now, forces(1)[0].ravel()
    tread = now.with_shared(0.3)
    assert tread.products is now.products  # nothing is computed anew
    matrix = tread.matrix(np.arange(NY * NX))
    np.testing.assert_allclose(tread.displacement(force), matrix @ force, atol=1e-13)
    np.fill_diagonal(matrix, 0)
    np.testing.assert_allclose(tread.from_others(force), matrix @ force, atol=1e-13)


def test_the_matrix_between_some_elements() -> None:
    values = kernel().values[0]
    matrix = LatticeKernel(kernel()).now.matrix(np.array([0, 5, 11]))  # (0,0) (1,1) (2,3)
    expected = [
        [values[0, 0], values[1, 1], values[2, 3]],
        [values[1, 1], values[0, 0], values[1, 2]],
        [values[2, 3], values[1, 2], values[0, 0]],
    ]
    np.testing.assert_array_equal(matrix, expected)


def test_self_compliance_is_that_of_the_same_step() -> None:
    assert LatticeKernel(kernel()).now.self_compliance == kernel().values[0, 0, 0]


@pytest.mark.parametrize("lags", [2, 3, LAGS])
def test_history_is_the_sum_over_lags_however_often_the_ring_turns(lags: int) -> None:
    history, past = History(LatticeKernel(kernel(lags))), forces(13)
    for n in range(14):
        expected = np.zeros((NY, NX))
        for j in range(1, min(n, lags - 1) + 1):
            expected += displacement(kernel(lags).values[j], past[n - j])
        np.testing.assert_allclose(history.displacement(), expected, atol=1e-12)
        if n < 13:
            history.remember(past[n])


def test_asking_twice_gives_the_same() -> None:
    history = History(LatticeKernel(kernel()))
    history.remember(forces(1)[0])
    np.testing.assert_array_equal(history.displacement(), history.displacement())


def test_two_histories_on_one_kernel_do_not_share_their_past() -> None:
    tread = LatticeKernel(kernel())
    one, other = History(tread), History(tread)
    one.remember(forces(1)[0])
    assert np.all(other.displacement() == 0)
    assert np.any(one.displacement() != 0)


def test_a_static_kernel_remembers_nothing() -> None:
    history = History(LatticeKernel(kernel(1)))
    for force in forces(3):
        history.remember(force)
        np.testing.assert_array_equal(history.displacement(), np.zeros((NY, NX)))
