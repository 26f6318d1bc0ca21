"""Spectra: conventions, Parseval, and the way from a profile to an isotropic surface."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import spectrum, textures

PITCH = 5e-5


def test_a_power_law_comes_out_of_its_profile_in_closed_form() -> None:
    """S2 = f^-4 has S1 = (pi/2) fx^-3: 2 int_fx f^-3 / sqrt(f^2 - fx^2) df."""
    frequency = np.geomspace(20, 20_000, 3000)
    found = spectrum.isotropic(frequency, np.pi / 2 * frequency**-3)
    inner = np.geomspace(40, 5000, 30)
    # rings of a third of an octave are flat where f^-4 falls by 2.5; the last see no end of it
    np.testing.assert_allclose(found.at(inner), inner**-4, rtol=0.2)


def test_the_matrix_is_the_transform_of_a_disc() -> None:
    """S2 = 1 below f1: S1 = 2 sqrt(f1^2 - fx^2), which a sum over its rings must give."""
    edges = np.geomspace(10, 1000, 30)
    frequency = np.array([10.0, 55.0, 300.0, 990.0, 1001.0])
    found = spectrum.abel_matrix(frequency, edges).sum(axis=1)
    expected = 2 * np.sqrt(np.maximum(1000.0**2 - frequency**2, 0))
    np.testing.assert_allclose(found, expected, rtol=1e-12)  # a telescoping sum


def test_variance_is_the_integral_over_rings() -> None:
    rings = spectrum.Isotropic(np.array([10.0, 20.0, 40.0]), np.array([3.0, 1.0]))
    assert rings.variance == pytest.approx(np.pi * (3 * 300 + 1200))
    np.testing.assert_array_equal(rings.at(np.array([5.0, 50.0])), 0.0)


def test_a_profiles_spectrum_sums_to_its_variance() -> None:
    heights = np.random.default_rng(1).standard_normal(60_000)
    frequency, density = spectrum.of_profile(heights, PITCH, 0.02)
    # two-sided: half of the power is at negative frequencies. White, 75 windows: 2 %
    assert 2 * np.trapezoid(density, frequency) == pytest.approx(1.0, rel=0.04)
    np.testing.assert_allclose(density.mean(), PITCH, rtol=0.03)


def test_a_surfaces_spectrum_is_persson_s_times_four_pi_squared() -> None:
    """The convention trap: SurfaceTopography's C is S2, 4 pi^2 times Persson's C(q)."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a library's import
        library = pytest.importorskip("SurfaceTopography")
    count = 256
    grid = np.hypot(*np.meshgrid(*[np.fft.fftfreq(count, PITCH)] * 2))
    amplitude = 1e-5 * np.maximum(grid / 1000, 1.0) ** -1.8
    noise = np.random.default_rng(1).standard_normal((count, count))
    heights = np.fft.ifft2(np.fft.fft2(noise) * amplitude).real
    frequency, ours = spectrum.of_map(heights, PITCH)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        made = library.Topography(heights, (count * PITCH,) * 2, unit="m", periodic=True)
        q, theirs = made.power_spectrum_from_area()
    kept, waves = (frequency > 500) & (frequency < 8000), theirs > 0
    compared = np.interp(
        np.log(2 * np.pi * frequency[kept]), np.log(q[waves]), np.log(theirs[waves])
    )
    # other rings of random waves: a few per cent, against a factor of 39.5
    assert np.mean(np.log(ours[kept]) - compared) == pytest.approx(0, abs=0.1)
    # and both are what the surface was made with: |Z|^2 dx^2 / N^2
    exact = (1e-5 * PITCH * np.maximum(frequency / 1000, 1.0) ** -1.8) ** 2
    assert np.mean(np.log(ours / exact)[kept]) == pytest.approx(0, abs=0.1)
    persson = ours / (4 * np.pi**2)
    total = np.trapezoid(persson * (2 * np.pi) ** 2 * frequency * 2 * np.pi, frequency)
    # <z^2> = int C 2 pi q dq; the corners of the square beyond the last ring hold little
    assert total == pytest.approx(heights.var(), rel=0.1)


def test_a_surface_and_its_rows_agree_through_the_transform() -> None:
    """From rows of an isotropic surface to S2, against S2 measured on the surface itself."""
    road = textures.self_affine(40e-3, 1e-4, 1e-4, roll_off_wavelength=5e-3, seed=2)
    rows = [spectrum.of_profile(row, 1e-4, 10e-3) for row in road.heights]
    mean = np.mean([density for _, density in rows], axis=0)
    found = spectrum.isotropic(rows[0][0], mean)
    frequency, direct = spectrum.of_map(road.heights, 1e-4)
    kept = (frequency > 400) & (frequency < 3000)
    ratio = found.at(frequency[kept]) / direct[kept]
    assert np.exp(np.mean(np.log(ratio))) == pytest.approx(1, abs=0.15)
    assert np.abs(np.log(ratio)).max() < 0.5  # rings of a third of an octave on a steep spectrum


def test_what_has_no_spectrum_is_refused() -> None:
    with pytest.raises(InputError, match="at least 64 heights"):
        spectrum.of_profile(np.zeros(30), PITCH, 1.0)
    with pytest.raises(InputError, match="at least 8 waves"):
        spectrum.isotropic(np.arange(1.0, 20), np.zeros(19))
