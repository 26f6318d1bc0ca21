"""The sidebar: what if? Live or not, how fast, undo and redo, and the form."""

from __future__ import annotations

from collections.abc import Callable

import panel as pn
import panel_material_ui as pmui

from tyrecontact import presets

from .controls import Controls

#: label -> least duration of a run [s]
PACES = {"as fast as it can": 0.0, "in about 6 s": 6.0, "in about 20 s": 20.0}


class WhatIf:
    """Form and what stands around it.

    Attributes
    ----------
    live : a switch: a change starts a new run at once.
    pace : least duration of a run.
    undo, redo, reset : buttons.
    root : list of what stands in the sidebar, from the top.
    """

    def __init__(self, controls: Controls, paced: Callable[[float], None]) -> None:
        self._controls = controls
        self.live = pmui.Switch(
            label="Live: a change runs at once", value=False, margin=(2, 10),
        )  # fmt: skip
        self.undo = _icon("Undo", "undo", "Take back the last change (Ctrl+Z)")
        self.redo = _icon("Redo", "redo", "Make it again (Ctrl+Shift+Z)")
        self.reset = _icon("Reset", "restart_alt", "All settings back to the preset's")
        self.caption = pmui.Typography("", variant="caption", margin=(0, 10))
        self.pace = pmui.Select(
            label="Pace of a run", options=list(PACES), value="in about 6 s", size="small",
            sizing_mode="stretch_width", margin=(6, 10),
        )  # fmt: skip
        self.undo.on_click(lambda _: controls.undo())
        self.redo.on_click(lambda _: controls.redo())
        self.reset.on_click(lambda _: controls.reset())
        self.pace.param.watch(lambda _: paced(self.duration), "value")
        title = pmui.Typography("What if …", variant="subtitle2", margin=(10, 0, 0, 10))
        gap = pn.Spacer(sizing_mode="stretch_width", height=1)
        top = pn.Row(
            title, gap, self.undo, self.redo, self.reset, sizing_mode="stretch_width", margin=0
        )
        self.root = [top, self.caption, self.live, *controls.root, self.pace]
        self.update()

    @property
    def duration(self) -> float:
        """Least duration of a run [s]."""
        return PACES[self.pace.value]

    def update(self) -> None:
        """Follow the form."""
        history, changed = self._controls.history, len(self._controls.changes())
        for button, possible in (
            (self.undo, history.can_undo), (self.redo, history.can_redo), (self.reset, changed > 0)
        ):  # fmt: skip
            if button.disabled == possible:
                button.disabled = not possible
        caption = presets.caption(self._controls.preset)
        if changed:
            caption += f" — with {changed} setting{'s' * (changed > 1)} changed (●)"
        if self.caption.object != caption:
            self.caption.object = caption


def _icon(label: str, icon: str, description: str) -> pmui.IconButton:
    return pmui.IconButton(
        label=label, icon=icon, description=description, disabled=True, size="small",
        margin=(6, 2, 0, 2),
    )  # fmt: skip
