"""One setting on the form: a widget made from its declaration, a mark and a way back."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import panel_material_ui as pmui
import param
from panel.custom import JSComponent

from tyrecontact.settings import Choice, Count, Tables

#: names that say more than those of the settings: path -> label
NAMES = {
    "adhesion.release_force": "Release criterion",
    "loading.profile": "Loading profile",
    "numerics.time_resolution_factor": "Time-resolution factor",
    "springs.exchange_count": "Spring exchange",
}
#: sliders whose range does not follow from the value: path -> (start, end, step), as shown
_SPANS = {
    "adhesion.release_force": (0.0, 3.0, 0.05),
    "springs.exchange_count": (0, 200, 10),
    "loading.mass": (0.0, 2.0, 0.05),
    "loading.hold_time": (0.0, 10.0, 0.5),
    "adhesion.table_step": (0.0, 5.0, 0.1),
}
#: settings for which a slider means little
_TYPED = {"road.seed", "road.pixel", "numerics.tolerance", "numerics.sampling_frequency"}
#: a browser may send whole numbers that no float holds
_LARGEST = 1e300
#: counts of which a few are meant
_FEW = {"numerics.time_resolution_factor": [1, 2, 4, 8, 16]}


class SettingWidget(JSComponent):
    """Slider and exact entry together, or a choice.

    Plain elements of the browser, because a form has ninety of them, and because Panel's and
    Material's editable sliders leave the entry without a name for who cannot see it.

    Attributes
    ----------
    value : as shown; None where an entry was emptied.
    options : of a choice; a number where empty.
    start, end, step : of the slider; none where step is None.
    low, high : bounds.
    differs : whether to mark it.
    """

    value = param.Parameter()
    label = param.String()
    description = param.String()
    options = param.List(default=[])
    start = param.Number(default=0.0)
    end = param.Number(default=1.0)
    step = param.Number(default=None, allow_None=True)
    low = param.Number(default=None, allow_None=True)
    high = param.Number(default=None, allow_None=True)
    differs = param.Boolean(default=False)

    _esm = Path(__file__).parent / "setting.js"
    _stylesheets: ClassVar[list[Any]] = [Path(__file__).parent / "setting.css"]

    def __init__(self, restore: Callable[[], None], **params: Any) -> None:
        super().__init__(**params)
        self._restore = restore

    def _handle_msg(self, data: Any) -> None:
        if isinstance(data, dict) and data.get("restore") is True:
            self._restore()


class Field:
    """A setting.

    Parameters
    ----------
    path : "loading.rate".  parameter : its declaration.  value : in SI.
    change : called with path and the new value [SI] when the visitor has changed it.
    restore : called with the path when the visitor wants the preset's value back.

    Attributes
    ----------
    root : the widget.
    """

    def __init__(
        self,
        path: str,
        parameter: param.Parameter,
        value: Any,
        change: Callable[[str, Any], None],
        restore: Callable[[str], None],
    ) -> None:
        self._path, self._parameter, self._change = path, parameter, change
        self._setting = False
        unit, self._scale = parameter.metadata["shown_in"]
        label = f"{label_of(path)} [{unit}]" if unit else label_of(path)
        self.root = _widget(path, parameter, self._shown(value), label, lambda: restore(path))
        self.root.param.watch(self._moved, "value")

    def set(self, value: Any) -> None:
        """Show a value [SI]; nobody is told."""
        self._setting = True
        try:
            self.root.value = self._shown(value)
        finally:
            self._setting = False

    def mark(self, differs: bool) -> None:
        """Mark the setting as another one than the preset's."""
        if isinstance(self.root, SettingWidget) and self.root.differs != differs:
            self.root.differs = differs

    def _moved(self, event: param.parameterized.Event) -> None:
        if self._setting:
            return
        value = event.new
        if isinstance(self._parameter, Tables) and isinstance(value, str) and not value.strip():
            value = []
        if isinstance(self._parameter, Count) and isinstance(value, float) and value.is_integer():
            value = int(value)
        exact = isinstance(self._parameter, Choice | Count | Tables)
        # what is no number, or none of this world, is refused as it is
        number = isinstance(value, int | float) and not isinstance(value, bool)
        scaled = number and not exact and abs(value) < _LARGEST
        self._change(self._path, value / self._scale if scaled else value)

    def _shown(self, value: Any) -> Any:
        if isinstance(self._parameter, Tables):
            return json.dumps(value, indent=1) if value else ""
        return value if isinstance(self._parameter, Choice | Count) else _tidy(value * self._scale)


def label_of(path: str) -> str:
    """ "tread.base_poissons_ratio" as "Base Poisson's ratio"."""
    name = path.partition(".")[2].replace("_", " ")
    name = name.replace("youngs", "Young's").replace("poissons", "Poisson's")
    return NAMES.get(path) or name[:1].upper() + name[1:]


def _tidy(value: float) -> float:
    """Without the last bits that a change of unit leaves: 0.2 and not 0.20000000000000001."""
    return float(f"{value:.12g}")


def _widget(
    path: str, parameter: param.Parameter, value: Any, label: str, restore: Callable[[], None]
) -> Any:
    common = {"value": value, "label": label, "margin": (3, 10), "sizing_mode": "stretch_width"}
    if isinstance(parameter, Tables):
        return pmui.TextAreaInput(
            rows=3, max_length=20_000, size="small", description=parameter.doc,
            placeholder='[{"thickness": 0.002, "density": 1200, ...}, ...] from the top down',
            **common,
        )  # fmt: skip
    common["description"] = meaning(parameter)
    if isinstance(parameter, Choice) or path in _FEW:
        options = _FEW.get(path) or list(parameter.objects)
        return SettingWidget(restore, options=options, **common)
    whole = isinstance(parameter, Count)
    scale = 1 if whole else parameter.metadata["shown_in"][1]
    low, high = (bound * scale for bound in parameter.bounds)
    if path not in _TYPED:
        start, end, step = _SPANS.get(path) or _span(value, low, high, whole)
        common.update(start=start, end=end, step=step)
    return SettingWidget(restore, low=low, high=high, **common)


def meaning(parameter: param.Parameter) -> str:
    """What a setting means, and where the thesis has it."""
    owner = parameter.owner if isinstance(parameter.owner, type) else type(parameter.owner)
    source = (owner.__doc__ or "").partition("\n")[0].partition("(thesis, ")[2].partition(")")[0]
    return f"{parameter.doc}. Thesis: {source}." if source else f"{parameter.doc}."


def _span(value: float, low: float, high: float, whole: bool) -> tuple[float, float, float]:
    """Range and step of a slider about a value: to some three times of it, in round numbers.

    A browser counts the steps from the start: a bound that is no multiple of them is left to the
    entry.
    """
    most = min(3 * abs(value), max(abs(low), abs(high))) or min(high, 1.0)
    step = 10.0 ** math.floor(math.log10(most / 20))
    step = max(1.0, step) if whole else step
    end = min(high, _tidy(step * math.ceil(most / step)))
    first = _tidy(step * math.ceil(low / step))
    start = max(first if first <= value else low, -end if value < 0 else 0.0)
    return start, end, step
