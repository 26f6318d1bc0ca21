"""Forces within one step: both methods solve the equation, and say so when they do not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact import fast
from tyrecontact.contact.interface import Interface, Mirrored
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.newton import Solution, robust, thesis
from tyrecontact.road.springs import Springs, from_heights
from tyrecontact.tread.kernels import Kernel

TOLERANCE = 1e-13
METHODS = [robust, thesis]
Method = Callable[..., Solution]


def residual(
    tread: LatticeKernel, interface: Interface, target: np.ndarray, compression: np.ndarray
) -> float:
    """Largest |b - g_0 F(d) - d|, from the springs and a dense matrix alone."""
    active = (compression > 0) | interface.bonded
    force = np.sign(compression) * interface.springs.force(np.abs(compression)) * active
    compliance = tread.now.matrix(np.arange(compression.size))
    return float(np.abs(target - compliance @ force - compression).max())


@pytest.fixture(scope="module")
def free(rough_springs: Springs) -> Interface:
    return Mirrored(rough_springs, np.zeros(rough_springs.count, bool))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("indentation", [5e-6, 3e-5, 1e-4, 2e-4])
def test_the_solution_solves_the_equation(
    tread: LatticeKernel, free: Interface, tops: np.ndarray, method: Method, indentation: float
) -> None:
    target = indentation + tops
    solution = method(tread.now, free, target, tops, TOLERANCE, 50)
    assert solution.converged
    # the tolerance, and the rounding of 64 products of 1e-4 m
    assert residual(tread, free, target, solution.compression) < TOLERANCE + 1e-17 * 64
    np.testing.assert_allclose(
        solution.displacement, target - solution.compression, atol=2 * TOLERANCE
    )
    assert solution.residual <= TOLERANCE


def test_contact_is_partial_and_found(
    tread: LatticeKernel, free: Interface, tops: np.ndarray
) -> None:
    target = 2e-5 + tops
    solution = robust(tread.now, free, target, tops, TOLERANCE, 50)
    touching = solution.compression > 0
    assert 0 < touching.sum() < touching.size
    np.testing.assert_array_equal(solution.force > 0, touching)
    np.testing.assert_array_equal(solution.force[~touching], 0)


@pytest.mark.parametrize("indentation", [2e-5, 2e-4])
def test_both_methods_find_the_same(
    tread: LatticeKernel, free: Interface, tops: np.ndarray, indentation: float
) -> None:
    one, other = (
        method(tread.now, free, indentation + tops, tops, TOLERANCE, 50) for method in METHODS
    )
    # springs of up to 1e6 N/m turn the tolerance into 1e-7 N
    np.testing.assert_allclose(one.force, other.force, atol=1e-6)
    np.testing.assert_allclose(one.compression, other.compression, atol=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_bonded_elements_are_solved_in_tension(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, method: Method
) -> None:
    bonded = np.arange(64) % 3 == 0
    interface, target = Mirrored(rough_springs, bonded), tops - 5e-6
    solution = method(tread.now, interface, target, tops, TOLERANCE, 50)
    assert solution.converged
    assert residual(tread, interface, target, solution.compression) < 2 * TOLERANCE
    assert np.all(solution.force[bonded] < 0)
    # pulled neighbours may lift the tread onto a free element, but it never pulls
    assert np.all(solution.force[~bonded] >= 0)


@pytest.mark.parametrize("method", METHODS)
def test_one_linear_spring_on_its_own(
    linear_springs: Callable[[np.ndarray], Springs], method: Method
) -> None:
    """d = b / (1 + g k), in one iteration, or two where the first is in single precision."""
    compliance, stiffness, target = 2.5e-5, 8e4, np.array([1e-5])
    tread = LatticeKernel(Kernel(np.full((1, 1, 1), compliance), 1e-3, np.inf))
    interface = Mirrored(linear_springs(np.array([stiffness])), np.zeros(1, bool))
    solution = method(tread.now, interface, target, target, 1e-18, 5)
    assert solution.compression[0] == pytest.approx(1e-5 / (1 + compliance * stiffness))
    assert solution.force[0] == pytest.approx(stiffness * solution.compression[0])
    assert solution.iterations <= (2 if method is robust and fast.loops() else 1)


@pytest.mark.parametrize("method", METHODS)
def test_one_spring_beyond_full_compression(rough_springs: Springs, method: Method) -> None:
    """There F = F_D + k_D (d - D), hence d = (b - g (F_D - k_D D)) / (1 + g k_D)."""
    spring, compliance = rough_springs.take(np.array([10])), 2.5e-5
    depth = np.array([spring.depth])
    force, stiffness = spring.force(depth), spring.stiffness(depth)
    deep = depth + 2 * compliance * force  # so that the closed form lies beyond the depth
    expected = (deep - compliance * (force - stiffness * depth)) / (1 + compliance * stiffness)
    assert expected > depth
    tread = LatticeKernel(Kernel(np.full((1, 1, 1), compliance), 1e-3, np.inf))
    solution = method(tread.now, Mirrored(spring, np.zeros(1, bool)), deep, deep, 1e-16, 50)
    np.testing.assert_allclose(solution.compression, expected, rtol=1e-9)


@pytest.mark.parametrize("method", METHODS)
def test_many_linear_springs_are_a_linear_system(
    tread: LatticeKernel, linear_springs: Callable[[np.ndarray], Springs], method: Method
) -> None:
    stiffness = np.geomspace(1e3, 1e6, 64)
    interface = Mirrored(linear_springs(stiffness), np.ones(64, bool))
    target = np.random.default_rng(0).standard_normal(64) * 1e-5
    solution = method(tread.now, interface, target, target, 1e-16, 20)
    matrix = np.eye(64) + tread.now.matrix(np.arange(64)) * stiffness
    np.testing.assert_allclose(solution.compression, np.linalg.solve(matrix, target), atol=1e-15)


@pytest.mark.parametrize("start", [0.0, 1e-7, 5e-4, -5e-4])
def test_robust_gets_there_from_far_away(
    tread: LatticeKernel, free: Interface, tops: np.ndarray, start: float
) -> None:
    target = 5e-4 + tops
    solution = robust(tread.now, free, target, np.full(64, start), TOLERANCE, 30)
    assert solution.converged
    assert residual(tread, free, target, solution.compression) < 2 * TOLERANCE


#: springs, bonds and roads on which full Newton steps go round in circles, found among 3000
CIRCLING = [1113, 1141, 1284, 1288, 1437, 1582, 1761, 1800, 1891, 2024, 2281, 2896]


@pytest.mark.parametrize("seed", [*range(6), *CIRCLING])
def test_robust_solves_any_springs(tread: LatticeKernel, seed: int) -> None:
    """Roughness and modulus over decades, some elements bonded, the road where it may be."""
    rng = np.random.default_rng(seed)
    heights = rng.standard_normal((64, 100)) * 10 ** rng.uniform(-6.5, -3.5)
    springs = from_heights(heights, 10 ** rng.uniform(-5, -4), 10 ** rng.uniform(5, 10))
    interface = Mirrored(springs, rng.random(64) < rng.random())
    target = rng.standard_normal(64) * 10 ** rng.uniform(-6.5, -3.5) + rng.uniform(-3e-4, 3e-4)
    start = np.full(64, rng.choice([0, 1e-5, -1e-5, 1e-3]))
    solution = robust(tread.now, interface, target, start, 1e-12, 50)
    assert solution.converged
    # the tolerance, and rounding where springs of 1e10 Pa make two solutions of one residual
    assert residual(tread, interface, target, solution.compression) < 2e-12


@pytest.mark.parametrize("method", METHODS)
def test_too_few_iterations_are_owned_up_to(
    tread: LatticeKernel, free: Interface, tops: np.ndarray, method: Method
) -> None:
    target = 1e-4 + tops
    solution = method(tread.now, free, target, tops, TOLERANCE, 1)
    assert not solution.converged
    assert solution.iterations == 1
    assert solution.residual > TOLERANCE
    honest = residual(tread, free, target, solution.compression)
    assert solution.residual == pytest.approx(honest, rel=1e-6)


@pytest.mark.parametrize("method", METHODS)
def test_a_solution_is_left_alone(
    tread: LatticeKernel, free: Interface, tops: np.ndarray, method: Method
) -> None:
    target = 5e-5 + tops
    solution = method(tread.now, free, target, tops, TOLERANCE, 50)
    again = method(tread.now, free, target, solution.compression, TOLERANCE, 50)
    assert again.iterations == 0
    np.testing.assert_allclose(again.force, solution.force, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_nothing_touches_nothing(
    tread: LatticeKernel, free: Interface, tops: np.ndarray, method: Method
) -> None:
    target = tops - 1e-5
    solution = method(tread.now, free, target, tops - 2e-5, TOLERANCE, 10)
    np.testing.assert_array_equal(solution.force, 0)
    np.testing.assert_allclose(solution.compression, target, atol=TOLERANCE)


def test_the_jacobian_as_printed_diverges_where_the_exact_one_converges(
    tread: LatticeKernel, linear_springs: Callable[[np.ndarray], Springs]
) -> None:
    """Eq. 8 of the thesis scales rows instead of columns: a stiff spring k among soft ones.

    Errors then grow where sum (k g_0[i, j])^2 over its neighbours exceeds 1 + k g_0[i, i].
    """
    stiffness = np.full(64, 1e3)
    stiffness[27] = 1e7
    near = tread.now.matrix(np.arange(64))[27] * 1e7
    assert (near**2).sum() - near[27] ** 2 > 1 + near[27]
    interface = Mirrored(linear_springs(stiffness), np.ones(64, bool))
    known = (tread.now, interface, np.full(64, 1e-5), np.full(64, 0.9e-5), 1e-15, 10)
    exact, printed = thesis(*known), thesis(*known, as_printed=True)
    assert exact.converged
    assert exact.iterations <= 3  # a linear system
    assert printed.residual > 1.0  # metres, from micrometres


def test_the_jacobian_as_printed_is_too_slow_on_a_rough_road(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray
) -> None:
    """One step of 1 um, and the ten iterations of the thesis."""
    interface = Mirrored(rough_springs, np.zeros(64, bool))
    begun = thesis(tread.now, interface, 6e-5 + tops, np.zeros(64), 1e-13, 60)
    known = (tread.now, interface, 6.1e-5 + tops, begun.compression, 1e-13, 10)
    assert thesis(*known).converged
    assert not thesis(*known, as_printed=True).converged


def test_the_jacobian_as_printed_does_where_all_springs_are_one(
    tread: LatticeKernel, linear_springs: Callable[[np.ndarray], Springs]
) -> None:
    """Equal stiffnesses make rows and columns the same: the misprint is one of the index alone."""
    interface = Mirrored(linear_springs(np.full(64, 1e5)), np.zeros(64, bool))
    target = np.full(64, 1e-5)
    found = thesis(tread.now, interface, target, target, 1e-15, 5, as_printed=True)
    assert found.converged
