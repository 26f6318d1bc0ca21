"""The form: widgets made from the settings' one declaration, and the scenario they stand for."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import panel_material_ui as pmui
import param

from tyrecontact import Scenario, presets
from tyrecontact.errors import InputError
from tyrecontact.settings import Choice, Count, Tables, Text

from .road_file import RoadFile

#: the four that the product is about: path -> label
MAIN = {
    "adhesion.release_force": "Release criterion",
    "loading.profile": "Loading profile",
    "numerics.time_resolution_factor": "Time-resolution factor",
    "springs.exchange_count": "Spring exchange",
}
#: folded groups: title -> parts
GROUPS = {
    "Loading": ("loading",),
    "Adhesion": ("adhesion",),
    "Road and springs": ("road", "springs"),
    "Tread": ("tread",),
    "Numerics": ("numerics",),
}
#: settings that the road-file control sets itself
_OF_ROAD_FILE = {"road.file", "road.pitch", "road.height_unit"}
#: profiles that need a file of the server's, which no visitor may name
_OF_FILES = {"table"}


class Controls:
    """Widgets and scenario, kept equal.

    Parameters
    ----------
    refuse : called with one sentence about a value that was not taken.
    accept : called when one was.

    Attributes
    ----------
    scenario : what the form says now.
    widgets : path of a setting -> its widget.
    road_file : the control that takes a road file.
    root : list of what stands in the sidebar, from the top.
    """

    def __init__(self, refuse: Callable[[str], None], accept: Callable[[], None]) -> None:
        self._refuse, self._accept = refuse, accept
        self._loading = False
        self.scenario = presets.get("default")
        self.widgets: dict[str, Any] = {}
        self._scales: dict[str, float] = {}
        for path, parameter, value in self.scenario.settings():
            if path not in _OF_ROAD_FILE and not isinstance(parameter, Text | Tables):
                self._add(path, parameter, value)
        self.road_file = RoadFile(self._take_road, refuse)
        self.root = [self._main(), self._folded()]

    def load(self, scenario: Scenario) -> None:
        """Show another scenario; a road file that was taken stays."""
        for path in _OF_ROAD_FILE:
            scenario.set(path, self._value(self.scenario, path))
        self.scenario = scenario
        self._loading = True
        try:
            for path, widget in self.widgets.items():
                value = self._value(scenario, path)
                widget.value = value * self._scales[path] if path in self._scales else value
        finally:
            self._loading = False

    def _add(self, path: str, parameter: param.Parameter, value: Any) -> None:
        unit, scale = parameter.metadata["shown_in"]
        name = MAIN.get(path) or _in_words(parameter.name)
        label = f"{name} [{unit}]" if unit else name
        common = {"label": label, "description": parameter.doc, "sizing_mode": "stretch_width"}
        if not isinstance(parameter, Choice | Count):
            self._scales[path] = scale
            value = value * scale
        self.widgets[path] = _widget(path, parameter, value, common)
        self.widgets[path].param.watch(lambda event, path=path: self._changed(path, event), "value")

    def _changed(self, path: str, event: param.parameterized.Event) -> None:
        if self._loading:
            return
        value = event.new
        if path in self._scales and value is not None:
            value = value / self._scales[path]
        try:
            self.scenario.set(path, value)
            self._accept()
        except InputError as error:
            self._refuse(str(error))
            self._loading = True
            self.widgets[path].value = event.old
            self._loading = False

    def _take_road(self, file: str, pitch: float, unit: str) -> None:
        # the file last: it is not set where its pitch is refused
        self.scenario.set("road.file", "")
        for path, value in (("road.pitch", pitch), ("road.height_unit", unit), ("road.file", file)):
            self.scenario.set(path, value)
        self._accept()

    def _main(self) -> pmui.Column:
        widgets = [self.widgets[path] for path in MAIN]
        title = pmui.Typography("What if …", variant="subtitle2", margin=(10, 10, 0, 10))
        return pmui.Column(title, *widgets, sizing_mode="stretch_width")

    def _folded(self) -> pmui.Accordion:
        groups = []
        for title, parts in GROUPS.items():
            rows = [
                widget
                for path, widget in self.widgets.items()
                if path.partition(".")[0] in parts and path not in MAIN
            ]
            if "road" in parts:
                rows.insert(0, self.road_file.root)
            groups.append((title, pmui.Column(*rows, sizing_mode="stretch_width")))
        return pmui.Accordion(
            *groups, title_variant="body1", sizing_mode="stretch_width", margin=(10, 5)
        )

    @staticmethod
    def _value(scenario: Scenario, path: str) -> Any:
        part, parameter = scenario.find(path)
        return getattr(part, parameter.name)


def _in_words(name: str) -> str:
    """ "base_poissons_ratio" as "Base Poisson's ratio"."""
    words = name.replace("_", " ").replace("youngs", "Young's").replace("poissons", "Poisson's")
    return words[:1].upper() + words[1:]


def _widget(path: str, parameter: param.Parameter, value: Any, common: dict[str, Any]) -> Any:
    if isinstance(parameter, Choice):
        options = [name for name in parameter.objects if name not in _OF_FILES]
        return pmui.Select(options=options, value=value, size="small", **common)
    if path == "numerics.time_resolution_factor":
        return pmui.Select(options=[1, 2, 4], value=value, size="small", **common)
    low, high = parameter.bounds
    if path == "springs.exchange_count":
        return pmui.EditableIntSlider(
            start=0, end=200, fixed_start=low, fixed_end=high, step=10, value=value, **common
        )
    if path == "adhesion.release_force":
        return pmui.EditableFloatSlider(
            start=0.0, end=3.0, fixed_start=low, fixed_end=high, step=0.05, value=value, **common
        )
    kind = pmui.IntInput if isinstance(parameter, Count) else pmui.FloatInput
    return kind(value=value, size="small", **common)
