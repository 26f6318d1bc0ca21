"""One time step: the equilibrium of road and tread, bonds that break included."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tyrecontact.contact.adhesion import ElementState, Interface, ReleaseForce
from tyrecontact.contact.lattice import History, LatticeKernel
from tyrecontact.contact.newton import Solution, better_start, robust
from tyrecontact.road.springs import Springs

#: kernel, interface, target, start, tolerance, max_iterations -> Solution (contact/newton.py)
NewtonMethod = Callable[..., Solution]


@dataclass(frozen=True)
class Bodies:
    """What stays the same from step to step.

    Attributes
    ----------
    kernel : of the tread.  springs, law : of the interface.
    tops : heights of the element tops below the highest one [m], <= 0, shape (elements,).
    """

    kernel: LatticeKernel
    springs: Springs
    law: ReleaseForce
    tops: np.ndarray


@dataclass(frozen=True)
class Solver:
    """How a step is solved: the method, and its settings (`tolerance` [m])."""

    method: NewtonMethod
    tolerance: float
    max_iterations: int
    extrapolates: bool


@dataclass
class State:
    """What the physics remembers between steps.

    Attributes
    ----------
    history : past forces and what they still do to the tread.
    bonded : which elements can carry tension, shape (elements,).
    compression, earlier_compression : [m] at the end of the last step and of the one before.
    displacement : of the tread [m] at the end of the last step, shape (elements,).
    work : work done on the tread since the start [J].
    turnover : the same, every step counted as positive [J].
    """

    history: History
    bonded: np.ndarray
    compression: np.ndarray
    earlier_compression: np.ndarray
    displacement: np.ndarray
    work: float = 0.0
    turnover: float = 0.0

    @classmethod
    def at_rest(cls, bodies: Bodies) -> State:
        count, tops = bodies.tops.size, bodies.tops
        return cls(
            History(bodies.kernel), np.zeros(count, bool), tops.copy(), tops.copy(), np.zeros(count)
        )

    @property
    def creates_energy(self) -> bool:
        """Whether the tread has given back more than it was given, which no real one can."""
        return self.work < -1e-6 * self.turnover


@dataclass(frozen=True)
class Equilibrium:
    """A solved step.

    Attributes
    ----------
    solution : of the last Newton run of the step.
    displacement : of the tread [m], past forces included, shape (elements,).
    state : `ElementState` of each element.
    iterations : of the Newton run that needed the most.
    releases : number of bonds that broke.
    """

    solution: Solution
    displacement: np.ndarray
    state: np.ndarray
    iterations: int
    releases: int


def advance(bodies: Bodies, solver: Solver, state: State, indentation: float) -> Equilibrium:
    """Solve one step at a given indentation [m] and move `state` on to its end.

    Bonds that the solution overloads are broken, all at once, and the step is solved again
    until none is.
    """
    past = state.history.displacement().ravel()
    target = indentation + bodies.tops - past
    bonded, guess = state.bonded, _first_guess(bodies, solver, state, target)
    iterations = 0
    while True:
        interface = Interface(bodies.springs, bonded)
        solution = solver.method(
            bodies.kernel,
            interface,
            target,
            guess,
            solver.tolerance,
            solver.max_iterations,
        )
        iterations = max(iterations, solution.iterations)
        broken = bodies.law.overloaded(solution.force, bonded)
        if not solution.converged or not broken.any():
            break  # forces of a solve that failed break no bond
        bonded, guess = bonded & ~broken, solution.compression
    released = state.bonded & ~bonded
    state.history.remember(solution.force.reshape(bodies.kernel.shape))
    state.bonded = bodies.law.bonds(solution.compression, bonded)
    state.earlier_compression, state.compression = state.compression, solution.compression
    displacement = past + solution.displacement
    work = float(solution.force @ (displacement - state.displacement))
    state.displacement = displacement
    state.work, state.turnover = state.work + work, state.turnover + abs(work)
    return Equilibrium(
        solution,
        displacement,
        _element_states(solution.compression, bonded, released),
        iterations,
        int(released.sum()),
    )


def _first_guess(bodies: Bodies, solver: Solver, state: State, target: np.ndarray) -> np.ndarray:
    """Where Newton's method begins: the last compression [m], or its extrapolation."""
    if not solver.extrapolates:
        return state.compression
    guess = 2 * state.compression - state.earlier_compression
    if solver.method is not robust:
        return guess
    interface = Interface(bodies.springs, state.bonded)
    return better_start(bodies.kernel, interface, target, guess, state.compression)


def _element_states(
    compression: np.ndarray, bonded: np.ndarray, released: np.ndarray
) -> np.ndarray:
    state = np.where(bonded, ElementState.TENSION, ElementState.APART)
    state = np.where(released, ElementState.RELEASED, state)
    return np.where(compression > 0, ElementState.COMPRESSED, state).astype(np.int8)
