"""The same problem in mm, g and ms, hence N and MPa: the same numbers, function by function."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tyrecontact.contact import newton
from tyrecontact.contact.interface import Mirrored
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.road.springs import Springs, from_heights, linearised
from tyrecontact.tread import kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss
from tyrecontact.tread.plate import surface_compliance

#: of one m, kg and s in mm, g and ms; N stays N
LENGTH, MASS, TIME = 1e3, 1e3, 1e3
PRESSURE, DENSITY = 1 / LENGTH**2, MASS / LENGTH**3
COMPLIANCE = LENGTH / PRESSURE  # displacement per pressure
SHAPE = (6, 6)


def tread(length: float, pressure: float, density: float, time: float) -> list[Layer]:
    """The default plate, in a system of units given by those of SI in it."""
    rubber = FractionalKelvinVoigt(25e6 * pressure, 3.717e-6 * time, 0.6091)
    base = NearlyConstantLoss(72e9 * pressure, 5e-5, 1 / time)
    return [
        Layer(10e-3 * length, 1300 * density, rubber, 0.499),
        Layer(3e-3 * length, 2700 * density, base, 0.33),
    ]


IN_SI = tread(1, 1, 1, 1)
IN_MM = tread(LENGTH, PRESSURE, DENSITY, TIME)


def springs(length: float, pressure: float) -> Springs:
    heights = np.random.default_rng(4).standard_normal((36, 400)) * 5e-6
    return from_heights(heights * length, 5e-5 * length, 10e6 * pressure)


def test_a_newton_is_a_newton() -> None:
    assert MASS * LENGTH / TIME**2 == 1
    assert PRESSURE == MASS / (LENGTH * TIME**2)


def test_the_plate() -> None:
    k = np.geomspace(1, 1e5, 30)[:, None]
    s = np.array([0, 1e2, 2j * np.pi * 1e3, 2j * np.pi * 25e3, 1e4 + 1e5j])
    expected = COMPLIANCE * surface_compliance(k, s, IN_SI)
    found = surface_compliance(k / LENGTH, s / TIME, IN_MM)
    # powers of ten do not round alike: 1e-16, times (k h)^-3 = 1e6 where the load is uniform
    np.testing.assert_allclose(found, expected, rtol=1e-9)


@pytest.mark.parametrize("make", [kernels.passive, kernels.band_limited])
def test_kernels_in_time(make: Callable[..., Kernel]) -> None:
    expected, found = (
        make(layers, SHAPE, 1e-3 * length, time / 51200, 32).values
        for layers, length, time in ((IN_SI, 1, 1), (IN_MM, LENGTH, TIME))
    )
    scale = LENGTH * np.abs(expected).max()
    # rounding, which the contour of the quadrature weighs by up to eps^(-1/2): 1.5e-8
    np.testing.assert_allclose(found / scale, LENGTH * expected / scale, atol=2e-8)


def static_kernels() -> tuple[Kernel, Kernel]:
    return kernels.static(IN_SI, SHAPE, 1e-3), kernels.static(IN_MM, SHAPE, 1e-3 * LENGTH)


def test_the_kernel_at_rest() -> None:
    expected, found = static_kernels()
    np.testing.assert_allclose(found.values, LENGTH * expected.values, rtol=1e-9)  # as the plate


@pytest.mark.parametrize(
    "simplify",
    [lambda springs, _: springs, lambda springs, length: linearised(springs, 9e-6 * length)],
    ids=["none", "linear"],
)
def test_springs(simplify: Callable[[Springs, float], Springs]) -> None:
    in_si, in_mm = (
        simplify(springs(length, pressure), length)
        for length, pressure in ((1, 1), (LENGTH, PRESSURE))
    )
    units = {
        "force": 1, "stiffness": 1 / LENGTH, "energy": LENGTH, "radius": LENGTH, "onset": LENGTH,
        "punch_stiffness": 1 / LENGTH, "punch_stiffness_slope": PRESSURE,
    }  # fmt: skip
    for delta in (1.3e-6, 9e-6, 2.1e-5, 1e-4):
        for name, unit in units.items():
            expected = unit * getattr(in_si, name)(np.full(36, delta))
            found = getattr(in_mm, name)(np.full(36, delta * LENGTH))
            # rounding, of coefficients that are differences over a cell
            np.testing.assert_allclose(found, expected, rtol=1e-7, err_msg=name)


@pytest.mark.parametrize("method", [newton.robust, newton.thesis])
def test_a_step_of_newtons_method(method: Callable[..., Any]) -> None:
    tops = np.random.default_rng(5).uniform(-20e-6, 0, 36)
    found = []
    for kernel, (length, pressure) in zip(
        static_kernels(), ((1, 1), (LENGTH, PRESSURE)), strict=True
    ):
        solution = method(
            LatticeKernel(kernel).now,
            Mirrored(springs(length, pressure), np.zeros(36, bool)),
            (60e-6 + tops) * length,
            tops * length,
            1e-15 * length,
            60,
        )
        found.append((solution.force, solution.compression / length, solution.iterations))
    assert found[0][2] == found[1][2]
    # both have solved to 1e-15 m of 1e-5 m
    np.testing.assert_allclose(found[1][0], found[0][0], rtol=1e-8, atol=1e-10)
    np.testing.assert_allclose(found[1][1], found[0][1], rtol=1e-8, atol=1e-14)
