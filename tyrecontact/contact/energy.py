"""The energy account of a run: where the work of the drive has gone (physics, sections 5 and 8).

All sums use the forces at the end of each step, as the stability of the time stepping does:

    work of the drive = held by springs + held by the machine + passed into the layer
                        + lost in releases + algorithmic loss

Each term is computed by itself. The algorithmic loss is what implicit steps take from convex
springs and from the machine, and never negative where a step converged.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields

import numpy as np

from tyrecontact.contact.interface import Interface
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
        return Energy(*(getattr(self, f.name) + getattr(step, f.name) for f in fields(self)))

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
class Ledger:
    """Element compressions and interfaces around one step; arrays of shape (elements,).

    Attributes
    ----------
    before, solved, after : interface with the bonds at the start of the step, with those that
        its solution has left, and with those that it leaves behind.
    start, end : compression [m] before and after.
    approach : road's motion less the tread's, of each element [m]: end - start, but for the
        residual of the step.
    """

    before: Interface
    solved: Interface
    after: Interface
    start: np.ndarray
    end: np.ndarray
    approach: np.ndarray
    force: np.ndarray = field(repr=False)

    def energy(self, layer_work: float, machine: MachineEnergy) -> Energy:
        """What the step adds to the account [J]."""
        held = [
            float(interface.energy(compression).sum())
            for interface, compression in (
                (self.before, self.start),
                (self.solved, self.start),
                (self.solved, self.end),
                (self.after, self.end),
            )
        ]
        released = (held[0] - held[1]) + (held[2] - held[3])
        stepping = float(self.force @ self.approach) - (held[2] - held[1])
        return Energy(
            machine.work,
            held[3] - held[0],
            machine.held,
            layer_work,
            released,
            stepping + machine.lost,
            abs(layer_work),
        )
