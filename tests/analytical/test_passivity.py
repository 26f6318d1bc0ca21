"""Energy is never created by the tread: in the transform, and step by step."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.tread.kernels import Kernel, passive, passive_mobility, static
from tyrecontact.tread.materials import FractionalZener, Layer
from tyrecontact.tread.tabulated import APPENDIX_B

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


@pytest.fixture(scope="module")
def other_kernels(tread_layers: list[Layer]) -> dict[str, Kernel]:
    """Every other kernel that is meant to be passive, and other materials."""
    rest = ((5, 6), 1e-3, 1 / 51200)
    rubber, base = tread_layers
    zener = [Layer(0.01, 1300, FractionalZener(25e6, 5e8, 1e-7), 0.499), base]
    thin = [Layer(0.004, 1100, rubber.modulus, 0.45), rubber, base]
    tabulated = [Layer(0.01, 1300, APPENDIX_B, 0.499), base]
    return {
        "BDF1": passive(tread_layers, *rest, 64, "BDF1"),
        "Zener": passive(zener, *rest, 64),
        "three layers": passive(thin, *rest, 64),
        "mobility": passive_mobility(tread_layers, *rest, 128),
        "mobility of a table": passive_mobility(tabulated, *rest, 128),
        "static": static(tread_layers, *rest[:2]),
    }


NAMES = ["BDF1", "Zener", "three layers", "mobility", "mobility of a table", "static"]


@pytest.mark.parametrize("name", NAMES)
def test_other_passive_kernels_take_power_at_every_frequency(
    other_kernels: dict[str, Kernel], element_matrix: Matrix, name: str
) -> None:
    assert lowest_power(other_kernels[name], element_matrix) >= -1e-12  # rounding


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("kind", ["white", "bursts", "walk", "alternating"])
def test_no_history_draws_energy_from_them(
    other_kernels: dict[str, Kernel], element_matrix: Matrix, name: str, kind: str
) -> None:
    """sum F_n (u_n - u_(n-1)) >= 0, whatever the forces."""
    rng = np.random.default_rng(3)
    noise = rng.standard_normal((200, 30))
    forces = {
        "white": noise,
        "bursts": noise * (rng.random((200, 1)) < 0.1),
        "walk": np.cumsum(noise, axis=0),
        "alternating": alternating(other_kernels[name], element_matrix, 200),
    }
    energy = work(other_kernels[name], element_matrix, forces[kind])
    assert energy.min() >= -1e-12 * np.abs(energy).max()  # rounding


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
