r"""Newton's method for the forces within one time step (physics, section 6).

Unknown are the compressions d of all elements that solve

    f(d) = b - g_0 F(d) - d = 0,

b how far the road reaches into the tread as past forces have left it, g_0 the compliance
within the step, F the monotone force of each element. A free element has F = 0 and d = b - g_0 F
below zero, so that contact is part of the equation and no list of contacts is needed.

`robust` guards the Newton step (contact/linear.py) by a line search on the energy

    Psi(d) = F.g_0 F / 2 + sum (F d - U) - b.F,    dPsi/dd = -K f,

convex in F, whose minimum is the solution. `thesis` is plain Newton on the elements in contact.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from types import ModuleType

import numpy as np

from tyrecontact.contact.interface import Interface, Mirrored
from tyrecontact.contact.lattice import Compliance
from tyrecontact.contact.linear import SINGLE, newton_step
from tyrecontact.fast import loops

#: relative accuracy of the linear solve: what Newton makes up for, and as good as a direct one
_INEXACT, _EXACT = 1e-4, 1e-11
#: share of the tolerance that the linear solve may leave in the last Newton step
_LAST = 0.1
_HALVINGS = 40
#: a first guess with an imbalance beyond this share of the largest b is poor
_POOR = 0.01
#: an imbalance beyond this [m] is a run that is lost; going on would overflow
_LOST = 1e6


@dataclass(frozen=True)
class Solution:
    """What Newton's method found, and whether to believe it.

    Attributes
    ----------
    compression, force, stiffness : d [m], F [N] and dF/dd [N/m], shape (elements,).
    energy : held by each element [J], shape (elements,).
    displacement : g_0 F [m], shape (elements,).
    iterations : Newton iterations used.
    residual, converged : largest |f| [m], and whether it is within the tolerance.
    """

    compression: np.ndarray
    force: np.ndarray
    stiffness: np.ndarray
    energy: np.ndarray
    displacement: np.ndarray
    iterations: int
    residual: float
    converged: bool


def robust(
    compliance: Compliance,
    interface: Interface,
    target: np.ndarray,
    start: np.ndarray,
    tolerance: float,
    max_iterations: int,
    last: np.ndarray | None = None,
) -> Solution:
    """Newton iteration on all elements, guarded by the energy.

    Parameters
    ----------
    compliance : g_0.  interface : F, K and U.
    target : b [m], shape (elements,).  start : first guess of d [m], same shape.
    tolerance : largest |f| accepted [m].
    last : another guess [m], taken where `start` is poor and this one has the lower energy: an
        extrapolation may reach far into springs that turn stiff, from where there is no way back.
    """
    fast = loops()
    if fast is not None and isinstance(interface, Mirrored) and compliance.products.as_matrices:
        guesses = np.array([start] if last is None else [start, last], float)
        limits = (tolerance, _POOR, _INEXACT, SINGLE, _LAST, max_iterations, _HALVINGS)
        return _compiled_robust(fast, compliance, interface, target, guesses, limits)
    point = _Point.at(compliance, interface, target, start)
    if last is not None and not point.residual <= _POOR * np.abs(target).max():
        other = _Point.at(compliance, interface, target, last)
        point = min(point, other, key=lambda choice: choice.potential(target))
    iterations, stuck = 0, False
    while not point.residual <= tolerance and iterations < max_iterations and not stuck:
        # no more than needed to end now, and no more than Newton's own error is worth
        accuracy = min(_INEXACT, max(SINGLE, _LAST * tolerance / point.residual))
        step = newton_step(compliance, point.stiffness, point.imbalance, accuracy)
        lower = _descend(compliance, interface, target, point, step)
        point, stuck = lower or point, lower is None
        iterations += 1
    return Solution(
        point.compression, point.force, point.stiffness, point.energy, point.displacement,
        iterations, point.residual, point.residual <= tolerance,
    )  # fmt: skip


def _compiled_robust(
    fast: ModuleType,
    compliance: Compliance,
    interface: Mirrored,
    target: np.ndarray,
    guesses: np.ndarray,
    limits: tuple[float, ...],
) -> Solution:
    springs, matrices = interface.springs, compliance.products.as_matrices or ()
    found, iterations = fast.robust(
        springs.cells,
        springs.depth,
        interface.bonded,
        fast.Tread(*matrices, compliance.self_compliance, compliance.shared),
        target,
        guesses,
        fast.Limits(*limits),
    )
    return Solution(
        found.compression, found.force, found.stiffness, found.energy, found.displacement,
        iterations, found.residual, found.residual <= limits[0],
    )  # fmt: skip


@dataclass(frozen=True)
class _Point:
    """Everything the iteration knows at one d."""

    compression: np.ndarray
    force: np.ndarray
    stiffness: np.ndarray
    energy: np.ndarray
    displacement: np.ndarray
    imbalance: np.ndarray  # f

    @classmethod
    def at(
        cls,
        compliance: Compliance,
        interface: Interface,
        target: np.ndarray,
        compression: np.ndarray,
    ) -> _Point:
        force, stiffness, energy = interface.respond(compression)
        displacement = compliance.displacement(force)
        imbalance = target - displacement
        imbalance -= compression
        return cls(compression, force, stiffness, energy, displacement, imbalance)

    @cached_property
    def residual(self) -> float:
        return float(np.abs(self.imbalance).max())

    def potential(self, target: np.ndarray) -> float:
        """Psi [J]."""
        force, compression = self.force, self.compression
        complementary = force @ compression - self.energy.sum()
        return float(force @ self.displacement / 2 + complementary - target @ force)


def _descend(
    compliance: Compliance,
    interface: Interface,
    target: np.ndarray,
    point: _Point,
    step: np.ndarray,
) -> _Point | None:
    """The full step if it halves the residual, else the first halving that lowers the energy.

    None where no halving does.
    """
    trial = _Point.at(compliance, interface, target, point.compression + step)
    if trial.residual < 0.5 * point.residual:
        return trial
    slope = -float((point.stiffness * point.imbalance) @ step)
    before = point.potential(target)
    rounding = 1e-14 * abs(before)
    for halving in range(_HALVINGS):
        share = 0.5**halving
        if halving:
            trial = _Point.at(compliance, interface, target, point.compression + share * step)
        if trial.potential(target) <= before + 1e-4 * share * slope + rounding:
            return trial
    return None


def thesis(
    compliance: Compliance,
    interface: Interface,
    target: np.ndarray,
    start: np.ndarray,
    tolerance: float,
    max_iterations: int,
    as_printed: bool = False,
) -> Solution:
    """The thesis' plain Newton iteration on the elements in contact: full steps, no guard.

    J_ij = -g_0[i, j] k_j - delta_ij on the elements in contact. Elements that come into
    compression join between iterations; none leaves within the step. Parameters as `robust`;
    `as_printed` takes the Jacobian of the thesis' Eq. 8, k_i in place of k_j, which diverges.
    """
    touching = (start > 0) | interface.bonded
    d, iterations = start, 0
    while True:
        force, stiffness, energy = interface.respond(np.where(touching, d, 0.0))
        displacement = compliance.displacement(force)
        reach = target - displacement
        d = np.where(touching, d, reach)
        joining = ~touching & (reach > 0)
        imbalance = reach - d  # zero where nothing touches
        residual = float(np.abs(imbalance).max())
        converged = residual <= tolerance and not joining.any()
        if converged or iterations == max_iterations or not residual < _LOST:
            return Solution(
                d, force, stiffness, energy, displacement, iterations, residual, converged
            )
        if joining.any():
            touching = touching | joining
            force, stiffness, _ = interface.respond(np.where(touching, d, 0.0))
            imbalance = target - compliance.displacement(force) - d
        if as_printed:
            step = _step_as_printed(compliance, stiffness, imbalance, touching)
        else:
            step = newton_step(compliance, stiffness, imbalance, _EXACT)
        d = d + np.where(touching, step, 0.0)
        iterations += 1


def _step_as_printed(
    compliance: Compliance, stiffness: np.ndarray, imbalance: np.ndarray, touching: np.ndarray
) -> np.ndarray:
    """Delta of (1 + K g_0) Delta = f on the elements in contact."""
    active = np.flatnonzero(touching)
    jacobian = np.eye(active.size) + stiffness[active, None] * compliance.matrix(active)
    step = np.zeros_like(imbalance)
    step[active] = np.linalg.solve(jacobian, imbalance[active])
    return step
