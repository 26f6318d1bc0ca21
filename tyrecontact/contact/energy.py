"""The energy account of a run: where the work of the drive has gone (physics, sections 5 and 8).

All sums use the forces at the end of each step, as the stability of the time stepping does:

    work of the drive = held by springs + held by the machine + passed into the layer
                        + lost in releases + algorithmic loss

Each term is computed by itself. The algorithmic loss is what implicit steps take from convex
springs and from the machine, and never negative where a step converged.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tyrecontact.contact.interface import Interface, Mirrored
from tyrecontact.contact.machine import MachineEnergy


@dataclass(frozen=True)
class Energy:
    """Energies since the start [J].

    Attributes
    ----------
    drive : work done by the machine's end, or by its force.
    springs : held by the roughness springs now.  machine : held by its spring and mass now.
    layer : net work done on the tread.
    released : lost when bonds break and contacts recede.
    algorithmic : taken by the time stepping.
    turnover : work exchanged with the tread, every step counted as positive.
    """

    drive: float = 0.0
    springs: float = 0.0
    machine: float = 0.0
    layer: float = 0.0
    released: float = 0.0
    algorithmic: float = 0.0
    turnover: float = 0.0

    def plus(self, step: Energy) -> Energy:
        """This and what a step has added."""
        return Energy(
            self.drive + step.drive,
            self.springs + step.springs,
            self.machine + step.machine,
            self.layer + step.layer,
            self.released + step.released,
            self.algorithmic + step.algorithmic,
            self.turnover + step.turnover,
        )

    @property
    def imbalance(self) -> float:
        """Work of the drive less where it has gone [J]: rounding."""
        gone = self.springs + self.machine + self.layer + self.released + self.algorithmic
        return self.drive - gone

    @property
    def is_created(self) -> bool:
        """Whether the tread has given back more than it was given, which no real one can."""
        return self.layer < -1e-6 * self.turnover


@dataclass(frozen=True)
class Held:
    """Energy in the springs around one step [J].

    Attributes
    ----------
    before : at its start.
    begun : at its start, without the bonds that break in it.
    ended : at its end, with the bonds and areas that it was solved with.
    after : at its end, with those that it leaves behind.
    """

    before: float
    begun: float
    ended: float
    after: float

    @classmethod
    def around(
        cls,
        before: float,
        ended: float,
        solved: Interface,
        after: Interface,
        start: np.ndarray | None,
        end: np.ndarray,
    ) -> Held:
        """From `before` and `ended` [J], and the interfaces of the solution and after it.

        `start` [m] is where bonds broke on the way (None: none did), `end` [m] where it led.
        """
        begun = before if start is None else float(solved.respond(start).energy.sum())
        # a mirrored bond forms in compression, where it holds no energy of its own
        same = isinstance(after, Mirrored)
        return cls(before, begun, ended, ended if same else float(after.respond(end).energy.sum()))


def step_energy(held: Held, work: float, layer_work: float, machine: MachineEnergy) -> Energy:
    """What a step adds to the account [J].

    Parameters
    ----------
    work : of the element forces on the interface, sum F (road's motion less the tread's).
    layer_work : of the element forces on the tread.
    """
    stepping = work - (held.ended - held.begun)
    return Energy(
        machine.work,
        held.after - held.before,
        machine.held,
        layer_work,
        (held.before - held.begun) + (held.ended - held.after),
        stepping + machine.lost,
        abs(layer_work),
    )
