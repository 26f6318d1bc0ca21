"""A run kept to compare others with: its question and its numbers, without its maps."""

from __future__ import annotations

from dataclasses import dataclass

from tyrecontact import Results, Scenario
from tyrecontact.steps import SCALARS

from .phase import Phase
from .runner import Run


@dataclass(frozen=True)
class Look:
    """How a run is drawn wherever it is compared: a colour, and a dash as Bokeh names it."""

    color: str
    dash: str


@dataclass(frozen=True)
class Pinned:
    """A run as far as it had come when it was taken.

    Attributes
    ----------
    label : short, and unlike those of all other pinned runs.
    preset : name of the preset that the scenario is, or empty.
    results : the numbers of all steps taken; no maps of elements.
    total : steps of the complete run.
    ended : whether no step was to come.
    look : how it is drawn, the same while it is pinned.
    """

    label: str
    scenario: Scenario
    preset: str
    results: Results
    total: int
    ended: bool
    look: Look

    @property
    def steps(self) -> int:
        return len(self.results)

    @property
    def remark(self) -> str:
        """What is missing of the run, or empty."""
        if self.steps == self.total:
            return ""
        return f"{'ended after' if self.ended else 'so far'} {self.steps} of {self.total} steps"


def taken(run: Run, label: str, preset: str, look: Look) -> Pinned | None:
    """What there is of a run now, or None before its first step; later steps do not reach it."""
    ended = run.phase.ended or run.phase is Phase.COMPARING  # first: after an end no row comes
    found = run.results()
    if found is None or run.simulation is None:
        return None
    columns = {name: found.columns[name].copy() for name in ("time", *SCALARS)}
    results = Results(found.scenario, found.spacing, columns, found.stop_reason)
    return Pinned(label, found.scenario, preset, results, len(run.simulation), ended, look)
