"""The energy account: closed to rounding, no term that only loses ever gains, whatever is done."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tyrecontact.contact.adhesion import Hysteresis, Law, Multiplicative, ReleaseForce
from tyrecontact.contact.energy import Energy
from tyrecontact.contact.equilibrium import Bodies, Solver
from tyrecontact.contact.kinetics import BondKinetics, RecedingContact
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Machine, Moment
from tyrecontact.contact.newton import thesis
from tyrecontact.road.springs import Springs
from tyrecontact.tread.kernels import Kernel

Follow = Callable[..., Any]
TIME_STEP, TOLERANCE = 1 / 51200, 1e-14
LAWS: dict[str, Law] = {
    "none": ReleaseForce(0.0),
    "release force": ReleaseForce(0.05),
    "multiplicative": Multiplicative(0.05, 0.6, 1e-7, 0.08, 1e-3, 5e-3, 0.3),
    "bonds": BondKinetics(1e4, 1.0, 1e6),
    "receding contact": RecedingContact(0.02, 0.08, 1e-3, 1e-3, 0.55),
    "hysteresis": Hysteresis(0.05),
}
MACHINES = {
    "rigid": Machine(),
    "spring": Machine(1e5),
    "spring and mass": Machine(3e5, 1e-3),
    "force": Machine(0.0, 1e-3),
}


@pytest.fixture(scope="module")
def static(tread: LatticeKernel) -> LatticeKernel:
    kernel = tread.kernel
    return LatticeKernel(Kernel(kernel.static_compliance[None], kernel.spacing, np.inf))


def wild(machine: Machine, seed: int, count: int = 60) -> list[Moment]:
    """Drives up and down at random, pressing and parting, with a rest here and there."""
    rng = np.random.default_rng(seed)
    goals = rng.uniform(-0.6, 1.0, count // 4 + 1) * (5.0 if machine.stiffness == 0 else 7e-5)
    goals[0] = 0
    drives = np.interp(np.arange(count) / 4, np.arange(goals.size), goals)
    rests = rng.random(count) < 0.08
    return [
        Moment(float(drive), 1e-2 if rest else TIME_STEP, bool(rest))
        for drive, rest in zip(drives, rests, strict=True)
    ]


def assert_honest(run: Any, passive: bool = True) -> None:
    turnover = sum(np.abs(run.grown(name)).sum() for name in ("drive", "springs", "layer"))
    # rounding of some thousand products
    assert max(abs(energy.imbalance) for energy in run.energy) <= 1e-13 * turnover
    # what a residual of the tolerance on every element may do, and rounding
    slack = 2 * TOLERANCE * np.abs(run.force).sum(axis=1) + 1e-14 * turnover
    assert np.all(run.grown("algorithmic") >= -slack)
    assert np.all(run.grown("released") >= -1e-14 * turnover)
    if passive:
        assert min(energy.layer for energy in run.energy) >= -1e-13 * turnover
    assert not run.energy[-1].is_created


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("law", LAWS)
def test_the_account_closes_for_every_law_and_drive(
    law: str, machine: str, tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray,
    follow: Follow,
) -> None:  # fmt: skip
    bodies = Bodies(tread, rough_springs, LAWS[law], tops, MACHINES[machine])
    assert_honest(follow(bodies, wild(MACHINES[machine], seed=len(law))))


@pytest.mark.parametrize("law", ["release force", "receding contact"])
def test_the_account_closes_on_a_static_tread(
    law: str, static: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    run = follow(Bodies(static, rough_springs, LAWS[law], tops), wild(Machine(), seed=1))
    assert_honest(run)
    # what a static tread holds is a function of the forces: F u / 2, less what steps took
    assert run.energy[-1].layer >= 0


def test_the_account_closes_for_the_solver_of_the_thesis(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    bodies = Bodies(tread, rough_springs, LAWS["release force"], tops)
    solver = Solver(thesis, TOLERANCE, 100, extrapolates=False)
    path = np.concatenate([np.linspace(0, 6e-5, 60), np.linspace(6e-5, -4e-5, 100)])
    assert_honest(follow(bodies, path, solver=solver))


@pytest.mark.parametrize("seed", range(3))
def test_a_passive_tread_gives_back_no_more_than_it_was_given_whatever_is_done(
    seed: int, tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    """Jumps in every step, rests among them, mass and adhesion: no history draws energy."""
    rng = np.random.default_rng(seed)
    moments = [
        Moment(float(drive), 1e-3 if rest else TIME_STEP, bool(rest))
        for drive, rest in zip(rng.uniform(-4e-5, 9e-5, 80), rng.random(80) < 0.15, strict=True)
    ]
    bodies = Bodies(tread, rough_springs, ReleaseForce(0.3), tops, Machine(3e6, 1e-4))
    assert_honest(follow(bodies, moments))


def test_a_drive_does_the_work_of_its_force(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    path = np.concatenate([np.linspace(0, 6e-5, 30), np.linspace(6e-5, -4e-5, 60)])
    run = follow(Bodies(tread, rough_springs, LAWS["release force"], tops), path)
    work = np.cumsum(run.total * np.diff(path, prepend=0.0))
    found = [energy.drive for energy in run.energy]
    np.testing.assert_allclose(found, work, rtol=1e-12)  # the same sum in another order
    active = run.force[40] != 0
    held = (rough_springs.energy(np.abs(run.compression[40])) * active).sum()
    assert run.energy[40].springs == pytest.approx(held, rel=1e-10)  # a sum of differences
    assert run.energy[-1].springs == pytest.approx(0.0, abs=1e-15)  # all apart
    assert run.energy[-1].released > 0


def test_finer_steps_lose_less_to_the_time_stepping(
    static: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    """Backward Euler's loss, F dd - dU = k dd^2 / 2 a step, is of the first order."""
    bodies = Bodies(static, rough_springs, LAWS["none"], tops)
    lost = [
        follow(bodies, np.linspace(0, 6e-5, count + 1)).energy[-1].algorithmic
        for count in (20, 40, 80)
    ]
    assert lost[0] / lost[1] == pytest.approx(2, rel=0.1)  # contacts join within steps
    assert lost[1] / lost[2] == pytest.approx(2, rel=0.1)


def test_a_broken_bond_loses_what_its_spring_held(
    stiff_layer: Callable[[int], LatticeKernel],
    linear_springs: Callable[[np.ndarray], Springs],
    follow: Follow,
) -> None:
    springs = linear_springs(np.full(2, 1e5))
    run = follow(
        Bodies(stiff_layer(2), springs, ReleaseForce(0.5), np.zeros(2)), [1e-6, -4e-6, -6e-6]
    )
    np.testing.assert_array_equal(run.releases, [0, 0, 2])
    held = 2 * 1e5 * 4e-6**2 / 2  # at the start of the step in which both break
    assert run.energy[-1].released == pytest.approx(held, rel=1e-6)  # the layer gives a little
    assert run.energy[1].released == 0


def test_steps_add_up() -> None:
    one = Energy(6.0, 1.0, 1.0, 1.0, 1.0, 1.0, 9.0)
    two = one.plus(Energy(drive=2.0, layer=1.0, turnover=1.0))
    assert two == Energy(8.0, 1.0, 1.0, 2.0, 1.0, 1.0, 10.0)
    assert (one.imbalance, two.imbalance) == (1.0, 2.0)
    assert not two.is_created
    assert Energy(layer=-1e-5, turnover=1.0).is_created
    assert not Energy(layer=-1e-7, turnover=1.0).is_created
