"""Small bodies in contact: kernels, linear springs, a rough road of 8 x 8 elements."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import pytest

from tyrecontact.contact.energy import Energy
from tyrecontact.contact.equilibrium import Bodies, Solver, State, advance
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Moment
from tyrecontact.contact.newton import robust
from tyrecontact.road import heights, textures
from tyrecontact.road.springs import Springs, from_heights, linear
from tyrecontact.tread.kernels import Kernel, passive
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

SHAPE = (8, 8)
_SOLVER = Solver(robust, 1e-14, 60, extrapolates=True)


@pytest.fixture(scope="session")
def tread() -> LatticeKernel:
    """The default plate under 8 x 8 elements of 1 mm at 51.2 kHz."""
    rubber = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499)
    base = Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33)
    return LatticeKernel(passive([rubber, base], SHAPE, 1e-3, 1 / 51200, lags=64))


@pytest.fixture(scope="session")
def element_heights() -> np.ndarray:
    """A worn road of 8 x 8 mm [m], shape (elements, pixels of an element)."""
    road = textures.worn(
        8e-3, 50e-6, valley_rms=40e-6, plateau_rms=15e-6, offset=20e-6,
        stone_size=4e-3, plateau_wavelength=1e-3, seed=3,
    )  # fmt: skip
    return heights.element_heights(road, SHAPE[0]).reshape(SHAPE[0] * SHAPE[1], -1)


@pytest.fixture(scope="session")
def rough_springs(element_heights: np.ndarray) -> Springs:
    return from_heights(element_heights, 50e-6, 10e6)


@pytest.fixture(scope="session")
def tops(element_heights: np.ndarray) -> np.ndarray:
    """Element tops below the highest one [m], <= 0."""
    highest = element_heights.max(axis=-1)
    return highest - highest.max()


@pytest.fixture(scope="session")
def linear_springs() -> Callable[[np.ndarray], Springs]:
    """Springs of constant stiffness [N/m], one an element, under punches of 0.1 mm."""
    return lambda stiffness: linear(stiffness, 1e-4, 1e-4)


@dataclass(frozen=True)
class Cycle:
    """A run of a small contact, step by step; arrays with the steps first.

    Attributes
    ----------
    force : element forces [N], (steps, elements).
    compression : [m], (steps, elements).
    indentation : [m], (steps,).
    releases : bonds broken in each step, (steps,).
    energy : the account after each step.
    state : at the end.
    """

    force: np.ndarray
    compression: np.ndarray
    indentation: np.ndarray
    releases: np.ndarray
    energy: list[Energy]
    state: State

    @property
    def total(self) -> np.ndarray:
        return self.force.sum(axis=1)

    def grown(self, name: str) -> np.ndarray:
        """What each step has added to a term of the account [J]."""
        return np.diff([getattr(energy, name) for energy in self.energy], prepend=0.0)


@pytest.fixture(scope="session")
def follow() -> Callable[..., Cycle]:
    """Take bodies along drives [m or N], or along whole moments."""

    def run(
        bodies: Bodies,
        drives: Sequence[float] | np.ndarray | Sequence[Moment],
        time_step: float = 1 / 51200,
        solver: Solver = _SOLVER,
    ) -> Cycle:
        state, steps, energy = State.at_rest(bodies), [], []
        for drive in drives:
            moment = drive if isinstance(drive, Moment) else Moment(float(drive), time_step)
            steps.append(advance(bodies, solver, state, moment))
            assert steps[-1].solution.converged
            energy.append(state.energy)
        return Cycle(
            np.array([step.solution.force for step in steps]),
            np.array([step.solution.compression for step in steps]),
            np.array([step.indentation for step in steps]),
            np.array([step.releases for step in steps]),
            energy,
            state,
        )

    return run


@pytest.fixture(scope="session")
def stiff_layer() -> Callable[[int], LatticeKernel]:
    """A layer that hardly gives, under a row of elements: each is driven by itself."""
    return lambda count: LatticeKernel(Kernel(np.full((1, 1, count), 1e-15), 1e-3, np.inf))
