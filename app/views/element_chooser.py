"""Choose an element without a pointer: its row and column, or the one that stands out."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import panel_material_ui as pmui


class ElementChooser:
    """Attributes: `root` a row of widgets; `chosen` and `wanted` are called with what is asked."""

    def __init__(self, chosen: Callable[[int, int], None], wanted: Callable[[str], None]) -> None:
        self._chosen, self._silent = chosen, False
        self.row, self.column = (
            pmui.IntInput(label=label, value=0, start=0, width=96, size="small", margin=(6, 4))
            for label in ("Row", "Column")
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
        for number in (self.row, self.column):
            number.end = elements - 1

    def show(self, row: int, column: int) -> None:
        """Show what was chosen elsewhere."""
        self._silent = True
        self.row.value, self.column.value = row, column
        self._silent = False

    def _changed(self, _event: Any) -> None:
        row, column = self.row.value, self.column.value
        if not self._silent and row is not None and column is not None:
            self._chosen(row, column)
