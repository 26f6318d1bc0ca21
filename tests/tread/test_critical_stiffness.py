"""The stiffness at which time stepping turns unstable, and whether it does."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.tread.kernels import (
    Kernel,
    band_limited,
    critical_stiffness,
    interpolated,
    passive,
)
from tyrecontact.tread.materials import Layer

Matrix = Callable[[np.ndarray], np.ndarray]


def growth(kernel: Kernel, matrix: Matrix, stiffness: float, steps: int = 600) -> float:
    """Forces of linear springs on all elements, late over half-way, after a small kick.

    u_n = sum g_j F_(n-j), d = b - u, F = k d, with b a random pattern in the first step alone.
    """
    compliance = matrix(kernel.values)
    count = compliance.shape[-1]
    solve = np.linalg.inv(np.eye(count) + stiffness * compliance[0])
    force = np.zeros((steps, count))
    force[0] = solve @ (stiffness * 1e-9 * np.random.default_rng(0).standard_normal(count))
    lagged = np.concatenate(list(compliance[1:]), axis=1)
    for n in range(1, steps):
        past = force[max(0, n - kernel.lags + 1) : n][::-1].ravel()
        force[n] = -stiffness * solve @ (lagged[:, : past.size] @ past)
    # over a whole kernel each, so that an echo that comes once a kernel is in both
    half, late = (np.abs(force[end - kernel.lags : end]).max() for end in (steps // 2, steps))
    return float(late / half)


@pytest.mark.parametrize("share", [0.5, 0.97])
def test_forces_decay_below_the_critical_stiffness(
    band_limited_kernel: Kernel, element_matrix: Matrix, share: float
) -> None:
    critical = critical_stiffness(band_limited_kernel, (4, 4))
    assert growth(band_limited_kernel, element_matrix, share * critical) < 0.1


def test_forces_grow_above_the_critical_stiffness(
    band_limited_kernel: Kernel, element_matrix: Matrix
) -> None:
    critical = critical_stiffness(band_limited_kernel, (4, 4))
    assert growth(band_limited_kernel, element_matrix, 1.03 * critical) > 10


@pytest.mark.parametrize("stiffness", [1e4, 1e6, 1e9])
def test_the_passive_kernel_is_stable_on_any_spring(
    passive_kernel: Kernel, element_matrix: Matrix, stiffness: float
) -> None:
    assert critical_stiffness(passive_kernel, (4, 4)) == np.inf
    assert growth(passive_kernel, element_matrix, stiffness) < 1e-3


def test_the_passive_kernel_is_stable_at_finer_steps(
    layers: list[Layer], element_matrix: Matrix
) -> None:
    kernel = passive(layers, (4, 4), 1e-3, 1 / 204800, lags=256)
    assert critical_stiffness(kernel, (4, 4)) == np.inf


@pytest.mark.parametrize("stiffness", [1e5, 6e5, 1e7])
def test_no_spring_below_the_critical_one_is_unstable_after_interpolation(
    band_limited_kernel: Kernel, element_matrix: Matrix, stiffness: float
) -> None:
    """The oscillation is that of the coarse step: a quarter, not half, of the finer rate."""
    finer = interpolated(band_limited_kernel, 2)
    stable = growth(finer, element_matrix, stiffness) < 1
    assert stable or critical_stiffness(finer, (4, 4)) <= stiffness


def test_the_default_tread_in_full_contact(layers: list[Layer]) -> None:
    """20 x 20 elements at 51.2 kHz: about 5e4 N/m an element (physics, section 5)."""
    kernel = band_limited(layers, (20, 20), 1e-3, 1 / 51200)
    assert critical_stiffness(kernel, (20, 20)) == pytest.approx(5e4, rel=0.05)


def test_fewer_elements_bear_stiffer_springs(band_limited_kernel: Kernel) -> None:
    limits = [critical_stiffness(band_limited_kernel, shape) for shape in ((4, 4), (3, 4), (3, 3))]
    assert limits == sorted(limits)
    assert limits[0] < limits[-1]


def test_rows_and_columns_are_not_mixed_up() -> None:
    """Two elements side by side in x: eigenvalues of the Nyquist matrix are a + b and a - b."""
    values = np.zeros((2, 3, 2))
    values[0, 0] = [-1e-6, 4e-6]  # along x
    values[0, 1:, 0] = [-1e-6, 2e-6]  # along y
    kernel = Kernel(values, 1e-3, 1e-5)
    assert critical_stiffness(kernel, (1, 1)) == pytest.approx(1e6)
    assert critical_stiffness(kernel, (1, 2)) == pytest.approx(1 / 5e-6)
    assert critical_stiffness(kernel, (2, 1)) == pytest.approx(1 / 2e-6)
    lowest = np.linalg.eigvalsh([[-1, -1, 2], [-1, -1, -1], [2, -1, -1]])[0] * 1e-6
    assert critical_stiffness(kernel, (3, 1)) == pytest.approx(-1 / lowest)


@pytest.mark.parametrize("shape", [(0, 4), (4, 5), (5, 4)])
def test_a_shape_beyond_the_kernel_is_refused(
    passive_kernel: Kernel, shape: tuple[int, int]
) -> None:
    with pytest.raises(InputError, match="shape must lie within"):
        critical_stiffness(passive_kernel, shape)
