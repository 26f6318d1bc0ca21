"""Kernels in time: statics, definition, accuracy, interpolation, what is refused."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.tread.elements import ElementLattice
from tyrecontact.tread.kernels import (
    Kernel,
    band_limited,
    interpolated,
    passive,
    passive_mobility,
    quadrature_frequencies,
    static,
)
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer
from tyrecontact.tread.plate import surface_compliance


@pytest.fixture(scope="module")
def transfer(layers: list[Layer], band_limited_kernel: Kernel) -> np.ndarray:
    """Element compliance at 0 .. half the sampling rate [m/N], (lags + 1, ny, nx)."""
    _, ny, nx = band_limited_kernel.values.shape
    thickness = sum(layer.thickness for layer in layers)
    lattice = ElementLattice.around((ny, nx), band_limited_kernel.spacing, thickness)
    lags = band_limited_kernel.lags
    frequency = np.arange(lags + 1) / (2 * lags * band_limited_kernel.time_step)
    k = lattice.wavenumbers[:, None]
    return lattice.kernel(surface_compliance(k, 2j * np.pi * frequency[None, :], layers))


@pytest.mark.parametrize("method", [passive, passive_mobility, band_limited])
def test_a_kernel_says_what_it_is(layers: list[Layer], method: Callable[..., Kernel]) -> None:
    kernel = method(layers, (2, 3), 1e-3, 1e-4, lags=8)
    assert kernel.values.shape == (8, 2, 3)
    assert (kernel.lags, kernel.spacing, kernel.time_step) == (8, 1e-3, 1e-4)


def test_the_passive_kernel_sums_to_the_statics(
    passive_kernel: Kernel, static_kernel: Kernel
) -> None:
    np.testing.assert_allclose(
        passive_kernel.static_compliance, static_kernel.values[0], rtol=1e-9
    )  # rounding


def test_a_static_kernel_is_one_lag_without_time(static_kernel: Kernel) -> None:
    assert static_kernel.lags == 1
    assert np.isinf(static_kernel.time_step)
    assert np.isrealobj(static_kernel.values)


def test_the_band_limited_kernel_lacks_its_last_sample(
    band_limited_kernel: Kernel, static_kernel: Kernel, transfer: np.ndarray
) -> None:
    even = np.fft.irfft(transfer.real, axis=0)
    missing = even[band_limited_kernel.lags]
    np.testing.assert_allclose(
        band_limited_kernel.static_compliance + missing, static_kernel.values[0], rtol=1e-9
    )  # rounding
    assert np.abs(missing).max() < 2e-4 * static_kernel.values.max()


def test_the_band_limited_kernel_has_the_real_part_of_the_transfer_function(
    band_limited_kernel: Kernel, transfer: np.ndarray
) -> None:
    """The DFT of the causal half is "two times the real part", less (-1)^m times the last."""
    lags = band_limited_kernel.lags
    spectrum = np.fft.rfft(band_limited_kernel.values, n=2 * lags, axis=0).real
    missing = np.fft.irfft(transfer.real, axis=0)[lags]
    sign = (-1.0) ** np.arange(lags + 1)
    expected = transfer.real - sign[:, None, None] * missing
    scale = np.abs(transfer).max()
    np.testing.assert_allclose(spectrum / scale, expected / scale, atol=1e-12)  # rounding


def test_the_passive_kernel_has_the_transfer_function_of_slow_forces(
    passive_kernel: Kernel, transfer: np.ndarray
) -> None:
    """Below a tenth of the sampling rate BDF2 is accurate to (w dt)^2 / 3 or better."""
    spectrum = np.fft.rfft(passive_kernel.values, n=2 * passive_kernel.lags, axis=0)
    omega = np.pi * np.arange(1, 7) / passive_kernel.lags
    error = np.abs(spectrum[1:7, 0, 0] - transfer[1:7, 0, 0]) / np.abs(transfer[1:7, 0, 0])
    # 1.3 % of creep is still to come after the last lag, and put into the last lags
    assert np.all(error < omega**2 / 3 + 0.015)


@pytest.mark.parametrize("quadrature", ["BDF1", "BDF2"])
@pytest.mark.parametrize("lags", [4, 64, 1024])
def test_quadrature_asks_for_decaying_loads_alone(lags: int, quadrature: str) -> None:
    """Both are A-stable: the plate is never asked outside Re s > 0, where it is analytic."""
    frequency = quadrature_frequencies(1e-5, lags, quadrature)
    assert frequency.shape == (lags + 1,)
    assert np.all(frequency.real > 0)


@pytest.mark.parametrize(("quadrature", "gain", "error"), [("BDF2", 4, 1e-3), ("BDF1", 2, 5e-2)])
def test_the_passive_kernel_converges_at_the_order_of_its_quadrature(
    layers: list[Layer], quadrature: str, gain: float, error: float
) -> None:
    """Displacement of an element under its own smooth pulse of 0.8 ms."""
    duration, lags, responses = 8e-4, 64, []
    for factor in (1, 2, 4):
        time_step = 1 / 51200 / factor
        kernel = passive(layers, (1, 1), 1e-3, time_step, lags * factor, quadrature)
        time = np.arange(lags * factor) * kernel.time_step
        force = np.sin(np.pi * time / duration) ** 4 * (time < duration)
        response = np.convolve(force, kernel.values[:, 0, 0])[: lags * factor]
        responses.append(response[::factor])
    first, second = (np.abs(a - b).max() for a, b in pairwise(responses))
    assert first < error * np.abs(responses[-1]).max()
    assert first / second == pytest.approx(gain, rel=0.05)  # the next order; measured 3.98, 1.93


def test_an_unknown_quadrature_is_refused_with_the_nearest(layers: list[Layer]) -> None:
    with pytest.raises(InputError, match="BDF1, BDF2, got 'BDF3'"):
        passive(layers, (1, 1), 1e-3, 1e-5, 8, "BDF3")


def test_the_mobility_kernel_has_the_real_part_of_the_mobility(
    layers: list[Layer], transfer: np.ndarray
) -> None:
    """Steps of the kernel over dt transform to Re(i w C), less (-1)^m times the last sample."""
    kernel = passive_mobility(layers, (4, 4), 1e-3, 1 / 51200, 64)
    omega = np.pi * np.arange(65) / 64 / kernel.time_step
    mobility = -omega[:, None, None] * transfer.imag
    steps = np.diff(kernel.values, axis=0, prepend=0) / kernel.time_step
    missing = np.fft.irfft(mobility, axis=0)[64]
    found = np.fft.rfft(steps, n=128, axis=0).real
    expected = mobility - (-1.0) ** np.arange(65)[:, None, None] * missing
    np.testing.assert_allclose(found, expected, atol=1e-12 * np.abs(mobility).max())  # rounding


@pytest.mark.parametrize(("factor", "low"), [(1, 0.162), (4, -0.036)])
def test_the_mobility_kernel_pays_with_its_statics(
    layers: list[Layer], static_kernel: Kernel, factor: int, low: float
) -> None:
    """What the sampling rate leaves out of the mobility is missing at rest (measured)."""
    kernel = passive_mobility(layers, (2, 2), 1e-3, 1 / 51200 / factor, 128 * factor)
    share = kernel.static_compliance[0, 0] / static_kernel.values[0, 0, 0]
    assert share == pytest.approx(1 - low, abs=4e-3)  # by the number of lags
    # a constant force ends up holding the surface still: 3e-5 of the first step is left
    assert abs(kernel.values[-1, 0, 0]) < 1e-4 * kernel.values[0, 0, 0]


@pytest.mark.parametrize("method", [passive, band_limited])
def test_more_lags_only_add_a_tail(layers: list[Layer], method: Callable[..., Kernel]) -> None:
    short, long = (method(layers, (2, 2), 1e-3, 1 / 51200, lags=lags) for lags in (64, 128))
    scale = short.values.max()
    # the passive tail goes into the last lags; the band-limited one wraps around, 1e-3 of it
    np.testing.assert_allclose(short.values[:40] / scale, long.values[:40] / scale, atol=2e-3)


def test_numbers_do_not_depend_on_the_units() -> None:
    """Millimetre, gram, millisecond: 1 Pa = 1e-6 g / (mm ms^2), and the newton stays."""
    base = FractionalKelvinVoigt(72e9, 1e-7, 0.5), FractionalKelvinVoigt(72e3, 1e-4, 0.5)
    si = [Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499), Layer(0.003, 2700, base[0], 0.33)]
    mm = [
        Layer(10.0, 1300e-6, FractionalKelvinVoigt(25.0, 3.717e-3), 0.499),
        Layer(3.0, 2700e-6, base[1], 0.33),
    ]
    for method in (passive, passive_mobility, band_limited):
        kernel, in_mm = (
            method(layers, (2, 2), *lengths, lags=16)
            for layers, lengths in ((si, (1e-3, 1 / 51200)), (mm, (1.0, 1e3 / 51200)))
        )
        scale = kernel.values.max()
        np.testing.assert_allclose(
            in_mm.values * 1e-3 / scale, kernel.values / scale, atol=1e-9
        )  # rounding


@pytest.mark.parametrize("factor", [1, 2, 4])
def test_interpolation_keeps_old_samples_and_loses_half_the_end_ones(
    band_limited_kernel: Kernel, factor: int
) -> None:
    finer = interpolated(band_limited_kernel, factor)
    old = band_limited_kernel.values
    assert finer.lags == (band_limited_kernel.lags - 1) * factor + 1
    assert finer.time_step == pytest.approx(band_limited_kernel.time_step / factor)
    np.testing.assert_allclose(finer.values[::factor], old / factor, rtol=1e-13)
    fall = (1 - 1 / factor) * (old[0] + old[-1]) / 2
    expected = band_limited_kernel.static_compliance - fall
    np.testing.assert_allclose(finer.static_compliance, expected, rtol=1e-9, atol=1e-18)


def test_interpolated_samples_lie_half_way(band_limited_kernel: Kernel) -> None:
    finer, old = interpolated(band_limited_kernel, 2).values, band_limited_kernel.values
    np.testing.assert_allclose(finer[1::2], (old[:-1] + old[1:]) / 4, rtol=1e-12, atol=1e-20)


@pytest.mark.parametrize("factor", [0, 3, 8])
def test_other_factors_are_refused(band_limited_kernel: Kernel, factor: int) -> None:
    with pytest.raises(InputError, match=f"1, 2 or 4 to interpolate, got {factor}"):
        interpolated(band_limited_kernel, factor)


@pytest.mark.parametrize("method", [passive, passive_mobility, band_limited])
@pytest.mark.parametrize(
    ("name", "value"),
    [("spacing", 0.0), ("spacing", np.nan), ("time_step", 0.0), ("time_step", np.inf),
     ("time_step", np.nan), ("lags", 1)],
)  # fmt: skip
def test_impossible_settings_are_refused(
    layers: list[Layer], method: Callable[..., Kernel], name: str, value: float
) -> None:
    settings = {"spacing": 1e-3, "time_step": 1e-5, "lags": 8} | {name: value}
    with pytest.raises(InputError, match=name):
        method(layers, (2, 2), **settings)


def test_a_static_kernel_refuses_an_impossible_spacing(layers: list[Layer]) -> None:
    with pytest.raises(InputError, match="spacing"):
        static(layers, (2, 2), -1.0)
