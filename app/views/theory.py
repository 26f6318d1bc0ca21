"""The theory page: one long text with equations, made when it is first opened."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

import param
from panel.custom import JSComponent

from ..runner import Run
from ..theory import render
from .style import DESK, Size

_STYLE = Path(__file__).with_suffix(".css").read_text(encoding="utf-8")


class Text(JSComponent):
    """HTML whose links to its own headings jump there."""

    text = param.String(doc="HTML: contents and chapters")
    type_size = param.Integer(DESK.title, doc="Of running text [px]")

    _esm = Path(__file__).with_suffix(".js")
    _stylesheets: ClassVar[list[str]] = [_STYLE]


class TheoryView:
    """Attributes: `root` the text, empty until it is first shown."""

    def __init__(self) -> None:
        self.root = Text(sizing_mode="stretch_width", margin=(4, 8))

    def show(self, run: Run | None = None, size: Size = DESK) -> None:
        """Show the text; it is the same for all runs.

        Parameters
        ----------
        size : of type, for a desk or for a hall.
        """
        del run
        self.root.param.update(text=render.page(), type_size=size.title)
