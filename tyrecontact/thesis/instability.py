"""Findings of the thesis' chapter 4.1: the dynamic run blows up, and the reason why."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from tyrecontact import figures
from tyrecontact.simulation import Simulation
from tyrecontact.thesis import measures
from tyrecontact.thesis.findings import TOLERANCE, Claim, Family, Finding, Judge, Numbers
from tyrecontact.thesis.wording import at_depth
from tyrecontact.tread.kernels import critical_stiffness

_RAMPS = ("20 ms", "13.3 ms", "6.7 ms", "2 ms")
_ROAD = (
    "the road is a made one, not the thesis' scan: its springs stiffen differently with compression"
)


def _same_curve(family: Family) -> tuple[str, bool]:
    guarded, thesis = family["guarded"].contact_force, family["thesis"].contact_force
    if guarded.size != thesis.size:
        return "one of the runs failed", False
    apart = float(np.abs(guarded - thesis).max() / guarded.max())
    return f"at most {apart:.0e} of the largest force apart", apart < 1e-3


def _fails_in_range(family: Family) -> tuple[str, bool]:
    depth = measures.failing_depth(family["dynamic"])
    low, high = 0.05e-3 * (1 - TOLERANCE), 0.06e-3 * (1 + TOLERANCE)
    return at_depth(depth), low <= depth <= high


def _iterates_in_vain(family: Family) -> tuple[str, bool]:
    run = family["dynamic"]
    if run.failed_at is None:
        return "no step fails", False
    before, there = run.iterations[: run.failed_at].max(), run.iterations[run.failed_at]
    return f"{before} at most before, {there} there", there == 10


def _grows_wild(family: Family) -> tuple[str, bool]:
    turns, largest = measures.wildness(family["dynamic"], family["quasi-static"])
    found = f"{turns} turns, up to {largest:.3g} times the quasi-static force"
    return found, turns >= 10 and largest > 3


def _helps_not(other: str, usual: str) -> Judge:
    def measure(family: Family) -> tuple[str, bool]:
        still = family["quasi-static"]
        first, second = (measures.sound_depth(family[label], still) for label in (usual, other))
        return f"{at_depth(second)} instead of {at_depth(first)}", second < (1 + TOLERANCE) * first

    return measure


def _slower_fails_no_later(family: Family) -> tuple[str, bool]:
    depths = [measures.failing_depth(family[label]) for label in _RAMPS]
    step = 1 / 51200
    rates = [family[label].scenario.loading.rate for label in _RAMPS]
    in_order = all(
        slow <= fast + rate * step
        for (slow, fast), rate in zip(pairwise(depths), rates[1:], strict=True)
    )
    found = ", ".join(f"{label}: {at_depth(d)}" for label, d in zip(_RAMPS, depths, strict=True))
    return found, in_order


def _critical_stiffness(_: Family) -> list[float]:
    simulation = Simulation(figures.member("cause", "band-limited kernel"))
    elements = simulation.scenario.road.elements
    return [critical_stiffness(simulation.kernel, (elements, elements)) * 1e-3]


def _kernel_decides(family: Family) -> tuple[str, bool]:
    usual, cured = family["band-limited kernel"], family["passive kernel"]
    most = cured.iterations.max()
    found = f"{at_depth(measures.failing_depth(cured))}, {most} iterations at most"
    return found, usual.failed_at is not None and cured.failed_at is None


def _solver_decides_not(family: Family) -> tuple[str, bool]:
    depth = measures.failing_depth(family["guarded solver"])
    return at_depth(depth), depth < 0.2e-3 * (1 - 1e-6)


FINDINGS: tuple[Finding, ...] = (
    Claim(
        "fig-18",
        "Quasi-statically, two solvers give one curve",
        "the same results",
        "within 0.1 % of the largest force",
        _same_curve,
    ),
    Claim(
        "fig-19",
        "The dynamic run fails at a small indentation",
        "at 0.05 to 0.06 mm",
        "within 25 % of that range",
        _fails_in_range,
        _ROAD,
    ),
    Claim(
        "fig-19",
        "From there on the iterations are at their maximum",
        "10",
        "10 in the first step that fails",
        _iterates_in_vain,
        "the step is lost before the iterations are used up",
    ),
    Claim(
        "fig-19",
        "The force oscillates and then shoots up",
        "oscillates, extreme values",
        "ten turns or more, and over 3 times the quasi-static force",
        _grows_wild,
        "the run was left before the oscillation had grown that far",
    ),
    Claim(
        "fig-19",
        "More iterations do not help",
        "no change",
        "wrong, by 25 % or by not converging, less than 25 % deeper",
        _helps_not("50 iterations", "dynamic"),
        "with more iterations every step converges for longer, on forces that become as wrong",
    ),
    Claim(
        "fig-20",
        "A better first guess does not help",
        "no great change",
        "wrong less than 25 % deeper",
        _helps_not("extrapolated", "last"),
        "the better guess lasts longer here, but the run fails too",
    ),
    Claim(
        "fig-21",
        "Slower ramps fail no later than faster ones",
        "slightly better for faster ones",
        "in this order, to one time step",
        _slower_fails_no_later,
        "the instability grows from rounding: which step it reaches first is partly chance",
    ),
    Numbers(
        "cause",
        "Beyond this stiffness of an element the band-limited kernel is unstable (physics, 5)",
        [50],
        "kN/m",
        _critical_stiffness,
        "the kernel's critical stiffness depends on the modulus of the tread alone",
    ),
    Claim(
        "cause",
        "The same run, the same Newton, with the passive kernel does not fail (physics, 5)",
        "never more than 4 iterations",
        "no step fails",
        _kernel_decides,
        "the passive kernel failed, which it must not",
    ),
    Claim(
        "cause",
        "A guarded solver does not save the band-limited kernel (physics, 5)",
        "a linear instability of the time stepping",
        "stopped before 0.2 mm",
        _solver_decides_not,
        "the springs of this road stay below the critical stiffness",
    ),
)
