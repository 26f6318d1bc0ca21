"""Runs against the direct method: dense sums over the past, dense Jacobians, LAPACK.

Both are solved to residuals of about 1e-17 m on springs of up to 1e6 N/m, that is to 1e-11 N of
several; 1e-9 of the largest force leaves room for what rounding adds over a run.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.benchmarks.direct import DirectMethod, DirectStep
from tyrecontact import Scenario, Simulation, fast, presets
from tyrecontact.contact import linear, transforms
from tyrecontact.loading import Schedule
from tyrecontact.results import Step

#: of the largest force
SAME = 1e-9
RESIDUAL = 2e-17  # m
THESIS = {"solver": "thesis", "max_iterations": 10, "kernel": "band-limited"}
KERNELS: dict[str, dict[str, Any]] = {
    "passive BDF2": {},
    "passive BDF1": {"quadrature": "BDF1"},
    "passive, finer": {"time_resolution_factor": 2},
    "passive-mobility": {"kernel": "passive-mobility"},
    "band-limited, factor 2": {**THESIS, "time_resolution_factor": 2},
    "band-limited, factor 4": {**THESIS, "time_resolution_factor": 4},
    "static": {"kernel": "static"},
    "static, band-limited": {"kernel": "static", "statics": "band-limited"},
}
WILD: dict[str, dict[str, Any]] = {
    "band-limited": THESIS,
    "recomputed": {**THESIS, "refinement": "recomputed", "time_resolution_factor": 2},
}
LAWS = ["release-force", "multiplicative", "bonds", "receding-contact", "hysteresis"]
DRIVES: dict[str, dict[str, Any]] = {
    "rigid": {},
    "machine": {"drive": "machine", "machine_stiffness": 1e5},
    "machine with mass": {"drive": "machine", "machine_stiffness": 1e5, "mass": 1e-3},
    "force": {
        "drive": "force", "mass": 1e-3, "max_force": 3.0, "force_rate": 6e3,
        "unloading_force_rate": 6e3, "pull": 5.0,
    },
}  # fmt: skip


def both(simulation: Simulation) -> tuple[list[Step], list[DirectStep]]:
    """The run, at a tight tolerance, and the same by the direct method."""
    return list(simulation), list(DirectMethod(simulation, RESIDUAL))


def tight(scenario: Scenario) -> Simulation:
    scenario.numerics.tolerance = 1e-13
    return Simulation(scenario)


def of_lags(simulation: Simulation, lags: int) -> Simulation:
    """The same with the kernel's first lags alone."""
    kernel = simulation.kernel
    simulation.kernel = replace(kernel, values=kernel.values[:lags])
    return simulation


def assert_same(steps: list[Step], direct: list[DirectStep]) -> None:
    """Forces of elements and of all together, where the road is, and which bonds break."""
    found = np.array([step.element_force.ravel() for step in steps])
    expected = np.array([step.force for step in direct])
    assert found.shape == expected.shape
    assert expected.max() > 0.1  # N: there is something to compare
    np.testing.assert_allclose(found, expected, rtol=0, atol=SAME * np.abs(expected).max())
    total = expected.sum(axis=1)
    np.testing.assert_allclose(
        [step.contact_force for step in steps], total, rtol=0, atol=SAME * np.abs(total).max()
    )
    deepest = max(abs(step.indentation) for step in direct)
    np.testing.assert_allclose(
        [step.indentation for step in steps],
        [step.indentation for step in direct],
        rtol=0,
        atol=SAME * deepest,
    )
    assert [step.releases for step in steps] == [step.releases for step in direct]


