"""The drive never gets out more than it put in: cycles of the whole contact."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact.adhesion import ReleaseForce
from tyrecontact.contact.equilibrium import Bodies, Solver, State, advance
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Moment
from tyrecontact.contact.newton import robust
from tyrecontact.road.springs import Springs, from_heights
from tyrecontact.tread.kernels import Kernel

SOLVER = Solver(robust, 1e-13, 50, extrapolates=True)
PITCH = 5e-5


@pytest.fixture(scope="module")
def heights() -> np.ndarray:
    """Elements of 20 x 20 heights [m] on tops that differ by some 10 um."""
    rng = np.random.default_rng(3)
    return rng.standard_normal((64, 400)) * 4e-6 + rng.standard_normal((64, 1)) * 1e-5


@pytest.fixture(scope="module")
def springs(heights: np.ndarray) -> Springs:
    return from_heights(heights, PITCH, 10e6)


def cycle(steps: int) -> np.ndarray:
    """Indentation from below contact to 0.06 mm and back [m]."""
    return 6e-5 * np.sin(np.pi * np.arange(steps + 1) / steps) ** 2 - 5e-6


def work(
    kernel: Kernel, springs: Springs, tops: np.ndarray, release_force: float, path: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Work of the drive up to each step, sum F dD, and the energy then in the springs [J]."""
    bodies = Bodies(LatticeKernel(kernel), springs, ReleaseForce(release_force), tops)
    state = State.at_rest(bodies)
    done, held, last = [0.0], [0.0], path[0]
    for indentation in path:
        solution = advance(bodies, SOLVER, state, Moment(indentation, 1 / 51200)).solution
        done.append(done[-1] + solution.force.sum() * (indentation - last))
        active = solution.force != 0
        held.append(float((springs.energy(np.abs(solution.compression)) * active).sum()))
        last = indentation
    return np.array(done), np.array(held)


@pytest.mark.parametrize("release_force", [0.0, 0.05, 0.5])
@pytest.mark.parametrize("steps", [20, 80, 320])
def test_a_cycle_of_loading_costs_work(
    passive_kernel: Kernel, springs: Springs, heights: np.ndarray, release_force: float, steps: int
) -> None:
    """Convex springs and a passive tread: at every step the work covers what the springs hold."""
    tops = heights.max(axis=-1) - heights.max()
    done, held = work(passive_kernel, springs, tops, release_force, cycle(steps))
    assert np.all(done >= held - 1e-12 * done.max())  # rounding; the tolerance is 1e-13 of 1e-4 m
    assert done[-1] > 0.01 * done.max()  # and a rubber tread loses a share of it


def test_bonds_cost_work(passive_kernel: Kernel, springs: Springs, heights: np.ndarray) -> None:
    tops = heights.max(axis=-1) - heights.max()
    path = np.concatenate([cycle(160), np.linspace(-5e-6, -1e-4, 80)])
    costs = [work(passive_kernel, springs, tops, limit, path)[0][-1] for limit in (0, 0.05, 0.5)]
    assert costs == sorted(costs)
    assert costs[-1] > 1.05 * costs[0]
