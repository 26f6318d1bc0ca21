"""What time steps and lags do to the answer: orders of convergence, and nothing."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from tyrecontact.contact.lattice import History, LatticeKernel
from tyrecontact.tread.elements import ElementLattice
from tyrecontact.tread.kernels import Kernel, band_limited, passive
from tyrecontact.tread.materials import Layer
from tyrecontact.tread.plate import surface_compliance

Matrix = Callable[[np.ndarray], np.ndarray]
SIDE, STEP = 1e-3, 1 / 51200
DURATION = 24 * STEP


def pulse(time: np.ndarray) -> np.ndarray:
    """A smooth force of 0.5 ms [N], as the sum of a few frequencies."""
    return np.where((time > 0) & (time < DURATION), np.sin(np.pi * time / DURATION) ** 6, 0.0)


@pytest.fixture(scope="module")
def exact(tread_layers: list[Layer]) -> np.ndarray:
    """Displacement [m] of an element under its own pulse at 40 steps, by Fourier's integral.

    No quadrature in time: the spectrum of the force times the compliance at s = a + 2 pi i f,
    over a period in which exp(-a t) forgets the plate's creep.
    """
    fine, period, count = 16, 256 * STEP, 500
    decay = 16 / period
    time = np.arange(256 * fine) * STEP / fine
    spectrum = np.fft.rfft(pulse(time) * np.exp(-decay * time))[:count]
    s = decay + 2j * np.pi * np.arange(count) / period
    thickness = sum(layer.thickness for layer in tread_layers)
    lattice = ElementLattice.around((1, 1), SIDE, thickness)
    k = lattice.wavenumbers[:, None]
    compliance = lattice.kernel(surface_compliance(k, s[None, :], tread_layers))[:, 0, 0]
    found = np.fft.irfft(np.pad(spectrum * compliance, (0, 128 * fine + 1 - count)), n=time.size)
    return (found * np.exp(decay * time))[: 40 * fine : fine]


@pytest.mark.parametrize(("quadrature", "order"), [("BDF1", 1), ("BDF2", 2)])
def test_quadratures_converge_to_fouriers_integral_at_their_order(
    tread_layers: list[Layer], exact: np.ndarray, quadrature: str, order: int
) -> None:
    errors = []
    for factor in (1, 2, 4):
        kernel = passive(tread_layers, (1, 1), SIDE, STEP / factor, 54 * factor, quadrature)
        force = pulse(np.arange(40 * factor) * STEP / factor)
        found = np.convolve(force, kernel.values[:, 0, 0])[: 40 * factor : factor]
        errors.append(np.abs(found - exact).max() / np.abs(exact).max())
    orders = [np.log2(coarse / fine) for coarse, fine in pairwise(errors)]
    # what is left is the next order
    np.testing.assert_allclose(orders, order, atol=0.12)
    assert errors[-1] < {1: 1e-2, 2: 1e-3}[order]


def displacement(kernel: Kernel, force: np.ndarray, matrix: Matrix) -> np.ndarray:
    """Displacement of all elements under their forces, both (steps, ny, nx)."""
    history, instant = History(LatticeKernel(kernel)), matrix(kernel.values[0])
    found = np.zeros_like(force)
    for n, now in enumerate(force):
        found[n] = history.displacement() + (instant @ now.ravel()).reshape(now.shape)
        history.remember(now)
    return found


@pytest.mark.parametrize("method", [passive, band_limited])
def test_lags_beyond_the_tail_change_nothing(
    tread_layers: list[Layer], element_matrix: Matrix, method: Callable[..., Kernel]
) -> None:
    """500 steps of forces that come and go slowly, on kernels of 1.25, 2.5 and 5 ms.

    What differs is the creep that is still to come after the last lag: 1 % of all.
    """
    rng = np.random.default_rng(5)
    walk = np.cumsum(rng.standard_normal((500, 2, 2)), axis=0)
    force = np.abs(walk - walk.mean(axis=0))
    few, many, most = (
        displacement(method(tread_layers, (2, 2), SIDE, STEP, lags), force, element_matrix)
        for lags in (64, 128, 256)
    )
    scale = np.abs(most).max()
    assert np.abs(many - most).max() < 1e-2 * scale
    assert np.abs(many - most).max() < np.abs(few - most).max()


@pytest.mark.parametrize("quadrature", ["BDF1", "BDF2"])
def test_a_force_that_stays_ends_in_the_statics_whatever_the_step(
    tread_layers: list[Layer], element_matrix: Matrix, quadrature: str
) -> None:
    ends = []
    for lags, step in ((32, STEP), (64, STEP), (64, STEP / 2)):
        kernel = passive(tread_layers, (2, 2), SIDE, step, lags, quadrature)
        ends.append(displacement(kernel, np.ones((lags + 1, 2, 2)), element_matrix)[-1])
    np.testing.assert_allclose(ends[1:], [ends[0]] * 2, rtol=1e-6)  # rounding on the contour
