"""The power that a kernel draws, by frequency, and the frequency at which it draws least."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.tread.kernels import (
    Kernel,
    band_limited,
    critical_angle,
    critical_stiffness,
    hermitian_symbol,
    interpolated,
    passive,
)
from tyrecontact.tread.materials import Layer

Matrix = Callable[[np.ndarray], np.ndarray]


def strictest(kernel: Kernel, matrix: Matrix, angles: np.ndarray) -> np.ndarray:
    """lambda_min(H(theta)) / (1 - cos theta), from the definition."""
    compliance, lag = matrix(kernel.values), np.arange(kernel.lags)
    lowest = []
    for theta in angles:
        transform = np.tensordot(np.exp(-1j * theta * lag), compliance, axes=1)
        power = (1 - np.exp(-1j * theta)) * transform
        lowest.append(np.linalg.eigvalsh((power + power.conj().T) / 2)[0])
    return np.array(lowest) / (1 - np.cos(angles))


@pytest.mark.parametrize("theta", [0.1, 1.0, np.pi])
def test_the_symbol_generates_the_hermitian_part(
    passive_kernel: Kernel, element_matrix: Matrix, theta: float
) -> None:
    found = np.linalg.eigvalsh(element_matrix(hermitian_symbol(passive_kernel, theta)))[0]
    expected = strictest(passive_kernel, element_matrix, np.array([theta]))[0]
    # rounding, against the kernel's size
    assert found == pytest.approx(expected * (1 - np.cos(theta)), abs=1e-13 * 2e-5)


def test_the_symbol_at_the_nyquist_frequency_alternates(band_limited_kernel: Kernel) -> None:
    alternating = (-1.0) ** np.arange(band_limited_kernel.lags)
    expected = 2 * np.tensordot(alternating, band_limited_kernel.values, axes=1)
    found = hermitian_symbol(band_limited_kernel, np.pi)
    np.testing.assert_allclose(found, expected, atol=1e-13 * np.abs(expected).max())  # rounding


def test_symbols_of_many_angles_come_at_once(passive_kernel: Kernel) -> None:
    angles = np.array([[0.5, 1.0], [2.0, np.pi]])
    symbols = hermitian_symbol(passive_kernel, angles)
    assert symbols.shape == (2, 2, 4, 4)
    for place in np.ndindex(2, 2):
        single = hermitian_symbol(passive_kernel, angles[place])
        np.testing.assert_allclose(symbols[place], single, atol=1e-18)  # rounding


def test_a_static_kernel_draws_the_same_at_every_angle(static_kernel: Kernel) -> None:
    np.testing.assert_allclose(
        hermitian_symbol(static_kernel, 1.0), (1 - np.cos(1.0)) * static_kernel.values[0]
    )


def test_the_band_limited_kernel_is_worst_at_the_nyquist_frequency(
    band_limited_kernel: Kernel,
) -> None:
    assert critical_angle(band_limited_kernel) == np.pi


@pytest.mark.parametrize("factor", [2, 4])
def test_the_interpolated_kernel_is_worst_about_the_old_nyquist_frequency(
    band_limited_kernel: Kernel, element_matrix: Matrix, factor: int
) -> None:
    finer = interpolated(band_limited_kernel, factor)
    angle = critical_angle(finer)
    assert 0.5 * np.pi < angle * factor < 1.6 * np.pi
    least = strictest(finer, element_matrix, np.linspace(0.02, np.pi, 150)).min()
    # two grids of angles, on a curve that is flat about its least
    assert strictest(finer, element_matrix, np.array([angle]))[0] == pytest.approx(least, rel=0.03)


def test_a_passive_kernel_takes_power_even_at_its_worst_angle(
    passive_kernel: Kernel, element_matrix: Matrix
) -> None:
    angle = critical_angle(passive_kernel)
    assert 0 < angle <= np.pi
    assert strictest(passive_kernel, element_matrix, np.array([angle]))[0] > 0


def test_the_critical_stiffness_of_many_elements_is_that_of_their_matrix(
    layers: list[Layer], element_matrix: Matrix
) -> None:
    """26 x 25 elements are too many for a dense matrix; here it is taken all the same."""
    kernel = band_limited(layers, (26, 25), 1e-3, 1 / 51200, 32)
    alternating = np.tensordot((-1.0) ** np.arange(32), kernel.values, axes=1)
    expected = -1 / np.linalg.eigvalsh(element_matrix(alternating))[0]
    # Lanczos' method stops at 1e-4, which leaves the square of it in the eigenvalue
    assert critical_stiffness(kernel, (26, 25)) == pytest.approx(expected, rel=1e-6)


def test_a_finer_lattice_bears_the_same_stiffness_an_area(layers: list[Layer]) -> None:
    """Instability is of long waves: 5e10 N/m an m2, 5e4 N/m an element of 1 mm."""
    limits = []
    for elements in (10, 22):
        spacing = 10e-3 / elements
        kernel = band_limited(layers, (elements, elements), spacing, 1 / 51200, 64)
        limits.append(critical_stiffness(kernel, (elements, elements)) / spacing**2)
    assert limits[1] == pytest.approx(limits[0], rel=0.1)  # coarse elements at the rim


def test_many_elements_on_a_passive_kernel_are_stable(layers: list[Layer]) -> None:
    kernel = passive(layers, (26, 26), 1e-3, 1 / 51200, 64)
    assert critical_stiffness(kernel, (26, 26)) == np.inf
