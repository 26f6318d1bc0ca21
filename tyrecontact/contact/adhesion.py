"""The force between road and tread at each element, and when a bond lets go (physics, section 8).

An element is free, or bonded once it has been in compression. In compression both follow the
roughness spring. A free element carries no tension; a bonded one follows the mirrored spring,
F(-d) = -F(d), until its tension exceeds the release force.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.springs import Springs


class ElementState(IntEnum):
    """What an element does at the end of a step."""

    APART = 0  #: neither pressed nor held by a bond
    COMPRESSED = 1
    TENSION = 2  #: bonded and pulled
    RELEASED = 3  #: its bond broke in this step


@dataclass(frozen=True)
class Interface:
    """Force law of all elements while none bonds or breaks.

    Attributes
    ----------
    springs : the roughness springs.
    bonded : which elements can carry tension, shape (elements,), boolean.
    """

    springs: Springs
    bonded: np.ndarray

    def force_and_stiffness(self, compression: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Force [N] and stiffness [N/m] at a compression [m], shape (elements,)."""
        force, stiffness = self.springs.force_and_stiffness(np.abs(compression))
        active = (compression > 0) | self.bonded
        return np.where(active, np.copysign(force, compression), 0.0), stiffness * active

    def energy(self, compression: np.ndarray) -> np.ndarray:
        """Energy in the springs [J] at a compression [m], shape (elements,)."""
        active = (compression > 0) | self.bonded
        return self.springs.energy(np.abs(compression)) * active


@dataclass(frozen=True)
class ReleaseForce:
    """The thesis' law: a bond breaks when its tension exceeds `release_force` [N].

    0 N is no adhesion: nothing bonds.
    """

    release_force: float

    def __post_init__(self) -> None:
        if not self.release_force >= 0:
            raise InputError(f"release_force must not be negative, got {self.release_force} N")

    def overloaded(self, force: np.ndarray, bonded: np.ndarray) -> np.ndarray:
        """Which bonds break under the element forces [N]."""
        return bonded & (-force > self.release_force)

    def bonds(self, compression: np.ndarray, bonded: np.ndarray) -> np.ndarray:
        """Which elements are bonded after a step that ended at a compression [m]."""
        if self.release_force == 0:
            return np.zeros_like(bonded)
        return bonded | (compression > 0)
