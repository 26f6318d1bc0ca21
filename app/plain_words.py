"""What is said of a run, in plain words: where it stands, what went wrong, what to try."""

from __future__ import annotations

import re

import numpy as np

from tyrecontact.key_figures import first_unstable

from .phase import Phase
from .runner import Run


def true_minus(number: str) -> str:
    """A formatted number with the minus sign that the axes of the plots have."""
    return number.replace("-", "−")


def three_digits(value: float) -> str:
    """A number to three significant digits, without an exponent where it can be helped."""
    if value == 0:
        return "0"
    if not 1e-3 <= abs(value) < 1e5:
        return true_minus(f"{value:.2e}")
    digits = f"{value:#.3g}"
    return true_minus(f"{float(digits):.0f}" if "e" in digits else digits.rstrip("."))


def duration(seconds: float) -> str:
    """A time to wait for, as people say it."""
    if seconds < 1.5:
        return "1 s"
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def describe(run: Run) -> tuple[str, bool]:
    """One sentence or two on a run, and whether it is bad news."""
    if run.phase is Phase.REFUSED:
        return f"Not run: {run.message}.", True
    if run.record is None or run.simulation is None:
        return _before_the_first_step(run), False
    count, total = run.record.count, len(run.simulation)
    if run.phase is Phase.FAILED:
        return (
            f"Failed after step {count}; what was computed stays: {_from_one(run.message)}.",
            True,
        )
    if run.phase is not Phase.STOPPED and run.record.stop_reason:
        reason = _from_one(run.record.stop_reason)
        return f"{reason[:1].upper()}{reason[1:]}. What was computed stays.", True
    if count == 0:
        return _before_the_first_step(run), False
    failure = _failure(run, count)
    so_far = {
        Phase.STOPPED: f"Stopped at step {count} of {total}; what was computed stays",
        Phase.COMPARING: f"All {total} steps are done, the quasi-static run is being made",
        Phase.PAUSED: f"Paused at step {count} of {total}",
        Phase.FINISHED: f"Complete, {total} steps",
    }.get(run.phase, f"Step {count} of {total}")
    said = f"{so_far}: {failure or _warning(run, count) or 'all converged.'}"
    return said + _remark(run), bool(failure)


def _before_the_first_step(run: Run) -> str:
    if run.phase is Phase.STOPPED:
        return f"Stopped before the first step.{_remark(run)}"
    if run.phase is Phase.QUEUED:
        return f"Waiting for a free solver: number {run.place} in the queue."
    if run.phase is Phase.PAUSED:
        return "Paused before the first step."
    return "Stopping …" if run.stopping else "Preparing road, springs and kernel …"


def _remark(run: Run) -> str:
    """Why a run had to end early, or what is missing beside it."""
    return f" {run.message[:1].upper()}{run.message[1:]}." if run.message else ""


def _from_one(message: str) -> str:
    """The library counts steps from 0, the page from 1."""
    return re.sub(r"\bat step (\d+)", lambda found: f"at step {int(found[1]) + 1}", message)


def _warning(run: Run, count: int) -> str:
    """What is coming, before it comes."""
    assert run.record is not None
    columns = {name: column[:count] for name, column in run.record.columns.items()}
    step = first_unstable(columns)
    if step is None:
        return ""
    where = true_minus(f"{columns['indentation'][step] * 1e6:.1f}")
    return (
        f"all converged; from {where} µm on the springs are too "
        f"stiff for the {run.scenario.numerics.kernel} kernel (stability margin below 0), and it "
        "may blow up."
    )


def _failure(run: Run, count: int) -> str:
    """Where it failed, by how much, why, and what to try."""
    assert run.record is not None
    columns = run.record.columns
    bad = np.flatnonzero(columns["converged"][:count] == 0)
    if bad.size == 0:
        return ""
    first = int(bad[0])
    where = true_minus(f"{columns['indentation'][first] * 1e6:.1f} µm")
    residual = true_minus(f"{columns['residual'][first]:.1e} m")
    return (
        f"{bad.size} not converged, the first at step {first + 1} and {where} after "
        f"{columns['iterations'][first]} iterations, residual {residual}"
        f"{_place(run, first)}. {_why(run, count)}"
    )


def _place(run: Run, step: int) -> str:
    """The element whose force has jumped most in the step, where maps of it are kept."""
    assert run.record is not None
    number, fields = run.record.fields(step)
    before, earlier = run.record.fields(max(step - 1, 0))
    if number != step or before == step:
        return ""
    jump = np.abs(fields["element_force"] - earlier["element_force"])
    if not np.isfinite(jump).any():
        return ""
    row, column = np.unravel_index(np.nanargmax(jump), jump.shape)
    return f", worst at row {row}, column {column}"


def _why(run: Run, count: int) -> str:
    assert run.record is not None
    numerics = run.scenario.numerics
    columns = {name: column[:count] for name, column in run.record.columns.items()}
    unstable = first_unstable(columns)
    if unstable is not None:
        depth = true_minus(f"{columns['indentation'][unstable] * 1e6:.1f}")
        finer = 2 if numerics.time_resolution_factor < 2 else 4
        cure = f"time-resolution factor {finer}, or " if numerics.time_resolution_factor < 4 else ""
        return (
            f"From {depth} µm on the {numerics.kernel} kernel is unstable on springs this "
            f"stiff; try {cure}the passive kernel."
        )
    return "Try a smaller time step (time-resolution factor), or more iterations."
