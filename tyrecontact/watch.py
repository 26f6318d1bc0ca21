"""Why a run must not go on: diverged, unstable or not converged, and what to try."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tyrecontact.contact.energy import Energy
from tyrecontact.contact.equilibrium import Equilibrium


@dataclass(frozen=True)
class Watch:
    """What a run is watched for.

    Attributes
    ----------
    thickness : of the tread [m]; displaced by more than that is no solution of anything.
    kernel : `numerics.kernel`.
    is_guarded : whether a step that fails ends the run; the thesis' solver goes on, whatever
        comes: that is what it is there to show.
    """

    thickness: float
    kernel: str
    is_guarded: bool

    def reason_to_stop(self, index: int, equilibrium: Equilibrium, energy: Energy) -> str:
        """Why a run must not go on after step number `index`, or nothing."""
        if not np.abs(equilibrium.displacement).max() <= self.thickness:
            return (
                f"diverged at step {index}: the tread is displaced by more than "
                f"its thickness of {self.thickness * 1e3:.3g} mm"
            )
        if not self.is_guarded:
            return ""
        if energy.is_created:
            return (
                f"unstable at step {index}: the tread has given back more energy than it was "
                f"given, which no tread can; try {self.advice}"
            )
        if not equilibrium.solution.converged:
            return (
                f"not converged at step {index} after {equilibrium.iterations} iterations: "
                f"residual {equilibrium.solution.residual:.2g} m; try {self.advice}"
            )
        return ""

    @property
    def advice(self) -> str:
        """What to try."""
        if self.kernel == "band-limited":
            return "time_resolution_factor 4 or the passive kernel: it is unstable on stiff springs"
        if self.kernel == "static":
            return "a slower loading or more max_iterations"
        return (
            "more lags, so that the tread's creep fits into the kernel, quadrature BDF1, a slower "
            "loading or more max_iterations"
        )
