"""Energy is never created by the tread: in the transform, and step by step."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.tread.kernels import Kernel, passive
from tyrecontact.tread.materials import Layer

Matrix = Callable[[np.ndarray], np.ndarray]
ANGLES = np.concatenate([np.geomspace(1e-4, 0.1, 20), np.linspace(0.1, np.pi, 120)])


def lowest_power(kernel: Kernel, matrix: Matrix) -> float:
    """Least eigenvalue of Herm[(1 - e^-i theta) G(e^i theta)] over that of the statics."""
    phase = np.exp(-1j * np.outer(ANGLES, np.arange(kernel.lags)))
    factor = ((1 - np.exp(-1j * ANGLES))[:, None] * phase).real  # g is real, even: no imaginary
    power = matrix(np.tensordot(factor, kernel.values, axes=1))
    scale = np.linalg.eigvalsh(matrix(kernel.static_compliance))[-1]
    return float(np.linalg.eigvalsh(power).min() / scale)


def work(kernel: Kernel, matrix: Matrix, force: np.ndarray) -> np.ndarray:
    """Work done on the tread up to each step [J]; `force` (steps, elements), at rest before."""
    compliance = matrix(kernel.values)
    displacement = np.zeros_like(force)
    for n in range(len(force)):
        for j in range(min(n + 1, kernel.lags)):
            displacement[n] += compliance[j] @ force[n - j]
    increments = np.diff(displacement, axis=0, prepend=0)
    return np.cumsum((force * increments).sum(axis=1))


def alternating(kernel: Kernel, matrix: Matrix, steps: int) -> np.ndarray:
    """Forces that change sign every step, in the pattern the kernel resists least."""
    sign = (-1.0) ** np.arange(kernel.lags)
    vectors = np.linalg.eigh(matrix(np.tensordot(sign, kernel.values, axes=1)))[1]
    return (-1.0) ** np.arange(steps)[:, None] * vectors[:, 0]


def test_the_passive_kernel_takes_power_at_every_frequency(
    passive_kernel: Kernel, element_matrix: Matrix
) -> None:
    assert lowest_power(passive_kernel, element_matrix) >= -1e-12  # rounding


def test_the_passive_kernel_stays_passive_at_finer_steps(
    tread_layers: list[Layer], element_matrix: Matrix
) -> None:
    kernel = passive(tread_layers, (8, 8), 1e-3, 1 / 204800, lags=256)
    assert lowest_power(kernel, element_matrix) >= -1e-12  # rounding


def test_the_band_limited_kernel_gives_power_back(
    band_limited_kernel: Kernel, element_matrix: Matrix
) -> None:
    assert lowest_power(band_limited_kernel, element_matrix) < -0.1


@pytest.mark.parametrize("seed", range(4))
def test_no_history_of_forces_draws_energy_from_a_passive_tread(
    passive_kernel: Kernel, element_matrix: Matrix, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    force = rng.standard_normal((100, 64)) * rng.random((100, 1)) ** 4
    energy = work(passive_kernel, element_matrix, force)
    assert energy.min() >= -1e-12 * np.abs(energy).max()  # rounding


def test_alternating_forces_draw_energy_from_a_band_limited_tread_alone(
    passive_kernel: Kernel, band_limited_kernel: Kernel, element_matrix: Matrix
) -> None:
    force = alternating(band_limited_kernel, element_matrix, steps=120)
    assert work(passive_kernel, element_matrix, force).min() >= 0
    drawn = work(band_limited_kernel, element_matrix, force)
    assert drawn[-1] < 0
    # once the first lags have passed, every pair of steps draws the same
    assert drawn[-1] - drawn[-21] == pytest.approx(drawn[-21] - drawn[-41], rel=0.01)
