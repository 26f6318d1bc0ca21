"""What is watched while a run goes on: force, iterations, map, element; and the step on show."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import Any

import panel as pn
import panel_material_ui as pmui

from .live_layout import arrange
from .player import Player
from .reach import Reach
from .runner import Run
from .shelf import Shelf
from .views.contact_map import ContactMapView
from .views.element import ElementView
from .views.force import ForceView
from .views.iterations import IterationsView
from .views.legend import LegendView
from .views.map_modes import MODES
from .views.pinned import PinnedCurves, entries
from .views.style import EMPTY, GREY, VERMILION, Size, horizontal

#: milliseconds from a change of what a plot shows until a long run is drawn in full there
_LOOK = 200
#: profiles that return: forth and back on one axis would lie on top of each other
_RETURNING = ("load-hold-unload", "sinusoidal", "table")


class Turn(Enum):
    """What a frame brings besides the force: at 16 frames a second each comes five times."""

    WORDS, ITERATIONS, MAP = range(3)


class Live:
    """The live plots of one session.

    Attributes
    ----------
    force, iterations, contact_map, element : the views.
    player : which step is on show.
    axis, mode : choices of the horizontal axis and of what the map shows.
    root : all of it.
    """

    def __init__(self, shelf: Shelf, redraw: Callable[[], None]) -> None:
        self._shelf = shelf
        self.force, self.iterations = ForceView(), IterationsView()
        self.contact_map, self.element = ContactMapView(), ElementView()
        self.pinned = PinnedCurves(self.force.root)
        self.pin = pmui.Button(
            label="Pin", icon="push_pin", size="small", variant="outlined", margin=(2, 4)
        )
        shelf.watch(self._show_pinned)
        self.contact_map.on_tap = self.element.follow
        self.element.on_follow = self._follow
        self.player, self.legend = Player(), LegendView()
        self.player.on_change = redraw
        self.axis = pmui.RadioButtonGroup(
            options=["indentation", "time"], value="indentation",
            size="small", margin=(2, 10),
        )  # fmt: skip
        self.mode = pmui.Select(
            label="Map of", options=list(MODES), value="force", size="small",
            sizing_mode="stretch_width", margin=(8, 10, 2, 10),
        )  # fmt: skip
        self.axis.param.watch(lambda _: self._choose_axis(), "value")
        self.mode.param.watch(lambda event: self._choose_mode(event.new), "value")
        for view in (self.force, self.iterations):
            view.root.x_range.on_change("start", self._look_soon)
            view.root.x_range.on_change("end", self._look_soon)
        self._document = pn.state.curdoc  # None where there is no browser, as in tests
        self._looking = False
        self._axis = horizontal("indentation", *EMPTY)
        self._run: Run | None = None
        self._next: Run | None = None
        self._drawn = self._counted = 0
        self._shown: tuple[int, bool] | None = None
        self._fitted, self._reach = False, Reach()
        self.root = arrange(self)

    def begin(self, run: Run, keep_scale: bool) -> None:
        """From the next frame on show this run; the scale stays if it is to be compared with the
        last one.

        The plots are cleared by that frame, too: a frame on its way to the browser may be late,
        and only other frames come after it for sure.
        """
        self._next = run
        self._fitted = self._fitted and keep_scale

    def _forget(self, run: Run) -> None:
        """Clear the plots of the last run."""
        self._run, self._drawn, self._counted, self._shown = run, 0, 0, None
        self._prepared = self._compared = False
        self._next = None
        self._reach.clear()
        self.force.reset()
        self.iterations.reset(run.scenario.numerics.max_iterations)
        self.legend.show_failed(False)
        self.contact_map.clear()
        self.element.rest()
        self.player.reset()

    def draw(self, run: Run, ended: bool, turn: Turn | None = None) -> None:
        """Show what has come since the last frame, and the step that is asked for; where it is the
        turn of one of them, no more than that and the force.
        """
        if run is self._next:
            self._forget(run)
        if run.simulation is None or run.record is None:
            return
        if not self._prepared:
            self._prepare(run)
        if run.baseline is not None and not self._compared:
            self._compare(run)
        low, high = self._drawn, run.record.count
        # a pause draws what was left open, though no step may have come since the last frame
        still = ended or run.paused
        if high > low or still:
            self.force.update(run.record, low, high, ended, run.paused)
            self.legend.show_failed(len(self.force.failed.data["force"]) > 0)
            self._drawn = high
            if self._reach.widen(run, low, high):
                self._choose_axis()
        if turn in (Turn.ITERATIONS, None) and (high > self._counted or still):
            self.iterations.update(run.record, self._counted, high, ended, run.paused)
            self._counted = high
        if high and turn in (Turn.WORDS, None):
            self.player.update(high, len(run.simulation), run.record.columns)
        if high and (turn in (Turn.MAP, None) or self.player.step is not None):
            self._show_step(run, high, ended)

    def suit(self, profile: str) -> None:
        """Choose the horizontal axis on which a loading profile is read best."""
        self.axis.value = "time" if profile in _RETURNING else "indentation"

    def point_at(self, place: str) -> None:
        """Draw a frame around a plot, "force", "iterations" or "map"; around none for others."""
        plots: dict[str, Any] = {
            "force": self.force, "iterations": self.iterations, "map": self.contact_map
        }  # fmt: skip
        for name, view in plots.items():
            pointed = name == place
            view.root.update(
                outline_line_color=VERMILION if pointed else GREY,
                outline_line_width=4 if pointed else 1, outline_line_alpha=1.0 if pointed else 0.3,
            )  # fmt: skip

    def _look_soon(self, _attribute: str, _old: Any, _new: Any) -> None:
        """A plot shows another range; not every pixel of a drag is worth an answer."""
        if self._document is not None and not self._looking:
            self._looking = True
            self._document.add_timeout_callback(self._look, _LOOK)

    def _look(self) -> None:
        """Show in full the part of a long run that has been zoomed into."""
        self._looking = False
        self.force.look()
        self.iterations.look()

    def darken(self, dark: bool) -> None:
        for view in (self.force, self.iterations, self.element, self.legend):
            view.darken(dark)

    def enlarge(self, size: Size) -> None:
        for view in (self.force, self.iterations, self.contact_map, self.element, self.legend):
            view.enlarge(size)
        self.pinned.enlarge(size)

    def _prepare(self, run: Run) -> None:
        assert run.simulation is not None
        peak = None if run.baseline is None else run.baseline.peak_element_force
        road = run.scenario.road
        self.contact_map.reset(road.size, road.elements, peak)
        self.element.prepare(run)
        if self.element.element is None:
            self.contact_map.forget()
        self._prepared = True
        self._choose_axis()

    def _compare(self, run: Run) -> None:
        assert run.baseline is not None
        assert run.record is not None
        self.force.compare_with(run.baseline, fit=not self._fitted)
        self.force.make_room_for(run.record.columns["contact_force"][: self._drawn])
        self.contact_map.expect(run.baseline.peak_element_force)
        self._fitted = self._compared = True
        self._choose_axis()

    def _show_step(self, run: Run, count: int, ended: bool) -> None:
        assert run.simulation is not None
        assert run.record is not None
        step = count - 1 if self.player.step is None else min(self.player.step, count - 1)
        if self._shown == (step, ended):
            return
        self._shown = (step, ended)
        settled = ended or self.player.step is not None
        self.contact_map.show(run.record, step, run.simulation.kernel.spacing, settled)
        self.element.update(run, step, ended)
        place = None if self.player.step is None else self._place(run, step)
        self.force.point_at(place)
        self.iterations.point_at(place)

    def _place(self, run: Run, step: int) -> float:
        """A step on the horizontal axis, in its unit."""
        assert run.record is not None
        if self.axis.value == "time":
            return float(run.record.columns["time"][step]) * 1e3
        return float(run.record.columns["indentation"][step]) * 1e6

    def _follow(self, row: int, column: int) -> None:
        self.contact_map.follow(row, column)
        self._show_again()

    def _choose_axis(self) -> None:
        """Put on the horizontal axis what is chosen, as far as the run on show goes."""
        axis = horizontal(self.axis.value, *self._reach.of(self._run))
        for view in (self.force, self.iterations, self.element):
            view.show_against(axis)
        self._axis = axis
        self._show_pinned()
        self._show_again()

    def _show_pinned(self) -> None:
        self.pinned.show(self._shelf.pinned, self._axis)
        self.legend.show_pinned(entries(self._shelf.pinned))

    def _choose_mode(self, mode: str) -> None:
        self.contact_map.show_mode(mode)
        self._show_again()

    def _show_again(self) -> None:
        """Show the step on show in another way; after the end no clock would do it."""
        self._shown = None
        if self._run is not None and self._drawn:
            self._show_step(self._run, self._drawn, self._run.phase.ended)
