"""The dialog on a road file: what was understood, what is asked, what part of it is used."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import panel as pn
import panel_material_ui as pmui

from tyrecontact.errors import InputError
from tyrecontact.parts.road import Road
from tyrecontact.road.understood import Understood
from tyrecontact.settings import Count

from .road_reading import Look, square_that_fits
from .views.road_facts import BUSY, banner, table
from .views.road_preview import RoadPreview

#: settings that are asked as numbers: name -> label
_NUMBERS = {
    "pitch": "Pitch of the heights",
    "trim_start": "Trim off the start",
    "trim_end": "Trim off the end",
    "size": "Side of the patch",
    "centre_x": "Off the middle, x",
    "centre_y": "Off the middle, y",
    "elements": "Elements along a side",
    "fill_limit": "Fill at most a share of",
}
#: settings that are chosen: name -> label, and words for the values
_CHOICES: dict[str, tuple[str, dict[str, str]]] = {
    "height_unit": ("Unit of the heights",
                    {"as in the file": "", "m": "m", "mm": "mm", "µm": "um"}),
    "height_direction": ("Heights count", {"up": "up", "down (depths)": "down"}),
    "levelling": ("Levelling", {"take a plane off": "plane", "leave as it is": "none"}),
    "profile_use": ("Profile becomes", {"ridges, drawn out sideways": "corrugated",
                                        "a road like it in all directions": "isotropic"}),
}  # fmt: skip
_OF_PROFILES, _OF_MAPS = ("trim_start", "trim_end", "profile_use"), ("centre_y",)
#: how fields follow one another: what the file is, then what is used of it
_ORDER = (
    "pitch", "height_unit", "height_direction", "levelling", "trim_start", "trim_end",
    "profile_use", "size", "centre_x", "centre_y", "elements", "fill_limit",
)  # fmt: skip
_ASKED = {"pitch": "the distance of its heights (pitch)", "unit": "the unit of its heights"}
#: signs of a file's name in the title
_SHORT = 22
#: settings that the dialog decides on
SETTINGS = (*_NUMBERS, *_CHOICES)


class RoadDialog:
    """Asks, and shows what comes of the answers.

    Parameters
    ----------
    ask : called with the settings when they change: a `show` is to follow.
    use, cancel : called when the visitor has decided.

    Attributes
    ----------
    root : of Panel, to be placed once. fields : name of a setting -> its widget.
    message, facts, preview, busy : what is shown. use_button, cancel_button.
    """

    def __init__(
        self, ask: Callable[[Road], None], use: Callable[[], None], cancel: Callable[[], None]
    ) -> None:
        self._ask = ask
        self._loading = False
        self._base = Road()
        self._fresh = True
        self._found: Understood | None = None
        self.fields: dict[str, Any] = {
            name: _number(name, label) for name, label in _NUMBERS.items()
        }
        for name, (label, options) in _CHOICES.items():
            self.fields[name] = pmui.Select(label=label, options=options, **_SMALL)
        self.message = pn.pane.HTML("", margin=(4, 10), sizing_mode="stretch_width")
        self.facts = pn.pane.HTML("", margin=(4, 10), sizing_mode="stretch_width")
        self.preview = RoadPreview()
        self.busy = pn.pane.HTML("", height=10, margin=(0, 10), sizing_mode="stretch_width")
        self.use_button = pmui.Button(label="Use this road", variant="contained", disabled=True)
        self.cancel_button = pmui.Button(label="Cancel", variant="outlined")
        self.use_button.on_click(lambda _: use())
        self.cancel_button.on_click(lambda _: cancel())
        for field in self.fields.values():
            field.param.watch(lambda _: self._changed(), "value")
        self.root = self._layout()

    def open(self, name: str, road: Road, fresh: bool) -> None:
        """Begin with a file and settings; a `fresh` one is offered the largest patch that fits."""
        self._base, self._fresh = road, fresh
        self._fill(road)
        self._empty()
        self.root.param.update(title=_title(name), open=True)
        self._changed()

    def refuse(self, name: str, sentence: str) -> None:
        """Say why a file is not even looked at."""
        self._empty()
        self.busy.object = ""
        self.use_button.disabled = True
        self._say("error", _sentence(sentence))
        self.root.param.update(title=_title(name), open=True)

    def close(self) -> None:
        """Leave the page to itself again."""
        self.root.open = False

    def road(self) -> Road:
        """The settings as they stand; `InputError` where one is out of its bounds."""
        values: dict[str, Any] = dict(self._base.param.values())
        del values["name"]
        for name in _NUMBERS:
            scale = Road.param[name].metadata["shown_in"][1]
            value = self.fields[name].value or 0
            values[name] = value if name == "elements" else value / scale
        for name in _CHOICES:
            values[name] = self.fields[name].value
        return Road(**values)

    def show(self, look: Look, road: Road) -> None:
        """What came of the settings."""
        self.busy.object = ""
        if look.found is not None and look.view is not None:
            side = square_that_fits(look, road.size)
            if self._fresh and side != road.size and side >= Road.param.size.bounds[0]:
                self._offer(side)
                return
            self._fresh, self._found = False, look.found
            self.preview.show(look.view, road)
        # what was read with other answers is not what these give
        self.facts.object = "" if look.found is None else table(look.found)
        self._arrange(look)
        self.use_button.disabled = not look.usable
        self._say(*_verdict(look, road))

    def _say(self, kind: str, text: str) -> None:
        self.message.object = banner(kind, text)

    def _offer(self, side: float) -> None:
        self._fresh = False
        self.fields["size"].value = side * 1e3

    def _changed(self) -> None:
        if self._loading:
            return
        self.use_button.disabled = True
        try:
            road = self.road()
        except InputError as error:
            self.busy.object = ""
            self._say("error", _sentence(str(error)))
            return
        self.busy.object = BUSY
        if self._found is None:
            self._say("info", "Reading the file …")
        self.preview.mark(road)
        self._ask(road)

    def _fill(self, road: Road) -> None:
        self._loading = True
        for name in _NUMBERS:
            value, scale = getattr(road, name), Road.param[name].metadata["shown_in"][1]
            self.fields[name].value = value if name == "elements" else value * scale
        for name in _CHOICES:
            self.fields[name].value = getattr(road, name)
        self._loading = False

    def _empty(self) -> None:
        """Nothing is known of the file."""
        self._found, self.facts.object = None, ""
        self.preview.clear()
        self._arrange(None)

    def _arrange(self, look: Look | None) -> None:
        """Show the fields that mean something for the file, and mark those that must be filled.

        Those of a file that was understood before stay: one of them may have to be put right.
        """
        found = self._found
        missing = look.missing if look is not None else ()
        for name, field in self.fields.items():
            profile = found is not None and found.profile
            known = name in ("pitch", "height_unit") or found is not None
            fits = name not in (_OF_MAPS if profile else _OF_PROFILES)
            if name == "fill_limit":
                fits = found is not None and found.missing_share > 0
            field.visible = known and fits and (found is not None or bool(missing))
        self.fields["pitch"].param.update(
            error_state="pitch" in missing,
            helper_text="must be given" if "pitch" in missing else "0: as in the file",
        )
        self.fields["height_unit"].error_state = "unit" in missing
        drawn = look is not None and look.found is not None
        self.preview.root.visible = drawn  # a pane of HTML must not come and go so

    def _layout(self) -> pmui.Dialog:
        fields = pn.FlexBox(*(self.fields[name] for name in _ORDER), gap="0px", margin=0)
        return pmui.Dialog(
            self.message, self.busy,
            pmui.Grid(
                pmui.Grid(self.facts, size={"xs": 12, "md": 5}),
                pmui.Grid(self.preview.root, size={"xs": 12, "md": 7}),
                container=True, spacing=1, sizing_mode="stretch_width",
            ),
            fields,
            pn.Row(self.use_button, self.cancel_button),
            title="Your road", title_variant="h6", width_option="md", scroll="paper",
            sizing_mode="stretch_width",
        )  # fmt: skip


_SMALL: dict[str, Any] = {"size": "small", "width": 188, "margin": (8, 8)}


def _number(name: str, label: str) -> pmui.FloatInput | pmui.IntInput:
    unit = Road.param[name].metadata["shown_in"][0]
    kind = pmui.IntInput if isinstance(Road.param[name], Count) else pmui.FloatInput
    # its buttons for more and less have no name to a screen reader; the arrow keys do the same
    plain = {"& .MuiIconButton-root": {"display": "none"}}
    return kind(label=f"{label} [{unit}]" if unit else label, sx=plain, **_SMALL)


def _verdict(look: Look, road: Road) -> tuple[str, str]:
    """How the answer looks, and what it says."""
    if look.missing:
        asked = " and ".join(_ASKED[what] for what in look.missing)
        return "warning", f"The file does not say {asked}. Nothing is guessed: please give it."
    if look.refusal:
        return "error", _sentence(look.refusal)
    assert look.found is not None
    if look.found.doubts:
        return "warning", f"Please check: {'; '.join(look.found.doubts)}."
    side = f"{road.size * 1e3:.4g} mm"
    return "success", f"This is what was understood. A patch of {side} × {side} will be used."


def _title(name: str) -> str:
    """With a name that fits on a phone; the facts have it in full."""
    return f"Your road: {name if len(name) <= _SHORT else f'{name[:12]}…{name[-9:]}'}"


def _sentence(text: str) -> str:
    """With a capital and a full stop, and settings called as their fields are."""
    for name, label in _NUMBERS.items():
        text = text.replace(f"road.{name} must", f"{label} must")
    return f"{text[:1].upper()}{text[1:].rstrip('.')}."
