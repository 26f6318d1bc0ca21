"""The preset gallery: what there is to try, each with a picture, a caption and its source."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import param
from panel.custom import JSComponent

from tyrecontact import figures, presets

from ..thumbnails import picture

_STYLE = Path(__file__).with_suffix(".css").read_text(encoding="utf-8")


class Cards(JSComponent):
    """Cards of buttons in groups, with a search."""

    groups = param.List(doc="Groups: title, and presets with name, caption, source, ...")
    current = param.String(doc="Name of the preset that is marked")
    value = param.String(doc="Name of the preset just chosen; empty again when that was heard")

    _esm = Path(__file__).with_suffix(".js")
    _stylesheets: ClassVar[list[str]] = [_STYLE]


class Gallery:
    """What the preset picker's dialog shows.

    Parameters
    ----------
    choose : called with the name of each preset that is chosen, the current one included.

    Attributes
    ----------
    root : the cards; none of them, and no picture, before `show`.
    """

    def __init__(self, choose: Callable[[str], None]) -> None:
        self._choose = choose
        self.root = Cards(sizing_mode="stretch_width", margin=0)
        self.root.param.watch(self._chosen, "value")

    def show(self, current: str) -> None:
        """Fill the dialog as it opens, and mark the preset of the form (empty: none)."""
        self.root.param.update(groups=self.root.groups or groups(), current=current)

    def _chosen(self, event: Any) -> None:
        if event.new:
            self.root.value = ""  # so that the same one can be chosen again
            self.root.current = event.new
            self._choose(event.new)


def groups() -> list[dict[str, Any]]:
    """What the gallery shows: one group to start with, and one of the thesis' figures."""
    of_the_thesis = [name for name in presets.names() if name not in presets.PRESETS]
    return [
        {"title": "Start here", "presets": [_card(name) for name in presets.PRESETS]},
        {"title": "Thesis figures", "presets": [_card(name) for name in of_the_thesis]},
    ]


def _card(name: str) -> dict[str, Any]:
    family = figures.find(name).members if name in figures.FIGURES else {}
    return {
        "name": name,
        "caption": presets.caption(name),
        "source": presets.source(name),
        "picture": picture(name),
        "members": [{"label": label, "name": member} for label, member in family.items()],
    }
