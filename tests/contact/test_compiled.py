"""Compiled loops give what the plain ones give; they are tested where numba is installed."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
import pytest

from tyrecontact import Simulation, fast, presets
from tyrecontact.contact import newton
from tyrecontact.contact.interface import Hinged, Mirrored
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.road.springs import Springs

pytest.importorskip("numba")

TOLERANCE = 1e-14


def both(
    monkeypatch: pytest.MonkeyPatch, *arguments: object, **more: object
) -> list[newton.Solution]:
    """`newton.robust`, compiled and plain."""
    found = []
    for enabled in (True, False):
        monkeypatch.setattr(fast, "enabled", enabled)
        found.append(newton.robust(*arguments, **more))
    return found


@pytest.mark.parametrize("shared", [0.0, 3e-7])
@pytest.mark.parametrize("indentation", [-5e-6, 2e-5, 2e-4])
@pytest.mark.parametrize("at_rest", [False, True])
def test_solutions_agree(
    monkeypatch: pytest.MonkeyPatch, tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray,
    indentation: float, shared: float, at_rest: bool,
) -> None:  # fmt: skip
    bonded = np.arange(tops.size) % 3 == 0
    compliance = (tread.at_rest if at_rest else tread.now).with_shared(shared)
    interface = Mirrored(rough_springs, bonded)
    one, other = both(monkeypatch, compliance, interface, indentation + tops, tops, TOLERANCE, 60)
    assert one.converged
    assert other.converged
    for field in ("compression", "force", "stiffness", "energy", "displacement"):
        here, there = getattr(one, field), getattr(other, field)
        # the tolerance, as far as springs of up to 1e6 N/m carry it into forces and energies
        np.testing.assert_allclose(here, there, rtol=1e-7, atol=1e-7 * np.abs(there).max())
    assert (one.force < 0).any() or indentation > 0


def test_a_poor_guess_is_left_for_the_last_compression(
    monkeypatch: pytest.MonkeyPatch, tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray
) -> None:
    interface, target = Mirrored(rough_springs, np.zeros(64, bool)), 1e-4 + tops
    for solution in both(
        monkeypatch, tread.now, interface, target, target + 1e-2, TOLERANCE, 60, last=target
    ):
        assert solution.converged


def test_one_that_may_not_iterate_says_so(
    monkeypatch: pytest.MonkeyPatch, tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray
) -> None:
    interface = Mirrored(rough_springs, np.zeros(64, bool))
    one, other = both(monkeypatch, tread.now, interface, 1e-4 + tops, tops, TOLERANCE, 1)
    for solution in (one, other):
        assert not solution.converged
        assert solution.iterations == 1
    assert one.residual == pytest.approx(other.residual, rel=1e-3)  # solved to 1e-4


def test_look_ups_agree(monkeypatch: pytest.MonkeyPatch, rough_springs: Springs) -> None:
    places = rough_springs.depth * np.linspace(0, 1.5, rough_springs.count)
    found = []
    for enabled in (True, False):
        monkeypatch.setattr(fast, "enabled", enabled)
        found.append([rough_springs.radius(places), rough_springs.punch_stiffness_slope(places)])
    np.testing.assert_allclose(*found, rtol=1e-13)


@pytest.mark.parametrize("enabled", [True, False])
def test_look_ups_stay_inside_the_tables(
    monkeypatch: pytest.MonkeyPatch, rough_springs: Springs, enabled: bool
) -> None:
    monkeypatch.setattr(fast, "enabled", enabled)
    for count in (1000, 3):  # more than there are springs, and fewer
        with pytest.raises(ValueError, match="broadcast"):
            rough_springs.radius(np.full(count, 1e-6))


def test_what_is_no_number_reads_no_other_memory(rough_springs: Springs) -> None:
    assert np.all(np.isnan(rough_springs.radius(np.full(rough_springs.count, np.nan))))


def test_a_target_that_is_no_number_is_not_solved(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray
) -> None:
    target = np.where(np.arange(64) == 3, np.nan, tops + 1e-5)
    interface = Mirrored(rough_springs, np.zeros(64, bool))
    assert not newton.robust(tread.now, interface, target, tops, TOLERANCE, 5).converged


def test_hinged_elements_are_solved_by_the_plain_method(
    tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray
) -> None:
    hinged = Hinged(rough_springs, np.ones(64, bool), np.full(64, 1e-5))
    solution = newton.robust(tread.now, hinged, 5e-5 + tops, tops, TOLERANCE, 60)
    assert solution.converged


@pytest.mark.parametrize("preset", ["default", "adhesion"])
def test_runs_agree(monkeypatch: pytest.MonkeyPatch, preset: str) -> None:
    scenario = presets.get(preset)
    scenario.set("road.elements", 10)
    scenario.set("road.size", 0.01)
    scenario.set("numerics.lags", 64)
    forces = []
    for enabled in (True, False):
        monkeypatch.setattr(fast, "enabled", enabled)
        forces.append(Simulation(scenario).run().contact_force)
    np.testing.assert_allclose(*forces, rtol=0, atol=1e-9 * np.abs(forces[0]).max())


def test_a_solution_has_the_same_fields(tread: LatticeKernel) -> None:
    from tyrecontact.compiled import Point

    assert [field.name for field in fields(newton.Solution)][:5] == list(Point._fields[:5])
