"""Surface compliance of the plate: what must hold whatever the layers (tests/analytical: forms)."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss
from tyrecontact.tread.plate import surface_compliance

WAVENUMBER = np.concatenate([[0.0], np.geomspace(1, 3e4, 60)])[:, None]
FREQUENCY = 2j * np.pi * np.geomspace(10, 1e5, 40)


def test_compliance_broadcasts_wavenumber_against_frequency(layers: list[Layer]) -> None:
    table = surface_compliance(WAVENUMBER, FREQUENCY, layers)
    assert table.shape == (61, 40)
    one = surface_compliance(WAVENUMBER[7, 0], FREQUENCY[5], layers)
    assert complex(one) == pytest.approx(complex(table[7, 5]), rel=1e-13)  # summation order


@pytest.mark.parametrize("wavenumber", [0.0, 10.0, 500.0, 1e4])
def test_slow_loads_tend_to_rest(wavenumber: float) -> None:
    plate = [Layer(0.01, 1300, NearlyConstantLoss(25e6), 0.499)]
    at_rest = complex(surface_compliance(wavenumber, 0.0, plate))
    # inertia is of the second order: measured 4e-7 at most at s = 10 / s; then rounding
    for s, error in ((10.0, 1e-6), (1.0, 1e-8), (0.1, 1e-9)):
        slow = complex(surface_compliance(wavenumber, s, plate))
        assert slow == pytest.approx(at_rest, rel=error)


@pytest.mark.parametrize("wavenumber", [10.0, 500.0])
def test_inertia_is_felt_with_the_square_of_the_frequency(wavenumber: float) -> None:
    """Where P and S are all but one wave, the second order of C is still right to 1 %."""
    plate = [Layer(0.01, 1300, NearlyConstantLoss(25e6), 0.499)]
    s = np.array([0.0, 0.1, 1.0, 10.0])
    rest, *slow = surface_compliance(wavenumber, s, plate).real
    falls = [(rest - value) / frequency**2 for value, frequency in zip(slow, s[1:], strict=True)]
    # s = 0.1 / s lowers C by 4e-11 or 5e-12 of it: rounding leaves two digits or one
    np.testing.assert_allclose(falls[1:], falls[2], rtol=1e-3)
    np.testing.assert_allclose(falls[0], falls[2], rtol=0.1)


@pytest.mark.parametrize("cut", [0.5e-3, 5e-3, 9.9e-3])
def test_a_cut_through_a_layer_changes_nothing(layers: list[Layer], cut: float) -> None:
    rubber, base = layers
    upper = Layer(cut, rubber.density, rubber.modulus, rubber.poissons_ratio)
    lower = Layer(rubber.thickness - cut, rubber.density, rubber.modulus, rubber.poissons_ratio)
    whole = surface_compliance(WAVENUMBER, FREQUENCY, layers)
    parts = surface_compliance(WAVENUMBER, FREQUENCY, [upper, lower, base])
    # rounding, times the 1e6 by which base and rubber differ and k h = 0.01 cancels
    np.testing.assert_allclose(parts, whole, rtol=1e-8)


def test_a_layer_as_stiff_as_rock_is_a_rigid_base(layers: list[Layer]) -> None:
    rock = Layer(0.003, 2700, NearlyConstantLoss(1e16), 0.33)
    k = WAVENUMBER[10:]
    bonded = surface_compliance(k, FREQUENCY, layers[:1])
    # the stiffness of rock over that of rubber is 4e8
    np.testing.assert_allclose(
        surface_compliance(k, FREQUENCY, [layers[0], rock]), bonded, rtol=1e-5
    )


def test_the_plate_loses_energy_at_every_frequency(layers: list[Layer]) -> None:
    """Re(i w C) > 0: the power that a travelling pressure puts in."""
    compliance = surface_compliance(WAVENUMBER, FREQUENCY, layers)
    assert np.all(compliance.imag < 0)


def test_conjugate_frequencies_give_conjugate_compliances(layers: list[Layer]) -> None:
    s = np.array([1e3 + 2e4j, 5e4 + 1e5j])
    plus, minus = (surface_compliance(WAVENUMBER, x, layers) for x in (s, s.conj()))
    np.testing.assert_allclose(minus, plus.conj(), rtol=1e-9)  # rounding of a badly scaled 2 x 2


def test_decaying_loads_move_the_surface_with_them(layers: list[Layer]) -> None:
    """C is positive and falls with real s: energy function of a passive solid."""
    s = np.geomspace(1e2, 1e6, 30)
    compliance = surface_compliance(WAVENUMBER, s, layers)
    assert np.all(np.abs(compliance.imag) < 1e-8 * compliance.real)
    assert np.all(np.diff(compliance.real, axis=1) < 0)


def test_numbers_do_not_depend_on_the_units(layers: list[Layer]) -> None:
    """Millimetre, gram and millisecond: 1 Pa = 1e-6 g / (mm ms^2)."""
    scaled = [
        Layer(10.0, 1300e-6, FractionalKelvinVoigt(25.0, 3.717e-3), 0.499),
        Layer(3.0, 2700e-6, FractionalKelvinVoigt(72e3, 1e-4, 0.5), 0.33),
    ]
    si = [layers[0], Layer(0.003, 2700, FractionalKelvinVoigt(72e9, 1e-7, 0.5), 0.33)]
    compliance = surface_compliance(WAVENUMBER, FREQUENCY, si)
    in_mm = surface_compliance(WAVENUMBER * 1e-3, FREQUENCY * 1e-3, scaled)
    np.testing.assert_allclose(in_mm, compliance * 1e9, rtol=1e-8)  # rounding, as with the cut


@pytest.mark.parametrize("frequency", [0.0, 1e5, 1e6j])
def test_very_short_waves_neither_overflow_nor_vanish(
    layers: list[Layer], frequency: complex
) -> None:
    k = np.array([1e6, 1e8])  # exp(k h) would be exp(1e6)
    compliance = surface_compliance(k, frequency, layers)
    static = 2 * (1 - 0.499**2) / (layers[0].modulus(np.array(frequency)) * k)
    np.testing.assert_allclose(compliance, static, rtol=1e-3)  # (s / c_s k)^2 is what is left


@pytest.mark.parametrize("wavenumber", [-1.0, np.nan, np.inf])
def test_impossible_wavenumbers_are_refused(layers: list[Layer], wavenumber: float) -> None:
    with pytest.raises(InputError, match="wavenumber"):
        surface_compliance(np.array([1.0, wavenumber]), 0.0, layers)


def test_a_plate_of_no_layers_is_refused() -> None:
    with pytest.raises(InputError, match="at least one layer"):
        surface_compliance(1.0, 0.0, [])
