r"""The machine that moves the road: rigid, through a spring, or by a force on a mass (physics, 7).

    m d'' = F_ext + k_m (X - d) - F_contact,    implicit (backward Euler) in all forces

With the inertia J = m / dt^2 and c = 1 / (k_m + J) the indentation at the end of a step is

    d = c [F_ext + k_m X + J (d_n + dt v_n)] - c F_contact,

that is, the machine is a compliance c that all elements share. A rigid machine has c = 0. In a step
at rest the velocity is nil, and J just large enough for c not to exceed `_SOFTEST`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tyrecontact.errors import InputError

#: a machine at rest is not softer than this [m/N]: a force alone has no equilibrium once apart
_SOFTEST = 1e-4


@dataclass(frozen=True)
class Moment:
    """What is asked of a step.

    Attributes
    ----------
    drive : position of the machine's end X [m], or its force F_ext [N].
    time_step : since the step before [s].
    at_rest : the tread and the machine have come to rest since then.
    """

    drive: float
    time_step: float
    at_rest: bool = False


@dataclass(frozen=True)
class Machine:
    """Mass [kg] on the road's side, and the stiffness [N/m] of the spring that moves it.

    inf is a rigid drive (its mass does not matter), 0 a force that acts on the mass.
    """

    stiffness: float = np.inf
    mass: float = 0.0

    def __post_init__(self) -> None:
        if not self.stiffness >= 0:
            raise InputError(
                f"loading.machine_stiffness must not be negative, got {self.stiffness} N/m"
            )
        if not 0 <= self.mass < np.inf:
            raise InputError(f"loading.mass must be finite and not negative, got {self.mass} kg")
        if self.stiffness == 0 and self.mass == 0:
            raise InputError("loading.mass must be positive for a force-driven road, got 0 kg")

    @property
    def is_rigid(self) -> bool:
        return self.stiffness == np.inf

    def inertia(self, moment: Moment) -> float:
        """J [N/m]."""
        if moment.at_rest:
            return max(0.0, 1 / _SOFTEST - self.stiffness)
        return self.mass / moment.time_step**2

    def response(self, place: Place, moment: Moment) -> tuple[float, float]:
        """Indentation without contact [m], and how much less it is per contact force [m/N]."""
        if self.is_rigid:
            return moment.drive, 0.0
        inertia = self.inertia(moment)
        coasted = 0.0 if moment.at_rest else moment.time_step * place.velocity
        pushed = self.stiffness * moment.drive if self.stiffness > 0 else moment.drive
        compliance = 1 / (self.stiffness + inertia)
        return compliance * (pushed + inertia * (place.indentation + coasted)), compliance


@dataclass(frozen=True)
class Place:
    """Where the road is: indentation [m], velocity [m/s], and the drive that put it there."""

    indentation: float = 0.0
    velocity: float = 0.0
    drive: float = 0.0

    def moved(self, indentation: float, moment: Moment) -> Place:
        """The place after a step that ends at an indentation [m]."""
        velocity = (indentation - self.indentation) / moment.time_step
        return Place(indentation, 0.0 if moment.at_rest else velocity, moment.drive)


@dataclass(frozen=True)
class MachineEnergy:
    """What the machine did in a step: work of the drive, energy gained, energy lost [J]."""

    work: float
    held: float
    lost: float


def machine_energy(
    machine: Machine, before: Place, after: Place, moment: Moment, contact_force: float
) -> MachineEnergy:
    """Energies of one step; work - held - lost is what the contact took."""
    moved = after.indentation - before.indentation
    if machine.is_rigid:
        return MachineEnergy(contact_force * moved, 0.0, 0.0)
    mass, stiffness = machine.mass, machine.stiffness
    kinetic = mass * (after.velocity**2 - before.velocity**2) / 2
    if moment.at_rest:
        lost = machine.inertia(moment) * moved**2 - kinetic
    else:
        lost = mass * (after.velocity - before.velocity) ** 2 / 2
    if stiffness == 0:
        return MachineEnergy(moment.drive * moved, kinetic, lost)
    stretch = (before.drive - before.indentation, after.drive - after.indentation)
    work = stiffness * stretch[1] * (after.drive - before.drive)
    held = kinetic + stiffness * (stretch[1] ** 2 - stretch[0] ** 2) / 2
    return MachineEnergy(work, held, lost + stiffness * (stretch[1] - stretch[0]) ** 2 / 2)
