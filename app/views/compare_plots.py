"""Runs against each other, as plots at rest: force, iterations, stiffness, differences."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import holoviews as hv
import numpy as np

from tyrecontact.branches import Branch, branches

from ..pinned import Pinned
from .lines import Line, Window, lines, window

DEPTH, TIME = "indentation", "time"
_LABELS = {DEPTH: "Indentation [µm]", TIME: "Time [ms]"}
#: name of a plot -> its title
TITLES = {
    "force": "Contact force",
    "iterations": "Newton iterations a step",
    "stiffness": "Stiffness dF/dd while loading",
    "newton": "Force less that of {}",
    "percent": "The same, as a share of it",
}
#: shares of a force below this share of the largest tell nothing
_TOLD = 0.02
#: iterations that a plot always has room for
_FEW = 20
#: of the line of a run that fails
_FAINT = 0.6


@dataclass
class Plots:
    """Plots of some runs.

    Attributes
    ----------
    elements : name -> element of HoloViews.
    cut : name of a plot -> labels of the runs that go beyond its frame.
    """

    elements: dict[str, hv.Overlay] = field(default_factory=dict)
    cut: dict[str, list[str]] = field(default_factory=dict)


def plots(runs: Sequence[Pinned], axis: str = DEPTH, reference: str = "") -> Plots:
    """All plots.

    Parameters
    ----------
    axis : of force and iterations, `DEPTH` or `TIME`.
    reference : label of the run that the others are compared with.
    """
    found, across = Plots(), _LABELS[axis]
    force = [_line(run, _along(run, axis), run.results.contact_force) for run in runs]
    _add(found, "force", TITLES["force"], (across, "Force [N]"), _by_step(runs, force))
    counts = [_line(run, _along(run, axis), run.results.iterations.astype(float)) for run in runs]
    _add(found, "iterations", TITLES["iterations"], (across, "Iterations"), _by_step(runs, counts))
    loading = {run.label: _loading(run) for run in runs}
    slopes = [(run, _stiffness(run, loading[run.label])) for run in runs]
    labels = _LABELS[DEPTH], "Stiffness [MN/m]"
    _add(found, "stiffness", TITLES["stiffness"], labels, _at_depths(slopes))
    if reference in loading:
        others = [run for run in runs if run.label != reference]
        _differences(found, others, loading, reference)
    return found


def _differences(
    found: Plots, others: Sequence[Pinned], loading: dict[str, Branch], reference: str
) -> None:
    """Force less that of a run, at the same indentation, while loading."""
    still = loading[reference]
    largest = float(np.abs(still.force).max(initial=0.0))
    for name, unit in (("newton", "N"), ("percent", "%")):
        drawn = []
        for run in others:
            depth, excess, due = loading[run.label].less(still)
            if unit == "%":
                known = np.where(np.abs(due) >= _TOLD * largest, np.abs(due), np.nan)
                excess = 100 * excess / known
            drawn.append((run, _line(run, depth * 1e6, excess)))
        if any(np.isfinite(line.y).any() for _, line in drawn):
            title, labels = TITLES[name].format(reference), (_LABELS[DEPTH], f"Difference [{unit}]")
            _add(found, name, title, labels, _at_depths(drawn))


@dataclass(frozen=True)
class _Drawn:
    """A line, and what a frame must hold of it: x and y of the part that is usual; not of a run
    that fails where others do not.
    """

    line: Line
    sound: bool
    x: np.ndarray
    y: np.ndarray


def _by_step(runs: Sequence[Pinned], drawn: Sequence[Line]) -> list[_Drawn]:
    """Usual is what comes before a failure, and before a road torn off flies away."""
    found = []
    for run, line in zip(runs, drawn, strict=True):
        failed = run.results.failed_at
        touching = np.flatnonzero(run.results.contact_force[:failed])
        end = int(touching[-1]) + 2 if touching.size else failed
        found.append(_Drawn(line, failed is None, line.x[:failed][:end], line.y[:failed]))
    return found


def _at_depths(drawn: Sequence[tuple[Pinned, Line]]) -> list[_Drawn]:
    return [_Drawn(line, run.results.failed_at is None, line.x, line.y) for run, line in drawn]


def _add(
    found: Plots, name: str, title: str, labels: tuple[str, str], drawn: Sequence[_Drawn]
) -> None:
    """A plot as wide and high as the runs that go well need, and these in front of the others;
    empty lines keep their place.
    """
    drawn = sorted(drawn, key=lambda part: part.sound)
    usual = [part for part in drawn if part.sound] or drawn
    across = window([part.line.x for part in drawn], [part.x for part in usual])
    seen = window([part.line.y for part in drawn], [part.y for part in usual])
    if name == "iterations" and seen is not None:
        most = max(float(part.line.y.max(initial=0.0)) for part in drawn)
        seen = None if most <= _FEW else (0.0, seen[1])
    overlay = lines(title, *labels, [part.line for part in drawn], seen, legend=False)
    found.elements[name] = overlay.opts(xlim=across or (None, None), backend="bokeh")
    found.cut[name] = [part.line.label for part in drawn if _leaves(part.line.y, seen)]


def _leaves(values: np.ndarray, seen: Window) -> bool:
    known = values[np.isfinite(values)]
    return seen is not None and bool(np.any((known < seen[0]) | (known > seen[1])))


def _line(run: Pinned, x: np.ndarray, y: np.ndarray) -> Line:
    alpha = 1.0 if run.results.failed_at is None else _FAINT
    return Line(run.label, x, y, run.look.color, run.look.dash, 1.8, alpha)


def _along(run: Pinned, axis: str) -> np.ndarray:
    return run.results.time * 1e3 if axis == TIME else run.results.indentation * 1e6


def _loading(run: Pinned) -> Branch:
    """The branch of loading, as far as the steps converge."""
    results, sound = run.results, slice(0, run.results.failed_at)
    return branches(results.indentation[sound], results.contact_force[sound], results.drive[sound])[
        0
    ]


def _stiffness(run: Pinned, loading: Branch) -> Line:
    depth, _, stiffness = loading.slope()
    return _line(run, depth * 1e6, stiffness / 1e6)
