"""Surface compliance against closed forms: half-space, bonded layer, oedometer, waves."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer
from tyrecontact.tread.plate import surface_compliance

MODULUS, THICKNESS = 25e6, 0.01
MakeLayer = Callable[[float, float], Layer]


def half_space(wavenumber: np.ndarray, poissons_ratio: float) -> np.ndarray:
    return 2 * (1 - poissons_ratio**2) / (MODULUS * wavenumber)


def layer_function(u: np.ndarray, poissons_ratio: float) -> np.ndarray:
    """L(u) of a layer bonded to a rigid base, numerator and denominator times exp(-2 u)."""
    k0, decay = 3 - 4 * poissons_ratio, np.exp(-2 * u)
    numerator = k0 * (1 - decay**2) - 4 * u * decay
    return numerator / (k0 * (1 + decay**2) + (4 * u**2 + 1 + k0**2) * decay)


def constrained_modulus(modulus: complex, poissons_ratio: float) -> complex:
    return modulus * (1 - poissons_ratio) / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio))


@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3, 0.499])
def test_short_waves_feel_a_half_space(elastic_layer: MakeLayer, poissons_ratio: float) -> None:
    k = np.array([30.0, 100, 1e4, 1e7]) / THICKNESS
    compliance = surface_compliance(k, 0.0, [elastic_layer(THICKNESS, poissons_ratio)])
    # the base is felt as exp(-2 k h), nil at k h = 30: rounding is what is left
    np.testing.assert_allclose(compliance, half_space(k, poissons_ratio), rtol=1e-12)


@pytest.mark.parametrize("poissons_ratio", [-0.2, 0.0, 0.25, 0.45, 0.499])
def test_a_layer_at_rest_is_the_half_space_times_l(
    elastic_layer: MakeLayer, poissons_ratio: float
) -> None:
    u = np.geomspace(1e-2, 100, 80)
    compliance = surface_compliance(u / THICKNESS, 0.0, [elastic_layer(THICKNESS, poissons_ratio)])
    expected = half_space(u / THICKNESS, poissons_ratio) * layer_function(u, poissons_ratio)
    # the closed form cancels as u^-2 and the recursion as u^-3: 1e-16 x 1e6
    np.testing.assert_allclose(compliance, expected, rtol=1e-10)


def test_uniform_rest_is_an_oedometer(elastic_layer: MakeLayer) -> None:
    upper, lower = elastic_layer(0.01, 0.499), elastic_layer(0.004, 0.3)
    one = 0.01 / constrained_modulus(MODULUS, 0.499)
    two = one + 0.004 / constrained_modulus(MODULUS, 0.3)
    assert complex(surface_compliance(0.0, 0.0, [upper])) == pytest.approx(one, rel=1e-12)
    assert complex(surface_compliance(0.0, 0.0, [upper, lower])) == pytest.approx(two, rel=1e-12)


@pytest.mark.parametrize("poissons_ratio", [0.0, 0.3, 0.499])
def test_uniform_pressure_sends_plane_waves_into_one_layer(poissons_ratio: float) -> None:
    """C = tanh(s h / c_p) / (rho c_p s), losses included."""
    modulus, density = FractionalKelvinVoigt(), 1300.0
    s = np.concatenate([2j * np.pi * np.geomspace(10, 1e5, 40), [300.0, 1e5, 3e4 + 1e5j]])
    speed = np.sqrt(constrained_modulus(modulus(s), poissons_ratio) / density)
    expected = np.tanh(s / speed * THICKNESS) / (density * speed * s)
    layer = Layer(THICKNESS, density, modulus, poissons_ratio)
    # rounding, times the 1e3 by which nu = 0.499 sets P and S apart
    np.testing.assert_allclose(surface_compliance(0.0, s, [layer]), expected, rtol=1e-11)


def test_uniform_pressure_sends_plane_waves_into_two_layers() -> None:
    """Impedances in series, as in a transmission line that is shorted at its end."""
    upper = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.4)
    lower = Layer(0.003, 2700, FractionalKelvinVoigt(9e7, 1e-6, 0.5), 0.33)
    s = 2j * np.pi * np.geomspace(100, 1e5, 40)
    tangent, impedance = [], []
    for layer in (upper, lower):
        modulus = constrained_modulus(layer.modulus(s), layer.poissons_ratio)
        speed = np.sqrt(modulus / layer.density)
        tangent.append(np.tanh(s / speed * layer.thickness))
        impedance.append(layer.density * speed)
    below = tangent[1] / impedance[1]  # velocity per pressure on top of the lower layer
    mobility = (below + tangent[0] / impedance[0]) / (1 + impedance[0] * tangent[0] * below)
    compliance = surface_compliance(0.0, s, [upper, lower])
    np.testing.assert_allclose(compliance, mobility / s, rtol=1e-11)  # rounding


def test_surface_waves_travel_at_rayleighs_speed(elastic_layer: MakeLayer) -> None:
    """At nu = 1/4, (c_R / c_s)^2 = 2 - 2 / sqrt(3): there the surface needs no pressure."""
    layer = elastic_layer(THICKNESS, 0.25)
    shear_speed = np.sqrt(MODULUS / 2.5 / layer.density)
    k = 60 / THICKNESS  # deep: the layer is a half-space to exp(-2 x 0.39 x 60)

    def pressure(share: float) -> float:
        return float(np.real(1 / surface_compliance(k, 1j * share * shear_speed * k, [layer])))

    assert pressure(0.90) > 0 > pressure(0.94)
    speed = brentq(pressure, 0.90, 0.94, xtol=1e-13)
    assert speed == pytest.approx(np.sqrt(2 - 2 / np.sqrt(3)), rel=1e-10)
