"""From settings to kernels: that each setting arrives where it belongs."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation, assembly
from tyrecontact.errors import InputError
from tyrecontact.parts.tread import Tread
from tyrecontact.tread import kernels

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


def small(**numerics: object) -> Scenario:
    return Scenario(road=ROAD, numerics={"lags": 16, **numerics})


def test_the_thesis_tread_at_rest_is_its_dynamic_kernel_summed() -> None:
    for factor in (1, 2):
        settings = {"time_resolution_factor": factor, "lags": 32}
        moving = assembly.tread_kernel(small(kernel="band-limited", **settings))
        still = assembly.tread_kernel(small(kernel="static", statics="band-limited", **settings))
        assert (still.lags, still.time_step) == (1, np.inf)
        np.testing.assert_array_equal(still.values[0], moving.static_compliance)
    exact = assembly.tread_kernel(small(kernel="static", time_resolution_factor=2))
    assert exact.values[0, 0, 0] > still.values[0, 0, 0]  # interpolation takes some of it away


@pytest.mark.parametrize(
    ("kernel", "factor", "lags"),
    [("passive", 1, 16), ("passive", 3, 48), ("passive-mobility", 5, 80),
     ("band-limited", 1, 16), ("band-limited", 4, 61)],
)  # fmt: skip
def test_a_kernel_covers_the_same_time_at_a_finer_step(kernel: str, factor: int, lags: int) -> None:
    found = assembly.tread_kernel(small(kernel=kernel, time_resolution_factor=factor))
    assert found.values.shape == (lags, 6, 6)
    assert found.time_step == pytest.approx(1 / 51200 / factor, rel=1e-12)  # a division
    assert found.spacing == pytest.approx(1e-3, rel=1e-12)


def test_a_static_kernel_has_one_lag_and_the_statics_of_the_passive_one() -> None:
    still = assembly.tread_kernel(small(kernel="static", time_resolution_factor=2))
    assert still.values.shape == (1, 6, 6)
    assert still.time_step == np.inf
    moving = assembly.tread_kernel(small()).static_compliance
    # rounding of sums over the contour
    np.testing.assert_allclose(moving, still.values[0], rtol=1e-6)


@pytest.mark.parametrize("factor", [3, 5, 16])
def test_a_band_limited_kernel_is_interpolated_to_factors_of_the_thesis_only(factor: int) -> None:
    with pytest.raises(InputError, match=f"must be 1, 2 or 4 to interpolate, got {factor}"):
        assembly.tread_kernel(small(kernel="band-limited", time_resolution_factor=factor))


@pytest.mark.parametrize("factor", [1, 2, 3])
def test_a_band_limited_kernel_is_recomputed_at_any_factor(factor: int) -> None:
    settings = {"kernel": "band-limited", "refinement": "recomputed"}
    found = assembly.tread_kernel(small(**settings, time_resolution_factor=factor))
    layers = assembly.tread_layers(Tread())
    anew = kernels.band_limited(layers, (6, 6), 1e-3, 1 / 51200 / factor, 16 * factor)
    np.testing.assert_array_equal(found.values, anew.values)
    Simulation(Scenario(road=ROAD, numerics={**settings, "time_resolution_factor": factor}))


def test_the_quadrature_arrives_at_the_passive_kernel() -> None:
    found = assembly.tread_kernel(small(quadrature="BDF1"))
    layers = assembly.tread_layers(Tread())
    first = kernels.passive(layers, (6, 6), 1e-3, 1 / 51200, 16, "BDF1")
    np.testing.assert_array_equal(found.values, first.values)
    assert np.abs(found.values - assembly.tread_kernel(small()).values).max() > 1e-7


@pytest.mark.parametrize("kernel", ["band-limited", "passive-mobility", "static"])
def test_kernels_on_the_imaginary_axis_take_a_table(kernel: str) -> None:
    scenario = Scenario(
        road=ROAD, tread={"material": "tabulated"}, numerics={"kernel": kernel, "lags": 32}
    )
    Simulation(scenario)
    stiff = assembly.tread_kernel(scenario).values[0, 0, 0]
    soft = assembly.tread_kernel(small(kernel=kernel, lags=32)).values[0, 0, 0]
    # 50 MPa where the default has 40; the same at rest
    assert stiff == pytest.approx(soft) if kernel == "static" else stiff < soft
