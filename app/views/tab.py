"""A tab below the headline: a sentence that reads the run, its key numbers, and plots at rest."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape
from typing import Any, ClassVar
from weakref import ref

import numpy as np
import panel as pn

from tyrecontact.steps import SCALARS

from ..runner import Phase, Run
from .rest import HEIGHT, Redrawn
from .style import DESK, HALL, Size

#: a run under way is drawn anew when so many times the last drawing's cost has passed; the most [s]
_PATIENCE, _LONGEST = 10, 4.0
#: of a plot [px]: two fit beside each other on a desktop, and not on a phone
_NARROWEST = 400

_STYLE = """
.reading { padding-left: 10px; border-left: 3px solid transparent; line-height: 1.45; }
.bad { border-left-color: #D55E00; font-weight: 600; }
.figures { display: flex; flex-wrap: wrap; gap: 4px 26px; margin-top: 8px; padding-left: 10px; }
.label { opacity: 0.78; }
.value { font-weight: 600; font-variant-numeric: tabular-nums; white-space: nowrap; }
"""
_WRAP = ":host { flex-wrap: wrap; gap: 4px; }"


@dataclass(frozen=True)
class Seen:
    """A run as far as it has come.

    Attributes
    ----------
    columns : name -> array, shape (count,), of time and of all numbers of a step; SI.
    """

    run: Run
    columns: Mapping[str, np.ndarray]

    @property
    def ended(self) -> bool:
        return self.run.phase.ended

    @property
    def failed_at(self) -> int | None:
        """The first step that did not converge or that ended the run, or None."""
        failed = np.flatnonzero(self.columns["converged"] == 0)
        if failed.size:
            return int(failed[0])
        ended = self.run.record is not None and self.run.record.stop_reason
        return len(self.columns["converged"]) - 1 if ended else None


@dataclass(frozen=True)
class Reading:
    """What a tab shows of a run.

    Attributes
    ----------
    sentence : reads the plots for the visitor.  bad : whether it is bad news.
    figures : name -> value with its unit.  plots : name -> element of HoloViews.
    """

    sentence: str
    bad: bool = False
    figures: Mapping[str, str] = field(default_factory=dict)
    plots: Mapping[str, Any] = field(default_factory=dict)


class TabView(ABC):
    """Attributes: `root` to look at; `reading` what is shown; `heights` name of a plot -> [px]."""

    heights: ClassVar[Mapping[str, int]] = {}

    def __init__(self) -> None:
        self.reading = Reading("")
        self._words = pn.pane.HTML(
            "", stylesheets=[_STYLE], sizing_mode="stretch_width", margin=(8, 6)
        )
        # no FlexBox: the page's theme does not reach what is put into one later
        self._grid = pn.Row(sizing_mode="stretch_width", stylesheets=[_WRAP], margin=0)
        self.root = pn.Column(self._words, self._grid, sizing_mode="stretch_width")
        self._plots: dict[str, Redrawn] = {}
        self._waiting: dict[str, Any] = {}
        self._shown: tuple[Any, ...] = ()
        self._size = DESK
        self._due = 0.0

    @abstractmethod
    def read(self, seen: Seen) -> Reading:
        """What to show of a run with at least one step."""

    @property
    @abstractmethod
    def promise(self) -> str:
        """What will be here, and how to get it."""

    def show(self, run: Run | None, size: Size = DESK) -> None:
        """Draw a run as far as it has come; one under way not more often than can be afforded."""
        phase = None if run is None else run.phase  # first: after an end no row comes
        count = run.record.count if run is not None and run.record is not None else 0
        # a tab that is not looked at keeps no run alive that another has superseded
        about = None if run is None else ref(run)
        shown = (about, count, phase, size)
        new = not self._shown or about != self._shown[0] or size != self._size
        hurried = time.monotonic() < self._due and phase is Phase.RUNNING
        if shown == self._shown or (hurried and not new and count and self._shown[1]):
            return
        began = time.monotonic()
        self.reading = self._read(run, count)
        self._draw(size)
        self._shown = shown
        cost = time.monotonic() - began
        self._due = time.monotonic() + min(_PATIENCE * cost, _LONGEST)

    def _read(self, run: Run | None, count: int) -> Reading:
        if run is None or run.record is None or not count:
            return Reading(_why_nothing(run) or self.promise, run is not None and _is_bad(run))
        columns = run.record.columns
        return self.read(Seen(run, {name: columns[name][:count] for name in ("time", *SCALARS)}))

    def _draw(self, size: Size) -> None:
        self._words.object = _html(self.reading, size)
        plots = self.reading.plots
        fits = size == self._size and list(plots) == [*self._plots, *self._waiting]
        if fits and all(shown.takes(plots[name]) for name, shown in self._plots.items()):
            for name, shown in self._plots.items():
                shown.send(plots[name])
            self._waiting = {name: plots[name] for name in self._waiting}
            return
        self._size, self._plots, self._waiting = size, {}, dict(plots)
        self._grid.objects = [
            pn.Spacer(height=self._height(name), styles=self._styles) for name in plots
        ]
        self._make_next()

    def _make_next(self) -> None:
        """Make a plot, and the next one in its own time: a visitor's clicks come in between."""
        if not self._waiting:
            return
        name = next(iter(self._waiting))
        plot = Redrawn(self._waiting.pop(name), self._size, self._height(name))
        plot.root.styles = self._styles
        self._grid[len(self._plots)] = plot.root
        self._plots[name] = plot
        document = pn.state.curdoc
        if document is None or document.session_context is None:  # as in tests
            self._make_next()
        else:
            document.add_next_tick_callback(self._make_next)

    def _height(self, name: str) -> int:
        return self.heights.get(name, HEIGHT)

    @property
    def _styles(self) -> dict[str, str]:
        narrowest = _NARROWEST if self._size != HALL else 1.5 * _NARROWEST
        # never three in a row
        basis = f"max({narrowest:.0f}px, 34%)"
        return {"flex": f"1 1 {basis}", "width": "auto", "min-width": "0"}


def _is_bad(run: Run) -> bool:
    return run.phase in (Phase.REFUSED, Phase.FAILED)


def _why_nothing(run: Run | None) -> str:
    """Why a run has no step yet, or has none; empty before the first run."""
    if run is None:
        return ""
    if run.phase is Phase.REFUSED:
        return f"Nothing to show: this run was refused, {run.message}."
    if run.phase.ended:
        return "Nothing to show: this run was stopped before its first step."
    return "The run is being prepared; its plots come with its first steps."


def _html(reading: Reading, size: Size) -> str:
    figures = "".join(
        f'<span><span class="label">{escape(name)}</span> '
        f'<span class="value">{escape(value)}</span></span>'
        for name, value in reading.figures.items()
    )
    kind = "reading bad" if reading.bad else "reading"
    # a screen reader would read every change aloud: the sentence is there to be looked up
    return (
        f'<div style="font-size: {size.title}px"><div class="{kind}" aria-live="off">'
        f'{escape(reading.sentence)}</div><div class="figures">{figures}</div></div>'
    )