@pytest.fixture(params=["compiled", "plain", "Fourier"])
def way(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """How a step is calculated: compiled (with numba) or not, with matrices or fast transforms."""
    monkeypatch.setattr(fast, "enabled", request.param == "compiled")
    if request.param == "Fourier":
        monkeypatch.setattr(transforms, "MATRICES_UP_TO", 0)
        monkeypatch.setattr(linear, "_FEW", 0)
    transforms.transform.cache_clear()
    yield
    transforms.transform.cache_clear()


@pytest.mark.usefixtures("way")
@pytest.mark.parametrize("kernel", KERNELS)
def test_every_kernel_pressed_and_pulled_off(quick_cycle: Scenario, kernel: str) -> None:
    quick_cycle.numerics.param.update(**KERNELS[kernel])
    steps, direct = both(tight(quick_cycle))
    assert_same(steps, direct)
    assert sum(step.releases for step in direct) > 30


@pytest.mark.parametrize("kernel", WILD)
def test_kernels_that_blow_up_as_long_as_nothing_grows(quick: Scenario, kernel: str) -> None:
    """Where the margin is used up any rounding grows without bounds, and nothing is the same."""
    quick.numerics.param.update(**WILD[kernel])
    quick.loading.rate = 0.025
    steps, direct = both(tight(quick))
    safe = next(step.index for step in steps if step.stability_margin < 0)
    assert safe > 30
    assert_same(steps[:safe], direct[:safe])


@pytest.mark.parametrize(
    ("law", "solver"),
    [*((law, "robust") for law in LAWS), ("release-force", "thesis"), ("hysteresis", "thesis")],
)
def test_every_law_of_adhesion(quick_cycle: Scenario, law: str, solver: str) -> None:
    quick_cycle.adhesion.param.update(law=law, release_force=0.2, bond_stress=5e5)
    quick_cycle.numerics.solver = solver
    steps, direct = both(tight(quick_cycle))
    assert_same(steps, direct)
    assert sum(step.releases for step in direct) > 30


@pytest.mark.usefixtures("way")
@pytest.mark.parametrize("hold", [2e-4, 0.015])
@pytest.mark.parametrize("drive", DRIVES)
def test_every_drive_with_a_hold_of_a_few_steps_or_at_rest(
    quick_cycle: Scenario, drive: str, hold: float
) -> None:
    """The hold of 15 ms goes on at rest after 64 steps, and then the road is pulled off."""
    quick_cycle.loading.param.update(**DRIVES[drive], hold_time=hold)
    simulation = tight(quick_cycle)
    assert simulation.schedule.at_rest.any() == (hold > 1e-3)
    assert_same(*both(simulation))


def test_two_holds_at_rest_with_motion_between_and_after(quick: Scenario, tmp_path: Path) -> None:
    """The road is moved for fewer steps than the tread remembers, and for more."""
    knots = [(0, 0), (0.3, 4e-5), (20, 4e-5), (20.2, 2e-5), (40, 2e-5), (42, 8e-5)]  # ms, m
    table = tmp_path / "holds.txt"
    table.write_text("".join(f"{time * 1e-3} {depth}\n" for time, depth in knots))
    quick.loading.param.update(profile="table", table=str(table))
    simulation = tight(quick)
    rests = simulation.schedule.at_rest
    assert np.sum(rests[1:] & ~rests[:-1]) == 2
    assert_same(*both(simulation))


def test_motion_that_begins_at_rest_under_load(quick: Scenario) -> None:
    """The first step fills the memory at once: so the benchmarks begin."""
    simulation = tight(quick)
    schedule, begin = simulation.schedule, 20
    rests = np.arange(len(simulation) - begin) == 0
    simulation.schedule = Schedule(schedule.time[begin:], schedule.drive[begin:], rests)
    assert_same(*both(simulation))


@pytest.mark.parametrize("lags", [1, 2, 3, 5, 17, 31, 64, 101, 160])
def test_any_number_of_lags(quick: Scenario, lags: int) -> None:
    """Prime, even, far fewer than the 128 steps and more: a longer kernel is cut off there."""
    quick.road.param.update(elements=3, size=3e-3)
    quick.loading.param.update(profile="sinusoidal", period=2.5e-3)
    quick.numerics.lags = 160
    assert_same(*both(of_lags(tight(quick), lags)))


@pytest.mark.usefixtures("way")
def test_a_lattice_of_many_elements(quick: Scenario) -> None:
    quick.road.param.update(elements=33, size=33e-3, pixel=1e-4)
    quick.loading.rate = 0.4
    assert_same(*both(of_lags(tight(quick), 11)))


def test_the_default_scenario_at_its_own_tolerance() -> None:
    """Of 40 lags and at twice the rate, so that dense matrices are done with in seconds.

    In the whole of it the tolerance of 2e-14 m leaves 4e-10 of the largest element force.
    """
    scenario = presets.get("default")
    scenario.numerics.lags, scenario.loading.rate = 40, 0.06
    simulation = Simulation(scenario)
    assert_same(*both(simulation))
