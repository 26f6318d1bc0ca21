"""The predicted critical stiffness against runs of linear springs just below and just above it."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact.lattice import History, LatticeKernel
from tyrecontact.tread.kernels import (
    Kernel,
    band_limited,
    critical_angle,
    critical_stiffness,
    hermitian_symbol,
    interpolated,
    passive,
    passive_mobility,
)
from tyrecontact.tread.materials import Layer

SHAPE, STEP = (6, 7), 1 / 51200


def between(symbol: np.ndarray) -> np.ndarray:
    """The dense matrix between all elements that values by offset (ny, nx) stand for."""
    row, column = (index.ravel() for index in np.indices(symbol.shape))
    return symbol[abs(row[:, None] - row), abs(column[:, None] - column)]


def growth(kernel: Kernel, stiffness: float, steps: int = 800) -> float:
    """Pressed forces of equal springs, all in contact: their ringing late over half-way, if any.

    d = b - u, F = k d, u_n = g_0 F_n + history; the road b is pressed in over 20 steps.
    """
    history = History(LatticeKernel(kernel))
    count = kernel.values[0].size
    solve = np.linalg.inv(np.eye(count) + stiffness * between(kernel.values[0]))
    tops = 1e-6 * np.random.default_rng(1).random(count)
    force = np.zeros((steps, count))
    for n in range(steps):
        road = tops + 1e-5 * min(n / 20, 1)
        force[n] = stiffness * solve @ (road - history.displacement().ravel())
        history.remember(force[n].reshape(SHAPE))
    ringing = np.abs(np.diff(force, n=2, axis=0)).max(axis=1)
    window = kernel.lags  # so that an echo that comes once a kernel is in both
    half_way = ringing[steps // 2 - window : steps // 2].max()
    return float(ringing[-window:].max() / max(half_way, 1e-9 * np.abs(force).max()))


@pytest.fixture(scope="module")
def kernel(tread_layers: list[Layer]) -> Kernel:
    return band_limited(tread_layers, SHAPE, 1e-3, STEP, 64)


@pytest.mark.parametrize("share", [0.5, 0.98])
def test_just_below_the_critical_stiffness_ringing_dies(kernel: Kernel, share: float) -> None:
    assert growth(kernel, share * critical_stiffness(kernel, SHAPE)) < 0.5


@pytest.mark.parametrize("share", [1.02, 1.5])
def test_just_above_the_critical_stiffness_ringing_grows(kernel: Kernel, share: float) -> None:
    assert growth(kernel, share * critical_stiffness(kernel, SHAPE), steps=500) > 10


@pytest.mark.parametrize("factor", [2, 4])
def test_interpolation_bears_all_below_and_not_twice_as_much(kernel: Kernel, factor: int) -> None:
    """There the prediction is a bound: it holds for every monotone spring, not only for equal ones.

    Equal linear springs of twice the bound are unstable.
    """
    finer = interpolated(kernel, factor)
    bound = critical_stiffness(finer, SHAPE)
    assert bound > 2 * critical_stiffness(kernel, SHAPE)
    assert growth(finer, 0.99 * bound) < 0.5
    assert growth(finer, 2 * bound) > 10


@pytest.mark.parametrize("factor", [2, 3])
def test_recomputing_at_a_finer_step_raises_the_limit(
    tread_layers: list[Layer], kernel: Kernel, factor: int
) -> None:
    finer = band_limited(tread_layers, SHAPE, 1e-3, STEP / factor, 64 * factor)
    limit = critical_stiffness(finer, SHAPE)
    assert limit >= factor * critical_stiffness(kernel, SHAPE)
    assert growth(finer, 0.98 * limit) < 0.9
    assert growth(finer, 1.5 * limit) > 10


def test_recomputing_costs_the_stability_of_few_contacts_and_interpolating_does_not(
    tread_layers: list[Layer], kernel: Kernel
) -> None:
    """A finer step asks a single element at frequencies where it, too, is a mass.

    So a road that has only begun to touch blows up earlier, although full contact bears more.
    """
    finer = band_limited(tread_layers, SHAPE, 1e-3, STEP / 2, 128)
    for few in ((1, 1), (2, 2)):
        assert critical_stiffness(kernel, few) > 5 * critical_stiffness(finer, few)
        assert critical_stiffness(interpolated(kernel, 2), few) == np.inf
    assert critical_stiffness(finer, SHAPE) > 2 * critical_stiffness(kernel, SHAPE)


@pytest.mark.parametrize("stiffness", [1e4, 1e6, 1e9])
@pytest.mark.parametrize("method", ["BDF1", "BDF2", "mobility"])
def test_passive_kernels_ring_down_on_any_spring(
    tread_layers: list[Layer], method: str, stiffness: float
) -> None:
    settings = (tread_layers, SHAPE, 1e-3, STEP, 64)
    mobility = method == "mobility"
    kernel = passive_mobility(*settings) if mobility else passive(*settings, method)
    assert growth(kernel, stiffness, steps=400) < 0.3


def test_the_margin_of_a_step_vanishes_where_the_springs_are_critical(kernel: Kernel) -> None:
    """1 + lambda_min(K^1/2 H K^1/2) / (1 - cos theta) at the critical angle, K equal springs."""
    theta, critical = critical_angle(kernel), critical_stiffness(kernel, SHAPE)
    matrix = between(hermitian_symbol(kernel, theta))
    margin = 1 + critical * np.linalg.eigvalsh(matrix)[0] / (1 - np.cos(theta))
    assert margin == pytest.approx(0, abs=1e-9)  # rounding
