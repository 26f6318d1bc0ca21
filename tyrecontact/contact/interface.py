r"""Force between road and tread at each element while no bond forms or breaks (physics, section 8).

In compression an element follows its roughness spring F_L(d). A bonded element is pulled along

    F = -F_L(-d)                          ("mirrored", the thesis' law), or
    F = F_L(c) + k(c) (d - c),  d < c     ("hinged": a punch of the area it had at compression c)

and a free one carries no tension. All are non-decreasing in d and have an energy, which is what
Newton's method needs.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from tyrecontact.road.spring_tables import Response
from tyrecontact.road.springs import Springs


class Interface(Protocol):
    """Force law of all elements within a step."""

    @property
    def bonded(self) -> np.ndarray:
        """Which elements can carry tension, shape (elements,), boolean."""

    def respond(self, compression: np.ndarray) -> Response:
        """Force [N], stiffness [N/m] and energy held [J] of each element at a compression [m]."""


@dataclass(frozen=True)
class Mirrored:
    """A bond pulls as its spring pushes: F(-d) = -F(d)."""

    springs: Springs
    bonded: np.ndarray

    def respond(self, compression: np.ndarray) -> Response:
        return self.springs.respond(compression, self.bonded)


class Hinged:
    """Below the compression `hinge` [m] an element unloads as a punch of the area it had there.

    A bonded element follows that line into tension, a free one to zero force.
    """

    def __init__(self, springs: Springs, bonded: np.ndarray, hinge: np.ndarray) -> None:
        self.springs, self.bonded, self.hinge = springs, bonded, hinge
        self._force, slope = springs.force(hinge), springs.punch_stiffness(hinge)
        self._energy = springs.energy(hinge)
        # a line of no slope has no zero: there the spring itself starts
        self._slope = np.where(hinge > 0, slope, springs.stiffness(np.zeros_like(hinge)))
        safe = np.where(self._slope > 0, self._slope, 1.0)
        self._zero = np.where(self._slope > 0, hinge - self._force / safe, 0.0)

    def respond(self, compression: np.ndarray) -> Response:
        """A free element with a dent keeps what its line held where the force was zero."""
        below, gone = compression < self.hinge, compression - self.hinge
        pressed = self.springs.respond(np.maximum(compression, self.hinge), self.bonded)
        carries = self.bonded | (compression > self._zero)
        line = np.where(carries, self._force + self._slope * gone, 0.0)
        gone = np.where(carries, gone, self._zero - self.hinge)
        held = self._energy + self._force * gone + self._slope * gone**2 / 2
        return Response(
            np.where(below, line, pressed.force),
            np.where(below, np.where(carries, self._slope, 0.0), pressed.stiffness),
            np.where(below, held, pressed.energy),
        )
