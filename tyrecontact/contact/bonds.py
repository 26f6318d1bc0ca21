"""What the elements of the interface remember: bonds, contact ages, largest compressions."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np


class ElementState(IntEnum):
    """What an element does at the end of a step."""

    APART = 0  #: neither pressed nor held by a bond
    COMPRESSED = 1
    TENSION = 2  #: bonded and pulled
    RELEASED = 3  #: its bond broke in this step


@dataclass(frozen=True)
class Outcome:
    """Where a step has ended: compression [m] and force [N] of each element, time step [s]."""

    compression: np.ndarray
    force: np.ndarray
    time_step: float


@dataclass(frozen=True)
class Bonds:
    """Memory of the interface; all arrays have shape (elements,).

    Attributes
    ----------
    bonded : which elements can carry tension.
    age : time since the element came into contact [s]; 0 where it is not.
    reach : largest compression of this contact [m], or what is left of it where the contact
        recedes; its area is the one that holds.
    fraction : share of the bonds that have formed [-]; only bond kinetics changes it.
    compression : at the end of the last step [m].
    """

    bonded: np.ndarray
    age: np.ndarray
    reach: np.ndarray
    fraction: np.ndarray
    compression: np.ndarray

    @classmethod
    def none(cls, compression: np.ndarray) -> Bonds:
        """Nothing touches; `compression` [m] is minus the gaps."""
        zero = np.zeros_like(compression)
        return cls(np.zeros(zero.shape, bool), zero, zero, zero, compression)

    def without(self, broken: np.ndarray) -> Bonds:
        """These bonds less the broken ones; the element's dent stays until it is apart."""
        return replace(
            self,
            bonded=self.bonded & ~broken,
            age=np.where(broken, 0.0, self.age),
            fraction=np.where(broken, 0.0, self.fraction),
        )

    def after(self, outcome: Outcome, bonded: np.ndarray) -> Bonds:
        """After a step that ended so, with these bonds."""
        compression = outcome.compression
        dented = bonded | (compression > 0)
        touching = bonded | (outcome.force > 0)
        age = self.age + outcome.time_step
        age *= touching
        reach = np.maximum(self.reach, compression)
        return Bonds(bonded, age, np.where(dented, reach, 0.0), self.fraction * bonded, compression)
