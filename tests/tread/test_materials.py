"""Moduli: their anchors, causality, losses; layers: what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.tread.materials import (
    FractionalKelvinVoigt,
    FractionalZener,
    Layer,
    Modulus,
    NearlyConstantLoss,
)

MODULI = [
    FractionalKelvinVoigt(),
    FractionalZener(),
    FractionalZener(5e6, 1e9, 1e-7, 0.4),
    NearlyConstantLoss(72e9, 0.03),
]


def dynamic(modulus: Modulus, frequency: float | np.ndarray) -> np.ndarray:
    return modulus(2j * np.pi * np.asarray(frequency))


@pytest.mark.parametrize(("frequency", "loss_factor"), [(10.0, 0.005), (50e3, 0.55)])
def test_the_tread_meets_the_thesis_loss_factors(frequency: float, loss_factor: float) -> None:
    modulus = complex(dynamic(FractionalKelvinVoigt(), frequency))
    # tau and alpha are given to four digits
    assert modulus.imag / modulus.real == pytest.approx(loss_factor, rel=1e-3)


@pytest.mark.parametrize(("frequency", "storage"), [(1e3, 26.5e6), (1e4, 30.9e6), (5e4, 40.8e6)])
def test_the_tread_stiffens_as_specified(frequency: float, storage: float) -> None:
    modulus = complex(dynamic(FractionalKelvinVoigt(), frequency))
    assert modulus.real == pytest.approx(storage, abs=0.05e6)  # printed to 0.1 MPa


@pytest.mark.parametrize("loss_factor", [5e-5, 0.01, 0.09])
def test_a_nearly_constant_loss_is_nearly_constant(loss_factor: float) -> None:
    modulus = dynamic(NearlyConstantLoss(72e9, loss_factor), np.geomspace(100, 5e4, 50))
    # E' rises by (2 eta / pi) ln(f / 1 Hz), up to 6.9 eta: the law is the first order in eta
    allowed = 0.007 + 7 * loss_factor
    np.testing.assert_allclose(modulus.imag / modulus.real, loss_factor, rtol=allowed)


def test_without_loss_the_modulus_is_a_constant() -> None:
    modulus = dynamic(NearlyConstantLoss(72e9), np.geomspace(1, 1e5, 9))
    np.testing.assert_array_equal(modulus, 72e9)


def test_a_zener_solid_is_half_way_where_s_tau_is_one_and_glassy_at_the_end() -> None:
    zener = FractionalZener(25e6, 50e6, 1e-5, 0.6)
    assert complex(zener(np.array(1e5))) == pytest.approx(37.5e6)
    # (s tau)^-0.6 of the rise is still to come
    assert complex(zener(np.array(1e25))) == pytest.approx(50e6, rel=1e-11)
    assert zener(np.array(1e3)).real < FractionalKelvinVoigt(25e6, 1e-5, 0.6)(np.array(1e3)).real


@pytest.mark.parametrize("modulus", MODULI)
def test_at_rest_the_modulus_is_the_static_one(modulus: Modulus) -> None:
    assert complex(modulus(np.zeros(()))) == pytest.approx(modulus.static_modulus)


@pytest.mark.parametrize("modulus", MODULI)
def test_real_histories_stay_real(modulus: Modulus) -> None:
    """E(s*) = E(s)*, real on the real axis: the relaxation function is real."""
    s = np.array([3.0 + 4j, 1e5 - 2e4j, 2e4j])
    np.testing.assert_allclose(modulus(s.conj()), modulus(s).conj(), rtol=1e-14)
    assert np.all(np.imag(modulus(np.array([1.0, 1e3, 1e6]))) == 0)


@pytest.mark.parametrize("modulus", MODULI)
def test_losses_are_losses_and_stiffness_rises(modulus: Modulus) -> None:
    values = dynamic(modulus, np.geomspace(1e-2, 1e6, 200))
    assert np.all(values.imag > 0)
    assert np.all(np.diff(values.real) > 0)


@pytest.mark.parametrize("modulus", MODULI)
def test_storage_and_loss_obey_kramers_and_kronig(modulus: Modulus) -> None:
    """E'(w) - E'(0) = (2 / pi) P int E''(x) w^2 / (w^2 - x^2) d(ln x): E is causal.

    Folded about x = w, where the two sides of the principal value cancel.
    """
    w, step = 1e4, 0.01
    octave = (np.arange(6000) + 0.5) * step
    below, above = (np.imag(modulus(1j * w * np.exp(sign * octave))) for sign in (-1, 1))
    integrand = (below + above + (below - above) / np.tanh(octave)) / 2
    rise = float(np.real(modulus(np.array(1j * w)) - modulus(np.zeros(()))))
    # midpoint rule of second order in the step
    assert 2 / np.pi * integrand.sum() * step == pytest.approx(rise, rel=1e-4)


@pytest.mark.parametrize(
    ("kind", "settings", "name"),
    [
        (FractionalKelvinVoigt, {"static_modulus": 0.0}, "static_modulus"),
        (FractionalKelvinVoigt, {"relaxation_time": np.nan}, "relaxation_time"),
        (FractionalKelvinVoigt, {"exponent": 1.1}, "exponent"),
        (FractionalZener, {"static_modulus": -1.0}, "static_modulus"),
        (FractionalZener, {"glassy_modulus": np.nan}, "glassy_modulus"),
        (FractionalZener, {"glassy_modulus": 2e7}, "glassy_modulus must be at least .* 2.5e.07 Pa"),
        (FractionalZener, {"relaxation_time": 0.0}, "relaxation_time"),
        (FractionalZener, {"exponent": np.nan}, "exponent"),
        (NearlyConstantLoss, {"static_modulus": np.inf}, "static_modulus"),
        (NearlyConstantLoss, {"static_modulus": 1e9, "loss_factor": -0.01}, "loss_factor"),
        (NearlyConstantLoss, {"static_modulus": 1e9, "loss_factor": np.nan}, "loss_factor"),
    ],
)
def test_impossible_moduli_are_refused(kind: type, settings: dict, name: str) -> None:
    with pytest.raises(InputError, match=name):
        kind(**settings)


@pytest.mark.parametrize(
    ("thickness", "density", "poissons_ratio", "name"),
    [(0.0, 1300, 0.4, "thickness"), (0.01, -1.0, 0.4, "density"), (np.nan, 1300, 0.4, "thickness"),
     (0.01, 1300, 0.5, "poissons_ratio"), (0.01, 1300, -1.0, "poissons_ratio"),
     (0.01, 1300, np.nan, "poissons_ratio")],
)  # fmt: skip
def test_impossible_layers_are_refused(
    thickness: float, density: float, poissons_ratio: float, name: str
) -> None:
    with pytest.raises(InputError, match=name):
        Layer(thickness, density, FractionalKelvinVoigt(), poissons_ratio)


def test_wave_speeds_and_shear_modulus_follow_from_poissons_ratio() -> None:
    layer = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.25)
    assert layer.wave_speed_ratio_squared == pytest.approx(1 / 3)  # c_p^2 = 3 c_s^2
    assert complex(layer.shear_modulus(np.zeros(()))) == pytest.approx(10e6)  # E / 2.5
