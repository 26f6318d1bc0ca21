"""Watch, and what is looked at at rest: one tab each, made when it is first opened."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, Protocol

import panel as pn
import panel_material_ui as pmui
from panel.viewable import Viewable

from .controls import Controls
from .runner import Run
from .shelf import Shelf
from .views.code import CodeView
from .views.compare import CompareView
from .views.energy import EnergyView
from .views.inputs import InputsView
from .views.lesson_list import LessonList
from .views.release import ReleaseView
from .views.stiffness import StiffnessView
from .views.style import DESK, Size
from .views.theory import TheoryView


def makers(
    controls: Controls, shelf: Shelf, begin: Callable[[str], None]
) -> dict[str, Callable[[], Tab]]:
    """The tabs beside the live one: title -> what makes its view."""
    return {
        "Stiffness": StiffnessView,
        "Release": ReleaseView,
        "Energy": EnergyView,
        "Inputs": lambda: InputsTab(controls),
        "Compare": lambda: CompareView(shelf),
        "Lessons": lambda: LessonList(begin),
        "Theory": TheoryView,
        "Code": lambda: CodeTab(controls),
    }


class Tab(Protocol):
    """A view on a run."""

    @property
    def root(self) -> Viewable: ...

    def show(self, run: Run | None, size: Size = DESK) -> None:
        """Draw a run as far as it has come; None before the first."""


class Tabs:
    """The tabs of one session; the first is what is watched live.

    Parameters
    ----------
    live : what stands in the first one.
    makers : title -> what makes the view of a tab, when it is first opened.

    Attributes
    ----------
    root : the tabs.  titles : of all of them, in order.
    """

    def __init__(self, live: Viewable, makers: Mapping[str, Callable[[], Tab]]) -> None:
        self._makers = dict(makers)
        self._made: dict[str, Tab] = {}
        self.titles = ["Watch", *makers]
        self._live = live
        self._places = [
            pn.Column(sizing_mode="stretch_width", margin=0, visible=False) for _ in makers
        ]
        self._run: Run | None = None
        self._size = DESK
        # the places stand below the tabs, not in them: what is taken out of the page and put back
        # is drawn anew, which takes a live plot a second, and it may fail
        empty = [pn.Spacer(height=0) for _ in self.titles]
        self._choice = pmui.Tabs(
            *zip(self.titles, empty, strict=True), sizing_mode="stretch_width", margin=0
        )
        # what changes while the page is still being loaded may never reach the browser
        self._choice.param.watch(
            lambda event: pn.state.onload(partial(self._opened, event.new)), "active"
        )
        self.root = pn.Column(
            self._choice, live, *self._places, sizing_mode="stretch_width", margin=0
        )

    @property
    def title(self) -> str:
        """Of the tab on show."""
        return self.titles[min(self._choice.active, len(self.titles) - 1)]

    def open(self, title: str) -> None:
        """Show a tab."""
        self._choice.active = self.titles.index(title)

    def made(self, title: str) -> Any:
        """The view of a tab that has been opened, or None."""
        return self._made.get(title)

    def show(self, run: Run | None) -> None:
        """Show a run in the tab that is open."""
        self._run = run
        if self.title in self._made:
            self._made[self.title].show(run, self._size)

    def enlarge(self, size: Size) -> None:
        """Set the type."""
        self._size = size
        self.show(self._run)

    def close(self) -> None:
        """End what views may have under way."""
        for view in self._made.values():
            if hasattr(view, "close"):
                view.close()

    def _opened(self, index: int) -> None:
        if index >= len(self.titles):  # no page sends that
            return
        title = self.titles[index]
        if title in self._makers and title not in self._made:
            view = self._made[title] = self._makers[title]()
            self._places[index - 1].objects = [view.root]
        for number, place in enumerate([self._live, *self._places]):
            if place.visible != (number == index):
                place.visible = number == index
        self.show(self._run)


class InputsTab:
    """What goes into the run on show; before the first, what would go into one."""

    def __init__(self, controls: Controls) -> None:
        self._controls, self._view = controls, InputsView()
        self.root = self._view.root

    def show(self, run: Run | None, size: Size = DESK) -> None:
        if run is None:
            self._view.show_scenario(self._controls.scenario, size)
        else:
            self._view.show(run, size)

    def close(self) -> None:
        self._view.close()


class CodeTab:
    """What gives the run that the form stands for."""

    def __init__(self, controls: Controls) -> None:
        self._controls, self._view = controls, CodeView()
        self.root = self._view.root

    def show(self, run: Run | None, size: Size = DESK) -> None:
        controls = self._controls
        self._view.show_scenario(controls.preset, controls.scenario, size)
