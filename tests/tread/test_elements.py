"""From C(k) to elements: an independent quadrature, the period, the units."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest

from tyrecontact.tread.elements import ElementLattice
from tyrecontact.tread.kernels import band_limited
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer
from tyrecontact.tread.plate import surface_compliance

SIDE = 1e-3
LAYER = Layer(5e-3, 1300, FractionalKelvinVoigt(), 0.45)
#: at rest, under a decaying load, and one that travels and decays
FREQUENCIES = [0.0, 2e4, 2e4 + 1e5j]
OFFSETS = [(0, 0), (0, 1), (1, 1), (3, 2)]


def element_kernel(lattice: ElementLattice, frequency: complex) -> np.ndarray:
    k = lattice.wavenumbers[:, None]
    return lattice.kernel(surface_compliance(k, np.array([[frequency]]), [LAYER]))[0]


def panels(edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gauss-Legendre rule of 20 nodes between neighbouring edges."""
    x, weight = np.polynomial.legendre.leggauss(20)
    width = np.diff(edges)[:, None]
    nodes = edges[:-1, None] + (x + 1) / 2 * width
    return nodes.ravel(), (weight * width / 2).ravel()


def by_quadrature(i: int, j: int, frequency: complex) -> complex:
    """The double integral in polar coordinates, with no period and no interpolation.

    The half-space's part, c / k, is a mean of 1/r in closed form. The rest decays as k^-3 (as
    exp(-2 k h) at rest), so that beyond k = 100 / side nothing is left of it.
    """
    k, weight = panels(np.linspace(0, 100 / SIDE, 121))
    angle, angle_weight = panels(np.linspace(0, np.pi / 2, 17))
    kx, ky = np.multiply.outer(k, np.cos(angle)), np.multiply.outer(k, np.sin(angle))
    load = (np.sinc(kx * SIDE / 2 / np.pi) * np.sinc(ky * SIDE / 2 / np.pi)) ** 2
    ring = (load * np.cos(kx * j * SIDE) * np.cos(ky * i * SIDE)) @ angle_weight
    c = 2 * (1 - LAYER.poissons_ratio**2) / complex(LAYER.modulus(np.array(frequency)))
    rest = surface_compliance(k, frequency, [LAYER]) - c / k
    half_space = c / (2 * np.pi * SIDE) * mean_inverse_distance(i, j)
    return complex(half_space + (weight * k * rest * ring).sum() / np.pi**2)


def mean_inverse_distance(i: int, j: int) -> float:
    """Mean of 1/r between two unit squares i and j sides apart."""

    def potential(x: float, y: float) -> float:
        x, y = max(abs(x), 1e-300), max(abs(y), 1e-300)
        both = x**2 * y * np.arcsinh(y / x) + x * y**2 * np.arcsinh(x / y)
        return float(both / 2 - np.hypot(x, y) ** 3 / 6)

    second = {-1: 1, 0: -2, 1: 1}
    return sum(second[p] * second[q] * potential(i + p, j + q) for p in second for q in second)


@pytest.fixture(scope="module")
def lattice() -> ElementLattice:
    return ElementLattice.around((4, 4), SIDE, LAYER.thickness)


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_a_quadrature_without_period_or_interpolation_agrees(
    lattice: ElementLattice, frequency: complex
) -> None:
    kernel = element_kernel(lattice, frequency)
    for i, j in OFFSETS:
        # cubic interpolation in ln k, and c / k beyond the seventh alias: 2e-5 of the self
        # compliance (measured 1.5e-5 at rest)
        error = 5e-5 * abs(kernel[0, 0])
        assert kernel[i, j] == pytest.approx(by_quadrature(i, j, frequency), abs=error)


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_twice_the_period_gives_the_same(lattice: ElementLattice, frequency: complex) -> None:
    wider = ElementLattice(lattice.shape, SIDE, 2 * lattice.period)
    kernel = element_kernel(lattice, frequency)
    # the images are 10 thicknesses away: what is left of them is 4e-6 of the self compliance
    np.testing.assert_allclose(
        kernel, element_kernel(wider, frequency), atol=1e-5 * abs(kernel[0, 0])
    )


def test_a_larger_patch_sees_the_same_kernel(lattice: ElementLattice) -> None:
    larger = ElementLattice.around((9, 6), SIDE, LAYER.thickness)
    kernel = element_kernel(larger, 2e4)
    assert kernel.shape == (9, 6)
    small = element_kernel(lattice, 2e4)
    np.testing.assert_allclose(kernel[:4, :4], small, atol=1e-5 * abs(small[0, 0]))


