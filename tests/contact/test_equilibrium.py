"""One step after the other: bonds that break, memory of the tread, symmetry, honesty."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest

from tyrecontact.contact.adhesion import ReleaseForce
from tyrecontact.contact.bonds import ElementState
from tyrecontact.contact.equilibrium import Bodies, Equilibrium, Solver, State, advance
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Moment
from tyrecontact.contact.newton import robust, thesis
from tyrecontact.road.springs import Springs

TOLERANCE, TIME_STEP = 1e-13, 1 / 51200
SOLVER = Solver(robust, TOLERANCE, 50, extrapolates=True)
#: press to 0.08 mm in 0.8 ms, and pull off
PATH = np.concatenate([np.linspace(0, 8e-5, 41), np.linspace(8e-5, -1.2e-4, 101)[1:]])


@dataclass
class Record:
    """A step, and the bonds around it."""

    step: Equilibrium
    bonded_before: np.ndarray
    bonded_after: np.ndarray

    @property
    def force(self) -> np.ndarray:
        return self.step.solution.force


@pytest.fixture(scope="module")
def bodies(tread: LatticeKernel, rough_springs: Springs, tops: np.ndarray) -> Bodies:
    return Bodies(tread, rough_springs, ReleaseForce(0.05), tops)


def run(bodies: Bodies, solver: Solver = SOLVER, path: np.ndarray = PATH) -> list[Record]:
    state, records = State.at_rest(bodies), []
    for indentation in path:
        before = state.bonds.bonded.copy()
        step = advance(bodies, solver, state, Moment(indentation, TIME_STEP))
        records.append(Record(step, before, state.bonds.bonded.copy()))
    return records


@pytest.fixture(scope="module")
def pull_off(bodies: Bodies) -> list[Record]:
    return run(bodies)


def total(records: list[Record]) -> np.ndarray:
    return np.array([record.force.sum() for record in records])


def test_every_step_is_solved(pull_off: list[Record], bodies: Bodies) -> None:
    """b - u - d = 0, with u from all past forces by the sum over lags, written out."""
    matrices = bodies.kernel.kernel.values
    row, column = np.divmod(np.arange(64), 8)
    dy, dx = abs(row[:, None] - row), abs(column[:, None] - column)
    for n in (0, 20, 60, 100, len(pull_off) - 1):
        lags = range(min(n + 1, len(matrices)))
        displacement = sum(matrices[j][dy, dx] @ pull_off[n - j].force for j in lags)
        step = pull_off[n].step
        # rounding of 64 x 64 products of 1e-4 m
        np.testing.assert_allclose(step.displacement, displacement, atol=1e-16)
        gap = PATH[n] + bodies.tops - displacement - step.solution.compression
        assert np.abs(gap).max() < 2 * TOLERANCE


def test_no_bond_carries_more_than_its_release_force(pull_off: list[Record]) -> None:
    assert all(record.step.solution.converged for record in pull_off)
    lowest = min(record.force.min() for record in pull_off)
    assert -0.05 <= lowest < -0.04  # and some come close to it


def test_only_bonded_elements_pull(pull_off: list[Record]) -> None:
    for record in pull_off:
        assert np.all(record.bonded_before[record.force < 0])
        assert np.all(record.bonded_after[record.force < 0])


def test_a_released_element_carries_nothing_until_it_is_pressed_again(
    pull_off: list[Record],
) -> None:
    waiting = np.zeros(64, bool)
    for record in pull_off:
        broken = record.step.state == ElementState.RELEASED
        waiting = (waiting | broken) & ~(record.step.solution.compression > 0)
        assert np.all(record.force[waiting] == 0)
        assert not record.bonded_after[waiting].any()
    assert waiting.sum() > 50  # nearly all have been pressed and released


def test_releases_are_counted_and_come_in_avalanches(pull_off: list[Record]) -> None:
    counts = [record.step.releases for record in pull_off]
    for record, count in zip(pull_off, counts, strict=True):
        assert count == np.sum(record.step.state == ElementState.RELEASED)
        assert count == np.sum(record.bonded_before & ~record.bonded_after)
    assert sum(counts) == sum(np.sum(r.bonded_after & ~r.bonded_before) for r in pull_off)
    assert max(counts) > 1
    assert not pull_off[-1].bonded_after.any()


def test_states_say_what_elements_do(pull_off: list[Record]) -> None:
    for record in pull_off:
        state = record.step.state
        np.testing.assert_array_equal(state == ElementState.COMPRESSED, record.force > 0)
        np.testing.assert_array_equal(state == ElementState.TENSION, record.force < 0)


def test_stronger_bonds_pull_harder(bodies: Bodies, pull_off: list[Record]) -> None:
    free = total(run(replace(bodies, law=ReleaseForce(0.0))))
    weak = total(pull_off)
    strong = total(run(replace(bodies, law=ReleaseForce(0.2))))
    assert free.min() == 0
    assert 0 > weak.min() > strong.min()
    np.testing.assert_allclose(strong[:40], free[:40], rtol=1e-6)  # loading does not know bonds


@pytest.mark.parametrize("axis", [0, 1])
def test_the_order_of_the_elements_does_not_matter(
    bodies: Bodies, pull_off: list[Record], axis: int
) -> None:
    index = np.flip(np.arange(64).reshape(8, 8), axis).ravel()
    mirrored = replace(bodies, springs=bodies.springs.take(index), tops=bodies.tops[index])
    for one, other in zip(pull_off, run(mirrored), strict=True):
        # springs of up to 1e6 N/m turn the tolerance into 1e-7 N
        np.testing.assert_allclose(other.force, one.force[index], atol=1e-6)


@pytest.mark.parametrize(
    "solver",
    [replace(SOLVER, extrapolates=False), replace(SOLVER, method=thesis)],
    ids=["last step as guess", "thesis"],
)
def test_the_way_to_the_solution_does_not_matter(
    bodies: Bodies, pull_off: list[Record], solver: Solver
) -> None:
    # tolerance times stiffness, summed over 64 elements
    np.testing.assert_allclose(total(run(bodies, solver)), total(pull_off), atol=1e-5)


def test_extrapolation_saves_iterations(bodies: Bodies, pull_off: list[Record]) -> None:
    plain = run(bodies, replace(SOLVER, extrapolates=False))
    saved, spent = (sum(r.step.iterations for r in records) for records in (pull_off, plain))
    assert saved < spent
    assert max(r.step.iterations for r in pull_off) <= 6  # a good guess is a few steps away


def test_a_step_that_is_not_solved_says_so_and_time_goes_on(bodies: Bodies) -> None:
    records = run(bodies, replace(SOLVER, max_iterations=1))
    unsolved = [record.step for record in records if not record.step.solution.converged]
    assert unsolved
    assert all(step.solution.residual > TOLERANCE for step in unsolved)
    assert all(step.iterations == 1 for step in unsolved)


def test_the_first_touch_is_where_the_highest_top_is(bodies: Bodies) -> None:
    state = State.at_rest(bodies)
    assert advance(bodies, SOLVER, state, Moment(0.0, TIME_STEP)).solution.force.sum() == 0
    force = advance(bodies, SOLVER, state, Moment(5e-7, TIME_STEP)).solution.force
    np.testing.assert_array_equal(np.flatnonzero(force), [bodies.tops.argmax()])


def test_a_held_flat_road_creeps_to_the_static_solution(
    tread: LatticeKernel, linear_springs: Callable[[np.ndarray], Springs]
) -> None:
    """(1 + k G) d = D with the summed kernel: the tread relaxes, the springs do not."""
    stiffness = 2e5
    bodies = Bodies(tread, linear_springs(np.full(64, stiffness)), ReleaseForce(0.0), np.zeros(64))
    records = run(bodies, path=np.full(400, 1e-5))
    row, column = np.divmod(np.arange(64), 8)
    dy, dx = abs(row[:, None] - row), abs(column[:, None] - column)
    static = tread.kernel.static_compliance[dy, dx]
    expected = stiffness * np.linalg.solve(np.eye(64) + stiffness * static, np.full(64, 1e-5))
    # six kernel lengths: what has not died by then
    np.testing.assert_allclose(records[-1].force, expected, rtol=1e-6)
