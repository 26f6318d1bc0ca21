"""The tab Inputs: road, springs, kernel and loading of a run, or of one that is not begun."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import panel as pn
import panel_material_ui as pmui

from tyrecontact import Scenario, Simulation

from ..latest import Latest
from ..limits import limits
from ..runner import Run
from . import input_sheet
from .input_kernel import KernelInput
from .input_loading import LoadingInput
from .input_road import RoadInput
from .input_sheet import Sheet
from .input_springs import SpringsInput
from .style import DESK, Size

EMPTY = "Road, springs, kernel and loading of the run will be here: press Run, or choose a preset."


@dataclass(frozen=True)
class _Part:
    """Name on the page; what of a simulation is needed; how its sheet is made of that."""

    needs: tuple[str, ...]
    make: Callable[[Simulation], Sheet]


PARTS = {
    "Road": _Part(("patch",), lambda simulation: RoadInput.of(simulation).sheet()),
    "Springs": _Part(("patch", "springs"), lambda simulation: SpringsInput.of(simulation).sheet()),
    "Kernel": _Part(("kernel",), lambda simulation: KernelInput.of(simulation).sheet()),
    "Loading": _Part((), lambda simulation: LoadingInput.of(simulation).sheet()),
}


@dataclass(eq=False)
class _Subject:
    """What is shown: a scenario, its simulation once it is made, and the sheets so far.

    A part that was refused has one sentence instead of a sheet.
    """

    scenario: Scenario
    simulation: Simulation | None = None
    sheets: dict[str, Sheet | str] = field(default_factory=dict)

    def same(self, scenario: Scenario) -> bool:
        """Whether a scenario has the same inputs; a file may change under its name."""
        return not scenario.road.file and self.scenario.to_dict() == scenario.to_dict()

    def prepare(self, name: str, wanted: Callable[[], bool]) -> Sheet | None:
        """Make a sheet, on a thread; None where it is not wanted any more."""
        simulation = self.simulation or Simulation(self.scenario)
        limits().check(simulation)
        for need in PARTS[name].needs:
            if not wanted():
                return None
            getattr(simulation, need)
        self.simulation = simulation
        return PARTS[name].make(simulation)


class InputsView:
    """Attributes: `root`; `choice` of the part; `text` its facts and caption; `plots` its plots;
    `worker` the thread that prepares."""

    def __init__(self) -> None:
        self._document = pn.state.curdoc  # None where there is no browser, as in tests
        self._subject: _Subject | None = None
        self._size = DESK
        self._asked: tuple[_Subject, str] | None = None
        self._drawn: tuple[_Subject, str, Size] | None = None
        self._shown: Sheet | None = None
        self._waiting: deque[Callable[[Size], Any]] = deque()
        self.worker = Latest(self._answered)
        self.choice = pmui.RadioButtonGroup(
            options=list(PARTS), value="Road", size="small", margin=(8, 8),
        )  # fmt: skip
        self.text = pn.pane.HTML(
            "", stylesheets=[input_sheet.STYLE], sizing_mode="stretch_width", margin=(4, 8)
        )
        self.plots = input_sheet.grid()
        self.root = pn.Column(self.choice, self.text, self.plots, sizing_mode="stretch_width")
        self.choice.param.watch(lambda _: self._draw(), "value")
        self._say(EMPTY)

    def show(self, run: Run | None, size: Size = DESK) -> None:
        """Show what went into a run; it is prepared on a thread, and drawn when that is done."""
        self._size = size
        if run is not None and (run.simulation is not None or run.phase.ended):
            self._turn_to(run.scenario, run.simulation)
        elif run is not None and not self._about(run.scenario):
            self._subject = None  # the run's own thread is at it
            self._say("Preparing road, springs and kernel …")
        elif self._subject is None:
            self._say(EMPTY)
        self._draw()

    def show_scenario(self, scenario: Scenario, size: Size = DESK) -> None:
        """Show what would go into a run; a later call takes the place of this one."""
        self._size = size
        self._turn_to(scenario, None)
        self._draw()

    def close(self) -> None:
        """The visitor has left."""
        self.worker.close()
        self._waiting.clear()
        self._subject = None

    def arrive(self) -> None:
        """Take what the thread has prepared."""
        answer = self.worker.take()
        if answer is None or self._asked is None:
            return
        (subject, name), (made, refusal) = self._asked, answer
        subject.sheets[name] = refusal or made
        self._draw()

    def _about(self, scenario: Scenario) -> bool:
        return self._subject is not None and self._subject.same(scenario)

    def _turn_to(self, scenario: Scenario, simulation: Simulation | None) -> None:
        subject = self._subject
        if simulation is not None and subject is not None and subject.simulation is simulation:
            return
        if not self._about(scenario):
            self._subject = _Subject(scenario.copy(), simulation)

    def _draw(self) -> None:
        """Draw the chosen part, unless it is there already or still to be prepared."""
        subject, name = self._subject, self.choice.value
        if subject is None or self._drawn == (subject, name, self._size):
            return
        sheet = subject.sheets.get(name)
        if sheet is None:
            self._ask(subject, name)
            return
        if isinstance(sheet, str):
            self._say(f"Cannot be shown: {sheet}.")
        else:
            self._place(sheet)
        self._drawn = (subject, name, self._size)

    def _ask(self, subject: _Subject, name: str) -> None:
        what = f"Preparing the {name.lower()} …"
        if self._drawn is not None and self._drawn[1] == name and self._shown is not None:
            self._write(f"{what} Below is what it was before the change.")
        else:
            self._say(what)
        if self._asked != (subject, name):
            self._asked = (subject, name)
            self.worker.ask(partial(subject.prepare, name))

    def _answered(self) -> None:
        """On the worker's thread."""
        if self._document is not None:
            self._document.add_next_tick_callback(self._arrive_on_page)

    def _arrive_on_page(self) -> None:
        # what changes while a page is being loaded may never reach it
        pn.state.onload(self.arrive)

    def _say(self, sentence: str) -> None:
        """A sentence alone."""
        self._shown = self._drawn = None
        self._waiting.clear()
        if self.plots.objects:
            self.plots.objects = []
        self._write(sentence)

    def _write(self, state: str) -> None:
        said = input_sheet.text(self._shown, state, self._size)
        if said != self.text.object:
            self.text.object = said

    def _place(self, sheet: Sheet) -> None:
        """Text and plots of a sheet, a plot a tick: nobody waits for more than one."""
        self._shown = sheet
        self._write("")
        self.plots.objects = []
        self._waiting = deque(sheet.plots)
        self._place_next()

    def _place_next(self) -> None:
        if not self._waiting:
            return
        self.plots.append(self._waiting.popleft()(self._size))
        if self._document is None:
            self._place_next()
        elif self._waiting:
            self._document.add_next_tick_callback(self._place_next)
