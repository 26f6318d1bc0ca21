"""Choose an element without a pointer: its row and column, or the one that stands out."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

import panel_material_ui as pmui
import param
from panel.custom import JSComponent

_STYLE = """
label { display: flex; align-items: center; gap: 6px;
  font-size: calc(14px * var(--scale, 1)); }
input { width: calc(64px * var(--scale, 1)); height: calc(30px * var(--scale, 1));
  box-sizing: border-box; padding: 0 6px; font: inherit;
  color: inherit; background: none; border-radius: 6px;
  border: 1px solid color-mix(in srgb, currentColor 50%, transparent); }
:focus-visible { outline: 2px solid #3A8FC2; outline-offset: 2px; }
"""

#: rows and columns that can be asked for before it is known how many there are
MOST = 9999


class WholeNumber(JSComponent):
    """A number from zero on; the library's has buttons without names, and hears Enter once."""

    label = param.String(default="")
    value = param.Integer(default=0)
    end = param.Integer(default=MOST, doc="The largest that can be chosen")

    _esm = Path(__file__).with_suffix(".js")
    _stylesheets: ClassVar[list[str]] = [_STYLE]


class ElementChooser:
    """Attributes: `root` a row of widgets; `chosen` and `wanted` are called with what is asked."""

    def __init__(self, chosen: Callable[[int, int], None], wanted: Callable[[str], None]) -> None:
        self._chosen, self._silent = chosen, False
        self.row, self.column = (
            WholeNumber(label=label, margin=(10, 8)) for label in ("Row", "Column")
        )
        self.buttons = [
            pmui.Button(label=label, variant="outlined", size="small", margin=(10, 4))
            for label in ("Hardest pressed", "In tension")
        ]
        for number in (self.row, self.column):
            number.param.watch(self._changed, "value")
        for button in self.buttons:
            button.on_click(partial(self._press, wanted))
        self.root = pmui.FlexBox(self.row, self.column, *self.buttons, flex_wrap="wrap")

    @staticmethod
    def _press(wanted: Callable[[str], None], event: Any) -> None:
        wanted(event.obj.label)

    def bound(self, elements: int) -> None:
        """So many elements a side can be chosen among."""
        self._silent = True
        for number in (self.row, self.column):
            number.param.update(end=elements - 1, value=min(number.value, elements - 1))
        self._silent = False

    def show(self, row: int, column: int) -> None:
        """Show what was chosen elsewhere."""
        self._silent = True
        self.row.value, self.column.value = row, column
        self._silent = False

    def _changed(self, _event: Any) -> None:
        row, column = self.row.value, self.column.value
        if not self._silent and 0 <= row <= self.row.end and 0 <= column <= self.column.end:
            self._chosen(row, column)
