r"""The direct method: a run as the thesis writes it down, with nothing done to make it fast.

The displacement of the tread is a dense sum over all past steps and all elements (thesis, Eqs. 4
and 5; physics, sections 5 and 6),

    u_n = sum_(j=0)^(lags-1) G_j F_(n-j),    G_j the (elements, elements) matrix of lag j,

and each Newton step builds the Jacobian -(G_0 K + 1) of the elements that carry force (Eq. 8, with
the columns scaled), solves it by LAPACK and takes it whole. It begins at the last step's solution.

It is the oracle of the tests, at a tight tolerance, and the baseline of the benchmarks. Of the
package it uses the settings made ready (`Simulation.bodies`): kernel, springs, law and machine.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tyrecontact import Simulation
from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.interface import Interface
from tyrecontact.contact.machine import Moment, Place
from tyrecontact.tread.kernels import Kernel

#: more than that of matrices is not kept but formed as they are needed
_KEPT_BYTES = 2e9


class NotConvergedError(RuntimeError):
    """Plain Newton has not found the forces of a step: nothing can be compared with it."""


@dataclass(frozen=True)
class DirectStep:
    """A solved step; arrays of shape (elements,): force [N], compression, displacement [m].

    `indentation` [m], `iterations` of the Newton run that needed most, `releases` of bonds.
    """

    force: np.ndarray
    compression: np.ndarray
    displacement: np.ndarray
    indentation: float
    iterations: int
    releases: int


class DenseTread:
    """The tread as dense matrices, one a lag, and the forces that it remembers."""

    def __init__(self, kernel: Kernel) -> None:
        self._values = kernel.values
        ny, nx = kernel.values.shape[1:]
        row, column = np.divmod(np.arange(ny * nx), nx)
        self._offset = tuple(np.abs(np.subtract.outer(i, i)) for i in (row, column))
        keeps = 8 * kernel.lags * (ny * nx) ** 2 <= _KEPT_BYTES
        self._kept = [self._formed(values) for values in kernel.values] if keeps else None
        #: element forces of past steps, the last one first
        self._past: deque[np.ndarray] = deque(maxlen=kernel.lags - 1)

    def matrix(self, lag: int) -> np.ndarray:
        """G of a lag [m/N], shape (elements, elements)."""
        return self._formed(self._values[lag]) if self._kept is None else self._kept[lag]

    def at_rest(self) -> np.ndarray:
        """The sum of all G [m/N]: what forces do that have always acted."""
        return self._formed(self._values.sum(axis=0))

    def displacement(self) -> np.ndarray:
        """Displacement of the coming step due to all past forces [m], shape (elements,)."""
        total = np.zeros(self._offset[0].shape[0])
        for lag, force in enumerate(self._past, start=1):
            total += self.matrix(lag) @ force
        return total

    def remember(self, force: np.ndarray, at_rest: bool) -> None:
        """Take the forces [N] of a solved step; at rest they have acted for ever."""
        for _ in range((self._past.maxlen or 0) if at_rest else 1):
            self._past.appendleft(force)

    def _formed(self, values: np.ndarray) -> np.ndarray:
        return values[self._offset]


class DirectMethod:
    """The run of a simulation by the direct method; iterating starts from rest every time.

    Parameters
    ----------
    simulation : whose bodies and schedule are taken; how it is solved is not.
    tolerance : largest residual of the contact equation [m].

    Raises
    ------
    NotConvergedError : (while iterating) a step that plain Newton does not solve.
    """

    def __init__(self, simulation: Simulation, tolerance: float) -> None:
        self.bodies, self.tolerance = simulation.bodies, tolerance
        self.moments = moments(simulation)
        forced = simulation.scenario.loading.drive == "force"
        self._start = 0.0 if forced else min(self.moments[0].drive, 0.0)

    def __iter__(self) -> Iterator[DirectStep]:
        tread = DenseTread(self.bodies.kernel.kernel)
        bonds = Bonds.none(self.bodies.tops + self._start)
        place = Place(indentation=self._start, drive=self._start)
        for moment in self.moments:
            step, bonds = self._step(tread, bonds, place, moment)
            place = place.moved(step.indentation, moment)
            tread.remember(step.force, moment.at_rest)
            yield step

    def _step(
        self, tread: DenseTread, bonds: Bonds, place: Place, moment: Moment
    ) -> tuple[DirectStep, Bonds]:
        """Solve; break the bonds that do not bear it; solve again, until all do."""
        law, springs, held = self.bodies.law, self.bodies.springs, bonds.bonded
        past = 0.0 if moment.at_rest else tread.displacement()
        now = tread.at_rest() if moment.at_rest else tread.matrix(0)
        free, shared = self.bodies.machine.response(place, moment)
        target, guess, iterations = free + self.bodies.tops - past, bonds.compression, 0
        while True:
            interface = law.interface(springs, bonds)
            guess, force, used = self._newton(now + shared, interface, target, guess)
            iterations = max(iterations, used)
            outcome = Outcome(guess, force, moment.time_step)
            broken = law.broken(springs, bonds, outcome)
            if not broken.any():
                break
            bonds = bonds.without(broken)
        releases = int(np.sum(held & ~bonds.bonded))
        indentation = free - shared * force.sum()
        step = DirectStep(force, guess, past + now @ force, indentation, iterations, releases)
        return step, law.after(springs, bonds, outcome)

    def _newton(
        self, matrix: np.ndarray, interface: Interface, target: np.ndarray, start: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, int]:
        """Compression d [m] and force [N] with target - G F(d) - d = 0, and iterations used."""
        d = start
        for iteration in range(101):
            force, stiffness, _ = interface.respond(d)
            imbalance = target - matrix @ force - d
            if np.abs(imbalance).max() <= self.tolerance:
                return d, force, iteration
            contact = np.flatnonzero(stiffness)
            columns = matrix[:, contact] * stiffness[contact]
            jacobian = np.eye(contact.size) + columns[contact]
            step = np.linalg.solve(jacobian, imbalance[contact])
            d = d + imbalance - columns @ step  # which is d + step where there is contact
        raise NotConvergedError(
            f"plain Newton has not converged to {self.tolerance:.1g} m in 100 iterations"
        )


def moments(simulation: Simulation) -> list[Moment]:
    """What is asked of each step of a simulation."""
    schedule = simulation.schedule
    durations = np.diff(schedule.time, prepend=-simulation.time_step)
    rows = zip(schedule.drive, durations, schedule.at_rest, strict=True)
    return [Moment(float(drive), float(time), bool(rest)) for drive, time, rest in rows]
