"""What is read off a run: where it fails, how fast it loads, how hard it sticks."""

from __future__ import annotations

import numpy as np

from tyrecontact.results import Results

#: the non-linear beginning of a loading ends at this share of its largest force
_LINEAR_FROM = 0.1
#: a curve has a point every so much [m]
_EVERY = 2e-6
#: a force is wrong by so much of what is due, where more is due than this [N]
_WRONG, _FORCE = 0.25, 10.0


def failing_depth(run: Results) -> float:
    """Indentation of the first step that fails [m]; inf for none."""
    failed = run.failed_at
    return np.inf if failed is None else float(run.indentation[failed])


def force_before_failure(run: Results) -> float:
    """Force of the last step before the first that fails [N], or of the last step."""
    last = len(run) - 1 if run.failed_at is None else max(run.failed_at - 1, 0)
    return float(run.contact_force[last])


def force_at(run: Results, depth: float | np.ndarray) -> np.ndarray:
    """Force while loading [N] at indentations [m]; nan beyond them, and where it had failed."""
    top = int(run.indentation.argmax()) + 1
    if run.failed_at is not None:
        top = min(top, run.failed_at)
    if not top:
        return np.full(np.shape(depth), np.nan)
    return np.interp(depth, run.indentation[:top], run.contact_force[:top], right=np.nan)


def excess(run: Results, still: Results, depth: np.ndarray) -> np.ndarray:
    """Force above that of another run, as a share of it, at indentations [m]."""
    return force_at(run, depth) / force_at(still, depth) - 1


def loading_rate(run: Results) -> float:
    """Slope of the force in time [N/s], a straight line fitted after the non-linear beginning."""
    top = int(run.indentation.argmax()) + 1
    force, time = run.contact_force[:top], run.time[:top]
    late = force >= _LINEAR_FROM * force.max()
    return float(np.polyfit(time[late], force[late], 1)[0])


def unloading_rate(run: Results) -> float:
    """Force at the end of the hold over the time in which it is taken off [N/s]; nan if never."""
    deep = run.indentation
    held = int(np.flatnonzero(deep >= deep.max() * (1 - 1e-9))[-1])  # rounding
    free = np.flatnonzero(run.contact_force[held:] <= 0)
    if not free.size:
        return np.nan
    return float(run.contact_force[held] / (run.time[held + free[0]] - run.time[held]))


def adherence(run: Results) -> float:
    """Force at complete separation less the least one [N]; nan where the two never part."""
    parted = len(run) > 0 and run.contacts.any() and run.contacts[-1] == 0
    return -float(min(run.contact_force.min(), 0.0)) if parted else np.nan


def largest_event(run: Results) -> float:
    """Largest share of the contacts that break in one step of the release."""
    before = np.concatenate([[0], run.contacts[:-1]])
    shares = run.releases[before > 0] / before[before > 0]
    # the last few always go together: what counts is while a tenth or more still hold
    many = before[before > 0] >= 0.1 * run.contacts.max()
    return float(shares[many].max(initial=0.0))


def wildness(run: Results, still: Results) -> tuple[int, float]:
    """After a failure: turns of the force, and its largest ratio to a quasi-static one."""
    failed = run.failed_at
    if failed is None:
        return 0, 0.0
    force, depth = run.contact_force[failed:], run.indentation[failed:]
    turns = np.count_nonzero(np.diff(np.sign(np.diff(force))))
    return int(turns), float((force / force_at(still, depth)).max())


def sound_depth(run: Results, still: Results) -> float:
    """Indentation [m] to which a run converges to within a quarter of a quasi-static force.

    inf for all of it. A step that converges may be wrong: an instability has a solution too.
    """
    depth, due = run.indentation, force_at(still, run.indentation)
    wrong = (due > _FORCE) & ~(np.abs(run.contact_force - due) <= _WRONG * due)
    first = np.flatnonzero(wrong)
    apart = float(depth[first[0]]) if first.size else np.inf
    return min(apart, failing_depth(run))


def spread(values: np.ndarray) -> float:
    """Largest less smallest, as a share of the mean; nan if any is."""
    return float(np.ptp(values) / np.mean(values))


def mean_difference(run: Results, still: Results) -> float:
    """Mean difference of two forces at the same times, as a share of the larger one's peak."""
    other = np.interp(run.time, still.time, still.contact_force)
    return float(np.abs(run.contact_force - other).mean() / np.abs(other).max())


def force_curve(run: Results) -> tuple[np.ndarray, np.ndarray]:
    """Indentation [m] every 2 µm as far as the loading went well, and the force there [N]."""
    top = int(run.indentation.argmax()) + 1
    if run.failed_at is not None:
        top = min(top, run.failed_at)
    reached = float(run.indentation[max(top - 1, 0)])
    depth = np.arange(0.0, reached * (1 + 1e-6), _EVERY)
    return depth, force_at(run, depth * (1 - 1e-9))


def stiffness_curve(run: Results) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Indentation [m], force [N] and stiffness dF/dd [N/m], as `force_curve`."""
    depth, force = force_curve(run)
    if depth.size < 3:
        return depth, force, np.full(depth.size, np.nan)
    return depth, force, np.gradient(force, depth)
