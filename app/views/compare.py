"""Pinned runs side by side: what differs, key figures, overlays, and differences in force."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any
from weakref import ref

import panel as pn

from ..compared import differences, key_figures, notes
from ..pinned import Pinned
from ..runner import Phase, Run
from ..shelf import MOST, Shelf
from .compare_controls import CompareControls
from .compare_plots import Plots, plots
from .compare_table import STYLE, key, sentences, table
from .compare_table import beside as side_by_side
from .input_sheet import height, width
from .rest import Redrawn
from .style import DESK, Size

_EMPTY = (
    "Pin a run to compare: press Run, then “Pin this run”, change a setting and run again. Up to "
    f"{MOST} runs are kept; here will be seen in what settings they differ, what each came to, "
    "their curves in one plot, and how far their forces are apart."
)
#: all plots are as wide as each other, also in a row that they do not fill
_EVEN = """:host {{ display: grid; align-items: start;
  grid-template-columns: repeat(auto-fit, minmax(min({}px, 100%), 1fr)); }}"""
#: a run under way is drawn anew when so many times the last drawing's cost has passed
_PATIENCE = 10


class CompareView:
    """Attributes: `root` to look at; `runs` compared; `said` sentences; `drawn` plots;
    `controls` None until there is something to compare.
    """

    def __init__(self, shelf: Shelf) -> None:
        self._shelf = shelf
        self.runs: tuple[Pinned, ...] = ()
        self.said: list[str] = []
        self.drawn = Plots()
        self.controls: CompareControls | None = None
        self._about: ref[Run] | None = None
        self._size, self._due = DESK, 0.0
        self._seen: tuple[Any, ...] = ()
        html: dict[str, Any] = {"stylesheets": [STYLE], "sizing_mode": "stretch_width"}
        self.words = pn.pane.HTML("", margin=(8, 10, 4, 10), **html)
        self.tables = pn.pane.HTML("", margin=(4, 10), **html)
        self._places = pn.Column(sizing_mode="stretch_width", margin=0)
        self._grid = pn.Row(sizing_mode="stretch_width", margin=0)
        self._plots: dict[str, Redrawn] = {}
        self.root = pn.Column(
            self.words, self._places, self.tables, self._grid, sizing_mode="stretch_width", margin=0
        )
        shelf.watch(self._pins_changed)

    def show(self, run: Run | None, size: Size = DESK) -> None:
        """Compare the pinned runs and the one on show, as far as it has come."""
        phase = None if run is None else run.phase  # first: after an end no row comes
        count = run.record.count if run is not None and run.record is not None else 0
        # a tab that is not looked at keeps no run alive that another has superseded
        about = None if run is None else ref(run)
        seen = (about, bool(count), size, self._shelf.pinned, self._asked)
        now = (*seen, count, phase)
        hurried = phase is Phase.RUNNING and time.monotonic() < self._due
        if now == self._seen or (hurried and seen == self._seen[: len(seen)]):
            return
        began = time.monotonic()
        self._about = about
        self.runs = self._shelf.with_run(run) if self._shelf.pinned else ()
        self._draw(size)
        self._seen = (*seen[:-1], self._asked, count, phase)
        self._due = time.monotonic() + _PATIENCE * (time.monotonic() - began)

    @property
    def _run(self) -> Run | None:
        return None if self._about is None else self._about()

    @property
    def _asked(self) -> tuple[Any, ...]:
        """What the visitor chose."""
        found = self.controls
        return () if found is None else (found.axis.value, found.reference.value, found.said)

    def _pins_changed(self) -> None:
        """Redraw, where this has been looked at before."""
        if self._seen:
            self.show(self._run, self._size)

    def _draw(self, size: Size) -> None:
        runs = self.runs
        if (runs or _begun(self._run)) and self.controls is None:
            self.controls = CompareControls(self._shelf, lambda: self.show(self._run, self._size))
            self._places.append(self.controls.root)
        if self.controls is not None:
            self.controls.update(self._run, runs)
        if not runs:
            said = "" if self.controls is None else self.controls.said
            self.said = [text for text in (said, _EMPTY) if text]
            self.tables.object, self._grid.objects, self._plots = "", [], {}
            self.drawn = Plots()
        else:
            assert self.controls is not None
            reference = str(self.controls.reference.value)
            self.drawn = plots(runs, str(self.controls.axis.value), reference)
            self.said = self._sentences(runs, reference)
            self.tables.object = _tables(runs, size)
            self._draw_plots(size)
        self.words.object = sentences(self.said, size)
        self._size = size

    def _draw_plots(self, size: Size) -> None:
        elements, cast = self.drawn.elements, [(run.label, run.look) for run in self.runs]
        if (
            (size, cast) == self._drawn_for
            and list(elements) == list(self._plots)
            and all(self._plots[name].takes(element) for name, element in elements.items())
        ):
            for name, element in elements.items():
                self._plots[name].send(element)
            return
        self._drawn_for = size, cast
        self._plots = {n: Redrawn(element, size, height(size)) for n, element in elements.items()}
        self._grid.param.update(
            objects=[plot.root for plot in self._plots.values()],
            stylesheets=[_EVEN.format(width(size))],
        )

    #: type, and labels and looks of the runs that the plots were made for
    _drawn_for: tuple[Any, ...] = ()

    def _sentences(self, runs: Sequence[Pinned], reference: str) -> list[str]:
        assert self.controls is not None
        if len(runs) == 1:
            first = "One run is pinned: change a setting and press Run, and compare."
        else:
            first = f"{len(runs)} runs are compared; differences are from “{reference}”."
        wild = [run.label for run in runs if any(run.label in c for c in self.drawn.cut.values())]
        cut = [
            f"{_listed(wild)}: cut off at the frame of some plots, which is as large as the runs "
            "that go well need."
        ] * bool(wild)
        alone = len(runs) > 1 and "newton" not in self.drawn.elements
        lacking = [f"No run was pressed to a depth that “{reference}” has as well."] * alone
        return [text for text in (self.controls.said, first) if text] + notes(runs) + cut + lacking


def _begun(run: Run | None) -> bool:
    return run is not None and run.record is not None and run.record.count > 0


def _listed(labels: Sequence[str]) -> str:
    return ", ".join(f"“{label}”" for label in labels)


def _tables(runs: Sequence[Pinned], size: Size) -> str:
    figures = table("Key figures", runs, key_figures(runs), size)
    if len(runs) < 2:
        return figures + key(runs, size)
    rows = differences(runs)
    if not rows:
        nothing = ["What differs: nothing, all settings are the same."]
        return sentences(nothing, size) + figures + key(runs, size)
    differing = table("What differs", runs, rows, size)
    return side_by_side([differing, figures], len(runs)) + key(runs, size)
