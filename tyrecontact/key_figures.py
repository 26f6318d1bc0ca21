"""The headline figures of a run, from its columns (name -> array, the steps first; SI).

An avalanche is a group of releases that the drive has no time to cause one by one: all those
within 1 % of the drive's way from its largest value to the last release. Counted over a way and
not over a step, its size does not depend on the time step; counted over the drive's way and not
over time, it does not grow with the rate of unloading. Bonds that break while the drive stands
still are one event. What the drive does in one step cannot be told apart, so that steps which
are longer than that way make every group look larger.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

Columns = Mapping[str, np.ndarray]

#: share of the drive's way within which releases are one event
EVENT_SHARE = 0.01
#: share of the work exchanged with the tread that rounding may make of it
ROUNDING = 1e-6
#: terms of the energy account: where the work of the drive goes
ACCOUNT = (
    "spring_energy", "machine_energy", "layer_work", "released_energy", "algorithmic_loss",
)  # fmt: skip


def adherence_force(columns: Columns) -> float | None:
    """Force at complete separation minus the least force [N]; None without a separation."""
    contacts, force = columns["contacts"], columns["contact_force"]
    if not (contacts.any() and contacts[-1] == 0):
        return None
    return abs(min(float(force.min()), 0.0))


def final_stiffness(columns: Columns) -> float | None:
    """dF/dd [N/m] over the last tenth of the loading, a straight line fitted.

    None where there are not three steps there.
    """
    top = turn(columns)
    if top is None:
        return None
    depth = columns["indentation"]
    last = np.flatnonzero(depth[: top + 1] >= 0.9 * depth[top])
    if last.size < 3:
        return None
    return float(np.polyfit(depth[last], columns["contact_force"][last], 1)[0])


def first_unstable(columns: Columns) -> int | None:
    """The first step whose stability margin is below 0; None where there is none."""
    below = np.flatnonzero(columns["stability_margin"] < 0)
    return int(below[0]) if below.size else None


def turn(columns: Columns) -> int | None:
    """The step of the largest indentation; None in a run without steps."""
    depth = columns["indentation"]
    return int(depth.argmax()) if len(depth) else None


def avalanches(columns: Columns) -> np.ndarray:
    """Number of bonds that broke in each event, in the order of time; shape (events,), integer.

    The largest group within the way of an event is taken first, then the largest of the rest.
    """
    releases, drive = columns["releases"], columns["drive"]
    steps = np.flatnonzero(releases)
    if not steps.size:
        return np.zeros(0, int)
    travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(drive)))])[steps]
    way = EVENT_SHARE * (drive[: steps[-1] + 1].max() - drive[steps[-1]])
    before = np.concatenate([[0], np.cumsum(releases[steps])])
    # the share of a step that rounding may take from the way
    ends = np.searchsorted(travelled, travelled + way * (1 + 1e-9), side="right")
    sizes, open_ranges = {}, [(0, steps.size)]
    while open_ranges:
        begin, end = open_ranges.pop()
        if begin == end:
            continue
        stops = np.minimum(ends[begin:end], end)
        first = begin + int(np.argmax(before[stops] - before[begin:end]))
        stop = int(min(ends[first], end))
        sizes[first] = int(before[stop] - before[first])
        open_ranges += [(begin, first), (stop, end)]
    return np.array([sizes[first] for first in sorted(sizes)])


def energy_account(columns: Columns) -> dict[str, float]:
    """Work of the drive since the start, where it has gone, and what is missing of it [J]."""
    if not len(columns["drive_work"]):
        return dict.fromkeys(("drive_work", *ACCOUNT, "imbalance"), 0.0)
    account = {name: float(columns[name][-1]) for name in ("drive_work", *ACCOUNT)}
    return {**account, "imbalance": account["drive_work"] - sum(account[n] for n in ACCOUNT)}


def imbalance(columns: Columns) -> np.ndarray:
    """Work of the drive less where it has gone [J], shape (steps,): rounding."""
    missing: np.ndarray = columns["drive_work"] - sum(columns[name] for name in ACCOUNT)
    return missing


def energy_created(columns: Columns) -> int | None:
    """The first step at whose end the tread has given back more than it got; None for none.

    No real one can: the time stepping has made energy.
    """
    layer = columns["layer_work"]
    turnover = np.abs(np.diff(layer, prepend=0.0)).cumsum()
    below = np.flatnonzero(layer < -ROUNDING * turnover)
    return int(below[0]) if below.size else None
