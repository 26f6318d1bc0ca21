"""Findings of the thesis' chapter 4.2: a finer time step and softer springs against it."""

from __future__ import annotations

import numpy as np

from tyrecontact import figures
from tyrecontact.simulation import Simulation
from tyrecontact.thesis import measures
from tyrecontact.thesis.findings import TOLERANCE, Claim, Family, Finding, Numbers
from tyrecontact.thesis.wording import at_depth, percent, signed
from tyrecontact.tread.kernels import Kernel

#: no great change
_CLOSE = 0.1
#: what a patch of this size may carry under a tyre [N]
_FORCE = 100.0


def _kernels() -> dict[str, Kernel]:
    labels = ("factor 1", "factor 2", "factor 4")
    return {label: Simulation(figures.member("fig-22", label)).kernel for label in labels}


def _lasts(_: Family) -> list[float]:
    kernel = _kernels()["factor 1"]
    return [kernel.lags * kernel.time_step * 1e3]


def _steps(_: Family) -> list[float]:
    return [kernel.time_step * 1e6 for kernel in _kernels().values()]


def _loses_compliance(_: Family) -> list[float]:
    rest = [float(kernel.static_compliance[0, 0]) for kernel in _kernels().values()]
    return [100 * (1 - rest[1] / rest[0])]


def _changes_at(family: Family, depth: np.ndarray) -> dict[str, np.ndarray]:
    original = family["factor 1"]
    labels = ("factor 2", "factor 4", "exchanged")
    return {label: measures.excess(family[label], original, depth) for label in labels}


def _changes_little(family: Family) -> tuple[str, bool]:
    original = family["factor 1"]
    depth = np.interp(_FORCE, original.contact_force, original.indentation)
    changes = {label: float(c) for label, c in _changes_at(family, depth).items()}
    found = ", ".join(f"{label}: {percent(change)}" for label, change in changes.items())
    return found, max(map(abs, changes.values())) <= _CLOSE


def _changes_grow(family: Family) -> tuple[str, bool]:
    depths = np.array([50e-6, 100e-6, 200e-6]) * (1 - 1e-9)
    force = measures.force_at(family["factor 1"], depths)
    newtons = {label: change * force for label, change in _changes_at(family, depths).items()}
    found = "; ".join(
        f"{label}: {', '.join(signed(n) for n in change)} N" for label, change in newtons.items()
    )
    return found, all(np.all(np.diff(np.abs(change)) > 0) for change in newtons.values())


def _exchange_changes_most(family: Family) -> tuple[str, bool]:
    depths = np.linspace(20e-6, 199e-6, 60)
    force = measures.force_at(family["factor 1"], depths)
    largest = {
        label: float(np.abs(change * force).max())
        for label, change in _changes_at(family, depths).items()
    }
    found = ", ".join(f"{label}: {change:.3g} N" for label, change in largest.items())
    return found, max(largest, key=lambda label: largest[label]) == "exchanged"


def _factor_2_fails_late(family: Family) -> tuple[str, bool]:
    run = family["factor 2"]
    depth, force = measures.failing_depth(run), measures.force_before_failure(run)
    found = f"{at_depth(depth)}, {force:.3g} N"
    return found, 0.12e-3 < depth < np.inf and force > 200


def _factor_4_holds(family: Family) -> tuple[str, bool]:
    run = family["factor 4"]
    reached = float(run.indentation.max()) * 1e3
    found = f"{at_depth(measures.failing_depth(run))}; {reached:.3g} mm reached"
    return found, run.failed_at is None and reached > 0.199


def _exchange_helps(family: Family) -> tuple[str, bool]:
    runs = family["factor 1"], family["exchanged"]
    first, second = (measures.failing_depth(run) for run in runs)
    sound, sounder = (measures.sound_depth(run, family["factor 4"]) for run in runs)
    found = (
        f"not converged {at_depth(second)} instead of {at_depth(first)}; "
        f"force wrong by 25 % {at_depth(sounder)} instead of {at_depth(sound)}"
    )
    helps = second > (1 + TOLERANCE) * first and sounder > (1 + TOLERANCE) * sound
    return found, helps


FINDINGS: tuple[Finding, ...] = (
    Numbers(
        "fig-22",
        "Time step at factors 1, 2 and 4",
        [19.53, 9.76, 4.88],
        "µs",
        _steps,
    ),
    Numbers(
        "fig-22",
        "Time shown of the kernel",
        [25],
        "ms",
        _lasts,
        "256 samples at 51.2 kHz last 5 ms: the thesis' 25 ms must be a slip (physics, 9.4)",
    ),
    Numbers(
        "fig-22",
        "Self compliance at rest lost to the interpolation at factor 2 (physics, 5)",
        [10],
        "%",
        _loses_compliance,
        "it is exactly (1 - 1/2)(g_0 + g_N)/2 of this kernel, whose first sample is larger than "
        "that of the prototype from which the specification has its number",
    ),
    Claim(
        "fig-24-26",
        "Quasi-statically the cures change little at the forces under a tyre",
        "small",
        "at most 10 % of the force at 100 N",
        _changes_little,
        "interpolation takes self compliance away and the exchange makes springs softer, on this "
        "road more than on the thesis'",
    ),
    Claim(
        "fig-24-26",
        "The changes grow with the indentation",
        "in general",
        "larger at 0.1 than at 0.05, and at 0.2 than at 0.1 mm",
        _changes_grow,
        "for one of the cures the change passes a largest value; the thesis says `in general`",
    ),
    Claim(
        "fig-24-26",
        "The exchange of 80 springs changes most",
        "largest differences",
        "largest difference in force up to 0.2 mm",
        _exchange_changes_most,
        "the interpolation's loss of compliance is the same on all roads, the effect of the "
        "exchange depends on how stiff the stiffest springs are",
    ),
    Claim(
        "fig-27-29",
        "Factor 2 fails late",
        "above 0.12 mm and 200 N",
        "above 0.12 mm and 200 N, below 0.2 mm",
        _factor_2_fails_late,
        "the road is a made one: its springs reach the critical stiffness elsewhere",
    ),
    Claim(
        "fig-27-29",
        "Factor 4 does not fail",
        "stable to 0.2 mm",
        "no step fails to 0.2 mm",
        _factor_4_holds,
        "its springs are stiffer than the 1.8e5 N/m below which factor 4 is safe",
    ),
    Claim(
        "fig-27-29",
        "The exchange of 80 springs helps",
        "efficient",
        "both at least 25 % deeper",
        _exchange_helps,
        "on this road many springs are about as stiff as the 80 that are exchanged: the next in "
        "the ranking pass the critical stiffness soon after",
    ),
)
