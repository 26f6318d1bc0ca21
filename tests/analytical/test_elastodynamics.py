"""Kernels in time against closed forms of waves: reverberation in a layer, and Lamb's problem."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from tyrecontact.tread.elements import ElementLattice
from tyrecontact.tread.kernels import passive
from tyrecontact.tread.materials import Layer

MakeLayer = Callable[[float, float], Layer]
MODULUS, DENSITY = 25e6, 1300.0


def smooth_step(time: np.ndarray, rise: float) -> np.ndarray:
    """From 0 to 1 in `rise`, with three derivatives."""
    x = np.clip(time / rise, 0, 1)
    return x**4 * (35 - 84 * x + 70 * x**2 - 20 * x**3)


def rate_of_step(time: np.ndarray, rise: float) -> np.ndarray:
    x = np.clip(time / rise, 0, 1)
    return 140 * (x * (1 - x)) ** 3 / rise


def integral_of_step(time: np.ndarray, rise: float) -> np.ndarray:
    x = np.clip(time / rise, 0, 1)
    within = x**5 * (7 - 14 * x + 10 * x**2 - 2.5 * x**3)
    return rise * (within + np.maximum(time / rise - 1, 0))


def test_the_step_and_its_integral_belong_together() -> None:
    time = np.linspace(-0.1, 2, 20001)
    step = time[1] - time[0]
    slope = np.gradient(integral_of_step(time, 1.3), step)
    np.testing.assert_allclose(slope, smooth_step(time, 1.3), atol=1e-6)
    slope = np.gradient(smooth_step(time, 1.3), step)
    np.testing.assert_allclose(slope, rate_of_step(time, 1.3), atol=1e-6)


def under_uniform_pressure(layer: Layer, time_step: float, lags: int) -> np.ndarray:
    """Displacement impulse by impulse [m/Pa], all elements of the periodic lattice loaded."""
    side, elements = layer.thickness / 2, 31
    period = ElementLattice.around((elements, elements), side, layer.thickness).period
    half = period // 2 + 1
    assert half <= elements
    kernel = passive([layer], (elements, elements), side, time_step, lags)
    count = np.full(half, 2.0)
    count[[0, -1]] = 1.0
    return side**2 * np.einsum("nij,i,j->n", kernel.values[:, :half, :half], count, count)


@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3])
def test_waves_reverberate_in_a_layer_on_a_rigid_base(
    elastic_layer: MakeLayer, poissons_ratio: float
) -> None:
    """u(t) = (1 / rho c) [I(t) - 2 I(t - 2T) + 2 I(t - 4T) - ..], I the impulse, T = h / c.

    From tanh(s T) / (rho c s), echo by echo; without losses nothing hides an error. It falls
    with the square of the time step.
    """
    layer = elastic_layer(0.01, poissons_ratio)
    constrained = (1 - poissons_ratio) / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))
    speed = np.sqrt(constrained * MODULUS / DENSITY)
    transit, lags = 0.01 / speed, 180
    errors = []
    for factor in (1, 2, 4):
        time_step = transit / 16 / factor
        time = time_step * np.arange(1, 128 * factor)  # four echoes, before the kernel's tail
        pressure = smooth_step(time, 1.5 * transit)
        response = under_uniform_pressure(layer, time_step, lags * factor)
        found = np.convolve(pressure, response)[: time.size]
        echoes = [(-1) ** m * (2 - (m == 0)) for m in range(5)]
        expected = sum(
            sign * integral_of_step(time - 2 * m * transit, 1.5 * transit)
            for m, sign in enumerate(echoes)
        ) / (DENSITY * speed)
        errors.append(np.abs(found - expected).max() / np.abs(expected).max())
    assert errors[-1] < 5e-3
    # the order is on its way: 3.6, 3.8
    assert all(coarse / fine == pytest.approx(4, rel=0.15) for coarse, fine in pairwise(errors))


def pekeris(tau: np.ndarray) -> np.ndarray:
    """pi mu r x surface displacement under a unit step of a point load, nu = 1/4; tau = c_s t / r.

    C. L. Pekeris, Proc. Nat. Acad. Sci. 41 (1955) 469-480; H. M. Mooney, Bull. Seism. Soc. Am.
    64 (1974) 473-491.
    """
    root, rayleigh = np.sqrt(3), np.sqrt(3 + np.sqrt(3)) / 2
    with np.errstate(invalid="ignore", divide="ignore"):
        before = np.sqrt(3 * root + 5) / np.sqrt(3 / 4 + root / 4 - tau**2)
        p_wave = 6 - root / np.sqrt(tau**2 - 1 / 4) - before
        p_wave = (p_wave + np.sqrt(3 * root - 5) / np.sqrt(tau**2 + root / 4 - 3 / 4)) / 32
        s_wave = (6 - before) / 16
    conditions = [tau <= 1 / root, tau <= 1, tau < rayleigh]
    return np.select(conditions, [np.zeros_like(tau), p_wave, s_wave], 3 / 8)


def lambs_response(
    time: np.ndarray, distance: float, rise: float, shear_speed: float
) -> np.ndarray:
    """pi mu x mean displacement of a unit element a `distance` off, under a smooth step."""
    # the distances between points of two squares: triangles of side 1 in x and in y
    node, weight = np.polynomial.legendre.leggauss(10)
    node, weight = (node + 1) / 2, weight / 2 * (1 - (node + 1) / 2)
    offset, share = np.concatenate([-node, node]), np.concatenate([weight, weight])
    r = np.hypot(distance + offset[:, None], offset[None, :]).ravel()
    share = np.outer(share, share).ravel()
    fine = np.linspace(0, time[-1], 6001)
    fine = (fine[1:] + fine[:-1]) / 2
    width = time[-1] / 6000
    step_response = share @ (pekeris(shear_speed * fine / r[:, None]) / r[:, None])
    return np.array([width * rate_of_step(t - fine, rise) @ step_response for t in time])


def test_lambs_half_space_answers_with_p_s_and_rayleigh_waves(elastic_layer: MakeLayer) -> None:
    """A layer too deep for an echo, under a load on one element, ten elements away.

    Nothing arrives before r / c_p; up to r / c_R the surface heaves; then it rests, 3/8 down.
    Lengths in elements.
    """
    side, depth, rise = 1e-3, 15, 5.0
    layer = elastic_layer(depth * side, 0.25)
    shear_modulus = MODULUS / 2.5
    shear_speed = np.sqrt(shear_modulus / DENSITY)
    time_step, steps = 0.05, 330  # in elements / c_s; P comes back from the base at 17.6
    kernel = passive([layer], (1, 11), side, time_step * side / shear_speed, 4 * steps // 3 + 1)
    time = time_step * np.arange(1, steps + 1)
    force = smooth_step(time, rise)
    scale = np.pi * shear_modulus * side
    for distance in (6, 10):
        found = scale * np.convolve(force, kernel.values[:, 0, distance])[:steps]
        expected = lambs_response(time, distance, rise, 1.0)
        assert expected.min() * distance < -0.02
        # 0.6 % of what stays, about the steep wave of Rayleigh: 0.2 % at half the time step
        np.testing.assert_allclose(found * distance, expected * distance, atol=0.01 * 3 / 8)
        early = time < (distance - 1) / np.sqrt(3)  # the nearest points of two elements
        assert np.abs(found[early]).max() * distance < 1e-3 * 3 / 8
