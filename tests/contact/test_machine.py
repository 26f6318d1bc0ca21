r"""The machine: a mass and a spring between drive and contact, against closed forms.

Backward Euler on x'' = -omega^2 x takes w = x + i v / omega to w / (1 + i omega dt) in a step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tyrecontact.contact.adhesion import ReleaseForce
from tyrecontact.contact.equilibrium import Bodies
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Machine, Moment, Place, machine_energy
from tyrecontact.errors import InputError
from tyrecontact.road.springs import Springs, linear

Follow = Callable[..., Any]
#: of both springs together [N/m], and the mass on them [kg]
STIFFNESS, MASS, FORCE = 2e5, 0.02, 5.0
OMEGA = np.sqrt(STIFFNESS / MASS)
ALWAYS = ReleaseForce(1e6)


@pytest.fixture(scope="module")
def springs_alone(stiff_layer: Callable[[int], LatticeKernel]) -> Bodies:
    """Two linear springs that never let go, on a layer that does not give."""
    springs = linear(np.full(2, STIFFNESS / 2), 1e-4, 1e-4)
    return Bodies(stiff_layer(2), springs, ALWAYS, np.zeros(2), Machine(0.0, MASS))


@pytest.mark.parametrize("per_period", [20, 200])
def test_a_mass_on_a_linear_contact_rings_as_backward_euler_has_it(
    springs_alone: Bodies, follow: Follow, per_period: int
) -> None:
    time_step = 2 * np.pi / OMEGA / per_period
    steps = np.arange(1, 2 * per_period + 1)
    found = follow(springs_alone, np.full(steps.size, FORCE), time_step)
    rest = FORCE / STIFFNESS
    ringing = rest * (1 + 1j * OMEGA * time_step) ** -steps.astype(float)
    # rounding, and the tolerance of 1e-14 m on each step
    np.testing.assert_allclose(found.indentation, rest - ringing.real, atol=1e-6 * rest)
    decay = np.abs(ringing[-1]) / rest
    assert decay == pytest.approx((1 + (OMEGA * time_step) ** 2) ** -per_period, rel=1e-9)


def test_a_finer_step_rings_at_sqrt_k_over_m(springs_alone: Bodies, follow: Follow) -> None:
    time_step = 2 * np.pi / OMEGA / 600
    found = follow(springs_alone, np.full(900, FORCE), time_step)
    offset = found.indentation - FORCE / STIFFNESS
    crossings = np.flatnonzero(np.diff(np.sign(offset)))
    period = 2 * np.diff(crossings).mean() * time_step
    # a crossing is known to half a step in 600; the scheme's error is (omega dt)^2 / 3
    assert period == pytest.approx(2 * np.pi / OMEGA, rel=4e-3)


def test_a_mass_falls_freely_until_it_touches(springs_alone: Bodies, follow: Follow) -> None:
    away = replace(springs_alone, tops=np.full(2, -1.0))
    found = follow(away, np.full(50, FORCE), 1e-4)
    n = np.arange(1, 51)
    fallen = FORCE / MASS * 1e-4**2 * n * (n + 1) / 2  # backward Euler's t^2 / 2
    np.testing.assert_allclose(found.indentation, fallen, rtol=1e-12)  # rounding
    assert not found.force.any()


def test_at_rest_the_contact_bears_the_force(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    bodies = Bodies(tread, rough_springs, ALWAYS, tops, Machine(0.0, MASS))
    found = follow(bodies, [Moment(FORCE, 1.0, at_rest=True)] * 40)
    assert found.total[-1] == pytest.approx(FORCE, rel=1e-9)  # J of 1e4 N/m on springs of 1e5
    assert abs(found.indentation[-1] - found.indentation[-2]) < 1e-12
    assert found.state.place.velocity == 0
    again = follow(bodies, [*[Moment(FORCE, 1.0, at_rest=True)] * 40, *[Moment(FORCE, 2e-5)] * 20])
    np.testing.assert_allclose(again.total[40:], FORCE, rtol=1e-8)  # and it stays there


@pytest.mark.parametrize("mass", [0.0, 0.01])
def test_an_endlessly_stiff_machine_prescribes_the_indentation(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow, mass: float
) -> None:
    path = np.concatenate([np.linspace(0, 5e-5, 30), np.linspace(5e-5, -4e-5, 60)])
    bodies = Bodies(tread, rough_springs, ReleaseForce(0.05), tops)
    rigid = follow(bodies, path)
    stiff = follow(replace(bodies, machine=Machine(1e12, mass)), path)
    # 50 N and m v / dt of 0.5 N on 1e12 N/m, on a contact of 3e5 N/m
    np.testing.assert_allclose(stiff.total, rigid.total, atol=1e-4)
    np.testing.assert_allclose(stiff.indentation, path, atol=1e-10)
    np.testing.assert_array_equal(stiff.releases, rigid.releases)


def test_a_spring_without_mass_is_in_equilibrium(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray, follow: Follow
) -> None:
    path = np.linspace(0, 1e-4, 40)
    bodies = Bodies(tread, rough_springs, ALWAYS, tops, Machine(1e5))
    found = follow(bodies, path)
    # k_m (X - d) = F; the solution is accurate to 1e-14 m
    np.testing.assert_allclose(1e5 * (path - found.indentation), found.total, atol=1e-8)
    assert 0.1 < found.indentation[-1] / path[-1] < 0.9


MACHINES = [Machine(), Machine(1e5), Machine(1e5, 0.3), Machine(0.0, 0.3)]


@pytest.mark.parametrize("at_rest", [False, True])
@pytest.mark.parametrize("machine", MACHINES, ids=["rigid", "spring", "both", "mass"])
def test_what_the_machine_takes_and_loses_is_what_the_contact_does_not_get(
    machine: Machine, at_rest: bool
) -> None:
    rng = np.random.default_rng(2)
    for _ in range(50):
        before = Place(*rng.normal(size=3) * [1e-4, 0.1, 1e-4])
        drive = float(rng.normal()) * (1e-4 if machine.stiffness else 5.0)
        moment, contact = Moment(drive, 1e-4, at_rest), float(rng.normal())
        free, compliance = machine.response(before, moment)
        after = before.moved(free - compliance * contact, moment)
        energy = machine_energy(machine, before, after, moment, contact)
        got = contact * (after.indentation - before.indentation)
        scale = abs(energy.work) + abs(energy.held) + energy.lost + abs(got)
        assert energy.work - energy.held - energy.lost == pytest.approx(got, abs=1e-10 * scale)
        assert energy.lost >= 0


@pytest.mark.parametrize(
    ("stiffness", "mass", "name"),
    [(-1.0, 1.0, "machine_stiffness"), (np.nan, 1.0, "machine_stiffness"), (0.0, 0.0, "mass"),
     (1e5, -1.0, "mass"), (1e5, np.inf, "mass"), (1e5, np.nan, "mass")],
)  # fmt: skip
def test_impossible_machines_are_refused(stiffness: float, mass: float, name: str) -> None:
    with pytest.raises(InputError, match=rf"^loading\.{name} must .* got .* (N/m|kg)"):
        Machine(stiffness, mass)
