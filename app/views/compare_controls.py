"""What can be done with pinned runs: pin, rename, unpin, and choose what is compared."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any
from weakref import ref

import panel as pn
import panel_material_ui as pmui

from tyrecontact.errors import InputError

from ..pinned import Pinned
from ..runner import Run
from ..shelf import LONGEST, MOST, Shelf
from .compare_plots import DEPTH, TIME

_WRAP = ":host { flex-wrap: wrap; align-items: center; }"
_SMALL: dict[str, Any] = {"size": "small", "margin": (6, 6)}
#: no fixed width: a row would be as wide as all of them together, also on a phone
_FIELD: dict[str, Any] = {
    **_SMALL, "sizing_mode": "stretch_width", "max_width": 230,
    "styles": {"flex": "1 1 150px", "width": "auto", "min-width": "0"},
}  # fmt: skip


class CompareControls:
    """One set of widgets for all pinned runs.

    Parameters
    ----------
    shelf : is changed.
    changed : called when another plot is asked for, or there is something to be said.

    Attributes
    ----------
    root : the widgets.  said : what came of the last click, or empty.
    """

    def __init__(self, shelf: Shelf, changed: Callable[[], None]) -> None:
        self._shelf, self._changed = shelf, changed
        self._about: ref[Run] | None = None
        self._setting = False
        self._offered: tuple[Pinned, ...] = ()
        self._of_label = ""  # of the pinned run whose label stands in the entry
        self.said = ""
        self.pin = pmui.Button(label="Pin this run", variant="contained", **_SMALL)
        self.chosen = pmui.Select(label="Pinned run", **_FIELD)
        self.label = pmui.TextInput(label="Its label", max_length=LONGEST, **_FIELD)
        self.rename = pmui.Button(label="Rename", variant="outlined", **_SMALL)
        self.unpin = pmui.Button(label="Unpin", variant="outlined", **_SMALL)
        self.reference = pmui.Select(label="Differences from", **_FIELD)
        self.axis = pmui.Select(
            label="Force and iterations against", options=[DEPTH, TIME], value=DEPTH,
            **_FIELD,
        )  # fmt: skip
        self.root = pn.Row(
            self.pin, self.chosen, self.label, self.rename, self.unpin, self.reference, self.axis,
            sizing_mode="stretch_width", margin=0, stylesheets=[_WRAP],
        )  # fmt: skip
        self.pin.on_click(lambda _: self._try(self._pin))
        self.rename.on_click(lambda _: self._try(self._rename))
        self.unpin.on_click(lambda _: self._try(self._unpin))
        self.chosen.param.watch(lambda event: self._choose(event.new), "value")
        for asked in (self.reference, self.axis):
            asked.param.watch(lambda _: self._ask(), "value")

    def _run(self) -> Run | None:
        return None if self._about is None else self._about()

    def update(self, run: Run | None, compared: Sequence[Pinned]) -> None:
        """Offer what can be done now with the run on show and those that are compared."""
        if run is not self._run():
            self.said = ""
        self._about, self._setting = None if run is None else ref(run), True
        try:
            pinned = self._shelf.pinned
            _offer(self.chosen, self._offered, pinned)
            _offer(self.reference, self._offered, compared)
            self._offered = tuple(compared)
            if self._of_label != self.chosen.value:
                self._of_label = self.label.value = self.chosen.value or ""
            begun = run is not None and run.record is not None and run.record.count > 0
            self.pin.disabled = not begun
            about_pins = (self.chosen, self.label, self.rename, self.unpin)
            for widget in about_pins:
                widget.disabled = not pinned
            for widget in (*about_pins, self.reference, self.axis):
                widget.visible = bool(pinned)  # an empty choice says nothing
        finally:
            self._setting = False

    def _choose(self, label: str | None) -> None:
        if not self._setting:
            self._of_label = self.label.value = label or ""

    def _ask(self) -> None:
        if not self._setting:
            self._changed()

    def _try(self, action: Callable[[], str]) -> None:
        try:
            self.said = action()
        except InputError as error:
            self.said = f"Not done: {error}."
        self._changed()

    def _pin(self) -> str:
        run = self._run()
        assert run is not None  # the button is disabled until there is one
        pin = self._shelf.pin(run)
        full = f" {len(self._shelf.pinned)} of {MOST} places are taken."
        remark = f", {pin.remark}: pin it again when it has come further" if pin.remark else ""
        return f"Pinned as “{pin.label}”{remark}.{full}"

    def _rename(self) -> str:
        before, new = str(self.chosen.value), str(self.label.value)
        self._shelf.rename(before, new)
        return f"“{before}” is now “{' '.join(new.split())}”."

    def _unpin(self) -> str:
        label = str(self.chosen.value)
        self._shelf.unpin(label)
        return f"“{label}” is no longer pinned."


def _offer(select: pmui.Select, before: Sequence[Pinned], runs: Sequence[Pinned]) -> None:
    """Runs to choose from; the choice stays on its run, which is known by its look."""
    look = next((run.look for run in before if run.label == select.value), None)
    labels = [run.label for run in runs]
    if select.options != labels:
        kept = [run.label for run in runs if run.look == look] or labels
        select.param.update(options=labels, value=kept[0] if kept else None)
