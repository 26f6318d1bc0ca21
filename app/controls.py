"""The form: fields made from the settings' one declaration, and the scenario they stand for."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import panel as pn
import panel_material_ui as pmui

from tyrecontact import Scenario, presets
from tyrecontact.errors import InputError

from .fields import NAMES, Field
from .history import History, Past
from .road_dialog import SETTINGS
from .road_file import RoadFile
from .text_file import TextFile

#: the four that the product is about
MAIN = tuple(NAMES)
#: folded groups: title -> parts
GROUPS = {
    "Loading": ("loading",),
    "Adhesion": ("adhesion",),
    "Road and springs": ("road", "springs"),
    "Tread": ("tread",),
    "Numerics": ("numerics",),
}
#: settings that the road-file control sets itself
OF_ROAD_FILE = ("road.file", "road.pitch", "road.height_unit")
#: settings that go with a road file from preset to preset
OF_ROAD = tuple(f"road.{name}" for name in (*SETTINGS, "file"))
#: settings that name a file, which a visitor may bring but not name: path -> what it is
OF_FILES = {
    "loading.table": "Loading table (profile: table)",
    "tread.modulus_table": "Modulus table (material: tabulated)",
}


class Controls:
    """Fields and scenario, kept equal.

    Parameters
    ----------
    refuse : called with one sentence about a value that was not taken.
    changed : called with the paths of settings that now are others.

    Attributes
    ----------
    preset : name of the preset the form started from.
    scenario : what the form says now.
    road_file : the control that takes a road file.
    root : what stands in the sidebar, from the top.
    """

    def __init__(
        self, refuse: Callable[[str], None], changed: Callable[[Iterable[str]], None]
    ) -> None:
        self._refuse, self._tell = refuse, changed
        self.preset = "default"
        self.scenario = presets.get(self.preset)
        self._plain = presets.get(self.preset)
        self.history = History(self._state())
        self._fields: dict[str, Field] = {}
        self.road_file = RoadFile(self.take_road, refuse, lambda: self.scenario.road)
        self.text_files = {
            path: TextFile(title, partial(self.change, path), refuse)
            for path, title in OF_FILES.items()
        }
        self._groups = [pn.Column(sizing_mode="stretch_width") for _ in GROUPS]
        # folded groups are neither made nor drawn: seventy widgets would keep a browser busy
        self._folded = pmui.Accordion(
            *zip(GROUPS, self._groups, strict=True), title_variant="body1", dynamic=True,
            toggle=True, disable_gutters=True, sizing_mode="stretch_width", margin=(10, 5),
        )  # fmt: skip
        self._folded.param.watch(lambda event: self._unfold(event.new), "active")
        main = [self.field(path).root for path in MAIN]
        self.root = [pn.Column(*main, sizing_mode="stretch_width"), self._folded]

    def field(self, path: str) -> Field:
        """The field of a setting, made when first asked for."""
        if path not in self._fields:
            _, parameter = self.scenario.find(path)
            made = Field(path, parameter, self.value(path), self.change, self.restore)
            made.mark(self.differs(path))
            self._fields[path] = made
        return self._fields[path]

    def value(self, path: str) -> Any:
        """A setting's value [SI]."""
        part, _ = self.scenario.find(path)
        return getattr(part, _name(path))

    def differs(self, path: str) -> bool:
        """Whether a setting is another one than the preset's."""
        return bool(self.value(path) != getattr(self._plain.find(path)[0], _name(path)))

    def changes(self) -> list[str]:
        """Paths of all settings that are others than the preset's."""
        return [path for path, _, _ in self.scenario.settings() if self.differs(path)]

    def change(self, path: str, value: Any) -> None:
        """Set one setting [SI], from wherever; refused with a sentence where it cannot be."""
        self.change_all({path: value})

    def change_all(self, values: dict[str, Any]) -> None:
        """Set several settings [SI] at once: all of them, or none."""
        trial = self.scenario.copy()
        try:
            for path, value in values.items():
                trial.set(path, value)
            _require_no_file(trial.tread.layers)
        except InputError as error:
            self._refuse(str(error))
            self._show(values)
            return
        for path in values:
            self.scenario.set(path, getattr(trial.find(path)[0], _name(path)))
        self.history.add(self._state(), ",".join(values))
        self._show(values)
        self._tell(values)

    def restore(self, path: str) -> None:
        """Take the preset's value of a setting."""
        self.change(path, getattr(self._plain.find(path)[0], _name(path)))

    def load(
        self, preset: str, scenario: Scenario | None = None, *, keep_road: bool = True
    ) -> None:
        """Show a preset, or a scenario that began as one; a road file that was taken stays, if it
        is to.
        """
        plain = presets.get(preset)
        scenario = plain.copy() if scenario is None else scenario.copy()
        own = self.scenario.road.file if keep_road else ""
        if own and own != self._plain.road.file and not scenario.road.file:
            for path in OF_ROAD:
                scenario.set(path, self.value(path))
        self._plain = plain
        self._begin(preset, scenario)

    def reset(self) -> None:
        """Back to the preset, in all settings; undo brings them back."""
        self._begin(self.preset, self._plain.copy())

    def undo(self) -> None:
        self._back_to(self.history.undo())

    def redo(self) -> None:
        self._back_to(self.history.redo())

    def take_road(self, settings: dict[str, Any]) -> None:
        """Use a road file, with settings by path; or none, and the preset's instead."""
        if not settings.get("road.file"):
            plain = {path: value for path, _, value in self._plain.settings()}
            settings = {path: plain[path] for path in settings}
        self.change_all(settings)

    def close(self) -> None:
        """Remove what the visitor has brought."""
        self.road_file.close()
        for file in self.text_files.values():
            file.close()

    def _begin(self, preset: str, scenario: Scenario) -> None:
        self.preset, self.scenario = preset, scenario
        self.history.add(self._state(), "")
        self._show_all()

    def _back_to(self, state: Past | None) -> None:
        if state is None:
            return
        self.preset, self._plain = state.preset, presets.get(state.preset)
        self.scenario = Scenario(**state.settings)
        self._show_all()

    def _state(self) -> Past:
        return Past(self.preset, self.scenario.to_dict())

    def _show_all(self) -> None:
        self._show(self._fields)
        self._tell([path for path, _, _ in self.scenario.settings()])

    def _show(self, paths: Iterable[str]) -> None:
        self.road_file.show(self.scenario.road.file)
        for path, file in self.text_files.items():
            file.show(self.value(path))
        for path in paths:
            if path in self._fields:
                self._fields[path].set(self.value(path))
                self._fields[path].mark(self.differs(path))

    def _unfold(self, active: list[int]) -> None:
        for index in active:
            if not self._groups[index].objects:
                self._groups[index].objects = self._rows(list(GROUPS.values())[index])
                self._folded.param.trigger("objects")

    def _rows(self, parts: tuple[str, ...]) -> list[Any]:
        """Fields of parts, but for those on top; and what takes files."""
        rows: list[Any] = [self.road_file.root] if "road" in parts else []
        for path, _, _ in self.scenario.settings():
            if path.partition(".")[0] not in parts or path in (*MAIN, *OF_ROAD_FILE):
                continue
            rows.append((self.text_files.get(path) or self.field(path)).root)
        return rows


def _require_no_file(layers: list[dict[str, Any]]) -> None:
    """A visitor's layers read no file of the server, not even to say what is wrong with it."""
    for layer in layers:
        if named := layer.get("modulus_table"):
            raise InputError(
                "modulus_table of a layer must be empty on the page, where no file can be named, "
                f"got {str(named)[:40]!r}: bring it as the modulus table of one layer"
            )


def _name(path: str) -> str:
    """ "rate" of "loading.rate"."""
    return path.partition(".")[2]
