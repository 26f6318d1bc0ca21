"""What stands in the header: run, pause, step, stop; preset; share, presentation, help."""

from __future__ import annotations

from functools import partial
from typing import Any

import panel as pn
import panel_material_ui as pmui

from .runner import Phase, Run

#: what is too much for a phone's header stands in its sidebar
_WIDE = "@media (max-width: 700px) { :host { display: none !important; } }"

#: on the dark bar, whatever the theme
_WHITE = {"color": "#fff", "&.Mui-disabled": {"color": "rgba(255, 255, 255, 0.45)"}}


class Header:
    """Buttons; what they do is the session's.

    Attributes
    ----------
    run, pause, step, stop, preset, share, present, help : buttons.
    root : list of what stands in the header.
    """

    def __init__(self) -> None:
        self.run = pmui.Button(
            label="Run", icon="play_arrow", color="success", variant="contained", size="medium",
            margin=(5, 4, 5, 16),
        )  # fmt: skip
        self.pause = _icon("Pause", "pause", "Pause (Space)", disabled=True)
        self.step = _icon("Step", "skip_next", "Step (.)")
        self.stop = _icon("Stop", "stop", "Stop (Esc)", True)
        self.preset = pmui.Button(
            label="default", end_icon="arrow_drop_down", variant="outlined", size="medium",
            margin=(5, 8), sx={"color": "#fff", "borderColor": "rgba(255, 255, 255, 0.5)"},
        )  # fmt: skip
        self.share = _icon("Share", "share", "Share a link")
        self.present = _icon("Presentation", "co_present", "Presentation mode (P)")
        self.help = _icon("Help", "help_outline", "Help and keys (?)")
        name = pmui.Typography(
            "tyrecontact", variant="h6", margin=(8, 8, 8, 0), stylesheets=[_WIDE],
            sx={"color": "#fff"},
        )  # fmt: skip
        gap = pn.Spacer(sizing_mode="stretch_width", height=1)
        choices = pn.Row(self.preset, margin=0, stylesheets=[_WIDE])
        others = pn.Row(
            self.share, self.present, self.help, margin=0, align="end", stylesheets=[_WIDE]
        )
        runs = [name, self.run, self.pause, self.step, self.stop]
        self.root = [pn.Row(*runs, choices, gap, others, sizing_mode="stretch_width", margin=0)]

    def for_phones(self) -> pn.Row:
        """What a phone's header has no room for, to stand in its sidebar."""
        small = {"size": "small", "variant": "outlined", "margin": (8, 4)}
        below = []
        for label, button in (
            ("Presets", self.preset), ("Share", self.share), ("Help", self.help)
        ):  # fmt: skip
            copy = pmui.Button(label=label, **small)
            copy.on_click(partial(_press, button))
            below.append(copy)
        return pn.Row(*below, margin=(0, 6))

    def update(self, run: Run | None) -> None:
        """Show what can be done with the run on show."""
        under_way = run is not None and not run.phase.ended
        paused = run is not None and run.paused
        _set(self.stop, disabled=not under_way)
        # while it is compared, all steps are there: there is nothing to pause
        steps = under_way and run is not None and run.phase is not Phase.COMPARING
        _set(self.pause, disabled=not steps)
        _set(self.pause, icon="play_arrow" if paused else "pause")
        _set(self.pause, description="Go on (Space)" if paused else "Pause (Space)")


def _press(button: Any, _: Any) -> None:
    button.param.trigger("clicks")


def _icon(label: str, icon: str, description: str, disabled: bool = False) -> pmui.IconButton:
    return pmui.IconButton(
        label=label, icon=icon, description=description, disabled=disabled, sx=_WHITE,
        margin=(5, 2), size="medium",
    )  # fmt: skip


def _set(component: Any, **values: Any) -> None:
    """Only what changes is sent."""
    changed = {name: value for name, value in values.items() if getattr(component, name) != value}
    if changed:
        component.param.update(**changed)
