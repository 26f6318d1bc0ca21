"""One time step: the equilibrium of road, tread and machine, bonds that break included."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from tyrecontact.contact.adhesion import Law
from tyrecontact.contact.bonds import Bonds, ElementState, Outcome
from tyrecontact.contact.energy import Energy, Held, step_energy
from tyrecontact.contact.interface import Interface
from tyrecontact.contact.lattice import History, LatticeKernel
from tyrecontact.contact.machine import Machine, Moment, Place, machine_energy
from tyrecontact.contact.newton import Solution, robust
from tyrecontact.road.springs import Springs

_COMPRESSED, _TENSION, _RELEASED = (
    np.int8(state)
    for state in (ElementState.COMPRESSED, ElementState.TENSION, ElementState.RELEASED)
)
#: compliance, interface, target, start, tolerance, max_iterations -> Solution (contact/newton.py;
#: `robust` takes `last` besides)
NewtonMethod = Callable[..., Solution]


@dataclass(frozen=True)
class Bodies:
    """What stays the same from step to step.

    Attributes
    ----------
    kernel : of the tread.  springs, law : of the interface.  machine : that moves the road.
    tops : heights of the element tops below the highest one [m], <= 0, shape (elements,).
    """

    kernel: LatticeKernel
    springs: Springs
    law: Law
    tops: np.ndarray
    machine: Machine = field(default_factory=Machine)


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
    bonds : what the elements of the interface remember.
    place : where the machine has moved the road.
    earlier_compressions : [m] one and two steps before the last, where there were; shape
        (elements,) each.
    displacement : of the tread [m] at the end of the last step, shape (elements,).
    energy : the account since the start.
    held : energy in the springs at the end of the last step [J].
    """

    history: History
    bonds: Bonds
    place: Place
    earlier_compressions: tuple[np.ndarray, ...]
    displacement: np.ndarray
    energy: Energy
    held: float = 0.0

    @classmethod
    def at_rest(cls, bodies: Bodies, start: float = 0.0) -> State:
        """Everything still, and the road at first touch or, where `start` [m] < 0, above it."""
        bonds, still = Bonds.none(bodies.tops + start), np.zeros(bodies.tops.size)
        place = Place(indentation=start, drive=start)
        return cls(History(bodies.kernel), bonds, place, (), still, Energy())


@dataclass(frozen=True)
class Equilibrium:
    """A solved step.

    Attributes
    ----------
    solution : of the last Newton run of the step.
    indentation : of the road into the tread [m].
    displacement : of the tread [m], past forces included, shape (elements,).
    state : `ElementState` of each element.
    iterations : of the Newton run that needed the most.
    releases : number of bonds that broke.
    """

    solution: Solution
    indentation: float
    displacement: np.ndarray
    state: np.ndarray
    iterations: int
    releases: int


def advance(bodies: Bodies, solver: Solver, state: State, moment: Moment) -> Equilibrium:
    """Solve one step and move `state` on to its end.

    Bonds that do not bear the solution are broken, all at once, and the step is solved again
    until all bear it.
    """
    past = np.zeros(bodies.tops.size) if moment.at_rest else state.history.displacement().ravel()
    free, shared = bodies.machine.response(state.place, moment)
    layer = bodies.kernel.at_rest if moment.at_rest else bodies.kernel.now
    compliance, target = layer.with_shared(shared), free + bodies.tops - past
    bonds, iterations = state.bonds, 0
    method, guess = _start(solver, state)
    while True:
        interface = bodies.law.interface(bodies.springs, bonds)
        solution = method(
            compliance, interface, target, guess, solver.tolerance, solver.max_iterations
        )
        iterations = max(iterations, solution.iterations)
        outcome = Outcome(solution.compression, solution.force, moment.time_step)
        broken = bodies.law.broken(bodies.springs, bonds, outcome)
        if not solution.converged or not broken.any():
            break  # forces of a solve that failed break no bond
        bonds, guess = bonds.without(broken), solution.compression
    released = state.bonds.bonded & ~bonds.bonded
    rigid = shared * solution.force.sum() if shared else 0.0
    displacement = past + solution.displacement - rigid
    held = float(solution.energy.sum())
    _move_on(bodies, state, moment, bonds, interface, outcome, displacement, free - rigid, held)
    return Equilibrium(
        solution,
        free - rigid,
        displacement,
        _element_states(solution.force, state.bonds.bonded, released),
        iterations,
        int(np.count_nonzero(released)),
    )


def _start(solver: Solver, state: State) -> tuple[NewtonMethod, np.ndarray]:
    """Where Newton's method begins: the last compression [m], or its extrapolation.

    A parabola for `robust`, a straight line as in the thesis for its own method: steps that have
    not converged would be carried too far by a parabola.
    """
    last, *earlier = state.bonds.compression, *state.earlier_compressions
    if not (solver.extrapolates and earlier):
        return solver.method, last
    if solver.method is not robust:
        return solver.method, 2 * last - earlier[0]
    guess = 2 * last - earlier[0] if len(earlier) < 2 else 3 * (last - earlier[0]) + earlier[1]
    return partial(robust, last=last), guess


def _move_on(
    bodies: Bodies,
    state: State,
    moment: Moment,
    bonds: Bonds,
    interface: Interface,
    outcome: Outcome,
    displacement: np.ndarray,
    indentation: float,
    ended: float,
) -> None:
    """Take the state to the end of the step: bonds, machine, energies, memory of the tread."""
    law, springs, force = bodies.law, bodies.springs, outcome.force
    after = law.after(springs, bonds, outcome)
    place = state.place.moved(indentation, moment)
    held = Held.around(
        state.held,
        ended,
        interface,
        law.interface(springs, after),
        None if bonds is state.bonds else state.bonds.compression,
        outcome.compression,
    )
    approach = place.indentation - state.place.indentation - (displacement - state.displacement)
    machine = machine_energy(bodies.machine, state.place, place, moment, float(force.sum()))
    layer_work = float(force @ (displacement - state.displacement))
    state.energy = state.energy.plus(
        step_energy(held, float(force @ approach), layer_work, machine)
    )
    state.held = held.after
    remember = state.history.settle if moment.at_rest else state.history.remember
    remember(force.reshape(bodies.kernel.shape))
    state.earlier_compressions = (state.bonds.compression, *state.earlier_compressions[:1])
    state.bonds, state.place, state.displacement = after, place, displacement


def _element_states(force: np.ndarray, bonded: np.ndarray, released: np.ndarray) -> np.ndarray:
    state = bonded * _TENSION
    np.putmask(state, released, _RELEASED)
    np.putmask(state, force > 0, _COMPRESSED)
    return state