def test_rows_and_columns_are_alike_and_statics_are_real(lattice: ElementLattice) -> None:
    kernel = element_kernel(lattice, 0.0)
    assert np.all(kernel.imag == 0)
    np.testing.assert_allclose(kernel, kernel.T, rtol=1e-9)  # rounding of the cosine transform
    assert np.all(np.diff(kernel.real[0]) < 0)


def test_the_lattice_leaves_room_for_waves_to_die(lattice: ElementLattice) -> None:
    assert lattice.period % 2 == 0
    assert (lattice.period - 4) * SIDE >= 10 * LAYER.thickness


def test_every_frequency_is_transformed_by_itself(lattice: ElementLattice) -> None:
    k = lattice.wavenumbers[:, None]
    both = lattice.kernel(surface_compliance(k, np.array([[0.0, 1e5j]]), [LAYER]))
    for kernel, frequency in zip(both, (0.0, 1e5j), strict=True):
        np.testing.assert_allclose(kernel, element_kernel(lattice, frequency), rtol=1e-9)


def test_numbers_do_not_depend_on_the_unit_of_length(lattice: ElementLattice) -> None:
    k = lattice.wavenumbers[:, None]
    compliance = surface_compliance(k, np.array([[2e4]]), [LAYER])
    in_mm = ElementLattice(lattice.shape, SIDE * 1e3, lattice.period)
    np.testing.assert_allclose(in_mm.wavenumbers * 1e3, k[:, 0], rtol=1e-12)
    # the same C in mm / Pa: displacement in mm, area in mm2
    np.testing.assert_allclose(
        in_mm.kernel(compliance * 1e3) * 1e6, lattice.kernel(compliance) * 1e3, rtol=1e-9
    )


@pytest.mark.parametrize("frequencies", [8, 200])
def test_a_kernel_takes_no_more_memory_than_it_says(layers: list[Layer], frequencies: int) -> None:
    """So that what is refused as too large is, and what is taken fits."""
    spacing = 0.75e-3 + frequencies * 1e-7  # a lattice that no one has prepared yet
    lattice = ElementLattice.around((20, 20), spacing, 0.013)
    tracemalloc.start()
    try:
        band_limited(layers, (20, 20), spacing, 1 / 51200, frequencies - 1)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 1.2 * lattice.bytes_needed(frequencies)
    assert peak > lattice.bytes_needed(frequencies) / 3


def test_elements_of_128_a_side_fit_into_a_gigabyte() -> None:
    fine = ElementLattice.around((128, 128), 20e-3 / 128, 0.013)
    assert fine.bytes_needed(257) < 1.2e9


def test_kernels_do_not_depend_on_how_frequencies_are_taken_together(layers: list[Layer]) -> None:
    """Frequencies of 80 lags are in three blocks; their Nyquist frequency alone in one."""
    values = band_limited(layers, (3, 2), 1e-3, 1e-5, 80).values
    even = np.concatenate([values[:1], values[1:] / 2])
    lattice = ElementLattice.around((3, 2), 1e-3, sum(layer.thickness for layer in layers))
    for m in (0, 31, 32, 63, 64, 79):
        s = np.array([[1j * np.pi * m / 80 / 1e-5]])
        alone = lattice.kernel(surface_compliance(lattice.wavenumbers[:, None], s, layers))[0].real
        weight = np.cos(np.pi * m * np.arange(80) / 80)
        found = 2 * np.tensordot(weight, even, axes=1) - even[0]
        # the sample at 80 lags is not kept: 1e-3 of the whole at most
        np.testing.assert_allclose(found, alone, atol=1e-3 * abs(values[0, 0, 0]))


def test_a_patch_may_be_wider_than_half_the_period() -> None:
    """A wide patch on a thin tread: far elements feel nothing, but they are there."""
    wide = ElementLattice.around((30, 4), SIDE, 1e-3)
    assert wide.period < 60
    kernel = element_kernel(wide, 0.0)
    assert kernel.shape == (30, 4)
    twice = element_kernel(ElementLattice((30, 4), SIDE, 2 * wide.period), 0.0)
    # the thickness of LAYER, five times that of the room made here, is felt up to 5e-5
    np.testing.assert_allclose(kernel, twice, atol=1e-2 * abs(kernel[0, 0]))
