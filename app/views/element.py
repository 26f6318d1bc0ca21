"""One element followed through a run: force, spring with the working point, small-scale heights."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

import numpy as np
import panel as pn
import panel_material_ui as pmui

from tyrecontact.contact.adhesion import Hysteresis, constant_limit
from tyrecontact.contact.bonds import ElementState
from tyrecontact.contact.kinetics import RecedingContact
from tyrecontact.results import Record
from tyrecontact.simulation import Simulation

from ..runner import Run
from .element_chooser import ElementChooser
from .element_plots import ForcePlots, HeightsPlot, enlarge
from .element_words import INVITATION, OFFER, WAITING, say
from .map_modes import Fields
from .style import DESK, Horizontal, Size
from .trace import extremes

#: points of the element's way: a plot is some 300 pixels wide
_POINTS = 600
#: heights drawn along a side, at most
_HEIGHTS = 100
#: the way is drawn anew when it has grown by this share
_GROWTH = 0.01
_STYLE = """:host { font-size: calc(14px * var(--scale, 1)); line-height: 1.43;
  min-height: calc(20px * var(--scale, 1)); }"""
_SIDE_BY_SIDE = """:host { display: grid !important; column-gap: 8px;
  grid-template-columns: repeat(auto-fit, minmax(min(300px, 100%), 1fr)); }"""


class ElementView:
    """Three plots of the element that is followed, and a sentence on it.

    Attributes
    ----------
    root : a column; cheap until an element is followed or `open` is called.
    element : row and column followed, or None.  sentence : on it.
    offer : button that calls `open`, and gives way to what it opens.
    on_follow : is called with row and column when an element comes to be followed.
    """

    def __init__(self) -> None:
        self.on_follow: Callable[[int, int], None] = lambda _row, _column: None
        self.element: tuple[int, int] | None = None
        self.forces: ForcePlots | None = None
        self.heights: HeightsPlot | None = None
        self.chooser: ElementChooser | None = None
        self._run: Run | None = None
        self._axis: Horizontal | None = None
        self._size, self._dark = DESK, False
        self._drawn: int | None = None
        self._words = pn.pane.HTML("", stylesheets=[_STYLE], sizing_mode="stretch_width")
        self.offer = pmui.Button(label=OFFER, size="small", variant="outlined", margin=(2, 5))
        self.offer.on_click(lambda _: self.open())
        self.root = pn.Column(self._words, self.offer, sizing_mode="stretch_width", margin=(4, 8))
        self.rest()

    def open(self) -> None:
        """Offer the choice by keyboard."""
        if self.chooser is None:
            self.chooser = ElementChooser(self.follow, self._pick)
            self.root[:2] = [self.chooser.root, self._words]
            if self._run is not None:
                self.chooser.bound(self._run.scenario.road.elements)

    def prepare(self, run: Run) -> None:
        """Take a run whose simulation is made; an element that it has, too, is followed on."""
        self.rest()
        elements = run.scenario.road.elements
        if self.chooser is not None:
            self.chooser.bound(elements)
        if self.element is not None and max(self.element) >= elements:
            self.forget()
        self._run = run
        if self.element is not None:
            self.follow(*self.element)

    def follow(self, row: int, column: int) -> None:
        """Follow an element; before there is a run, as soon as there is one."""
        self.element = row, column
        if self._run is None or self._run.simulation is None:
            self._say(WAITING.format(row, column))
            return
        self.open()
        self._build()
        assert self.chooser is not None
        self.chooser.show(row, column)
        self._show_inputs(self._run.simulation)
        self._drawn, self._covered = None, 0
        self._draw()
        self.on_follow(row, column)

    def forget(self) -> None:
        """Follow none."""
        self.element = None
        self.rest()
        if self.forces is not None:
            self._row.visible = False

    def rest(self) -> None:
        """Show no run; the element is followed on in the next one."""
        self._run, self._step, self._ended = None, 0, False
        self._drawn, self._covered = None, 0
        if self.forces is not None and self.heights is not None:
            self.forces.clear()
            self.heights.clear()
        self._say(INVITATION if self.element is None else WAITING.format(*self.element))

    def update(self, run: Run, step: int, ended: bool) -> None:
        """Show a step of the run that was prepared; `ended` where no more will come."""
        self._run, self._step, self._ended = run, step, ended
        self._draw()

    def show_against(self, axis: Horizontal) -> None:
        """Change the horizontal axis of the force."""
        self._axis = axis
        if self.forces is not None:
            self.forces.show_against(axis)

    def enlarge(self, size: Size) -> None:
        """Set the type."""
        self._size = size
        if self.forces is not None and self.heights is not None:
            for fig in (self.forces.history, self.forces.spring):
                enlarge(fig, size)
            self.heights.enlarge(size)

    def darken(self, dark: bool) -> None:
        """Follow the page's theme."""
        self._dark = dark
        if self.forces is not None:
            self.forces.darken(dark)

    def _build(self) -> None:
        """Make the plots, once."""
        if self.forces is None:
            self.forces, self.heights = ForcePlots(), HeightsPlot()
            figures = (self.forces.history, self.forces.spring)
            panes = [pn.pane.Bokeh(fig, sizing_mode="stretch_width") for fig in figures]
            panes.append(pn.pane.Bokeh(self.heights.root))
            self._row = pn.Row(*panes, stylesheets=[_SIDE_BY_SIDE], sizing_mode="stretch_width")
            self.root.append(self._row)
            self.enlarge(self._size)
            self.darken(self._dark)
            if self._axis is not None:
                self.show_against(self._axis)
        self._row.visible = True

    def _show_inputs(self, simulation: Simulation) -> None:
        """What the element brings along: its spring, its bond's limit, its heights."""
        assert self.element is not None
        assert self.forces is not None
        assert self.heights is not None
        row, column = self.element
        elements = simulation.scenario.road.elements
        law, element = simulation.bodies.law, row * elements + column
        limit = constant_limit(law, element)
        sticks = limit != 0 and not isinstance(law, Hysteresis | RecedingContact)
        self.forces.clear()
        self.forces.show_spring(simulation.springs, element, limit, sticks)
        heights = simulation.patch.heights
        side = len(heights) // elements
        own = heights[row * side : (row + 1) * side, column * side : (column + 1) * side]
        every = -(-side // _HEIGHTS)
        spacing = simulation.kernel.spacing
        self.heights.show(
            own[::every, ::every] - own.max(), (column * spacing, row * spacing), spacing
        )

    def _draw(self) -> None:
        run = self._run
        if self.element is None or run is None or run.record is None or not run.record.count:
            return
        assert run.simulation is not None
        assert self.heights is not None
        number, fields = run.record.fields(min(self._step, run.record.count - 1))
        self._draw_way(run.record)
        if self._drawn == number:
            return
        self._drawn = number
        self._draw_point(run.record, number, fields)
        area = run.simulation.kernel.spacing**2
        self.heights.touch(float(fields["contact_area"][self.element]) / area)
        self._say(say(*self.element, fields, area))

    def _draw_way(self, record: Record) -> None:
        """The element so far, when there is visibly more of it."""
        assert self.element is not None
        assert self.forces is not None
        steps, force = record.history("element_force", *self.element)
        reached = int(steps[-1]) + 1  # of a long run ever fewer are kept
        enough = reached >= self._covered + max(1.0, _GROWTH * self._covered)
        if not enough and not (self._ended and reached != self._covered):
            return
        _, depth = record.history("compression", *self.element)
        shared = min(force.size, depth.size)  # a step may have come between the two
        self._covered = int(steps[shared - 1]) + 1
        shown = extremes(force[:shared], max(1, -(-2 * shared // _POINTS)))
        shown = np.union1d(shown, [0, shared - 1])
        self.forces.show_path(_points(record, steps[shown], force[shown], depth[shown]))

    def _draw_point(self, record: Record, number: int, fields: Fields) -> None:
        assert self.element is not None
        assert self.forces is not None
        force, depth = (
            np.array([fields[name][self.element]]) for name in ("element_force", "compression")
        )
        self.forces.show_now(_points(record, np.array([number]), force, depth))

    def _pick(self, wish: str) -> None:
        """Follow the element that stands out at the step on show."""
        run = self._run
        if run is None or run.record is None or not run.record.count:
            self._say("Press Run first: then an element can be followed.")
            return
        _, fields = run.record.fields(min(self._step, run.record.count - 1))
        force = fields["element_force"]
        pulled = wish == "In tension"
        if pulled and not (fields["state"] == ElementState.TENSION).any():
            self._say("No element is in tension at this step.")
            return
        place = int((-force if pulled else force).argmax())
        self.follow(*divmod(place, force.shape[1]))

    def _say(self, sentence: str) -> None:
        self.sentence = sentence
        self._words.object = escape(sentence)


def _points(
    record: Record, steps: np.ndarray, force: np.ndarray, depth: np.ndarray
) -> dict[str, np.ndarray]:
    """Columns of the plots; what is apart has no working point on its spring."""
    columns = record.columns
    return {
        "time_ms": columns["time"][steps] * 1e3,
        "indentation_um": columns["indentation"][steps] * 1e6,
        "force": force,
        "compression_um": np.where((force == 0) & (depth < 0), np.nan, depth * 1e6),
    }
