"""What the lines of the live plots are: beside the plots, once for all of them.

Not Bokeh's own legend, which is made anew, with the layout of its plot, whenever a row is streamed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import panel as pn

from .style import DESK, GREY, MARGIN_COLOR, RUN_COLOR, VERMILION, Size

_STYLE = """
/* room for two lines from the first: a step that fails moves no plot */
ul { display: flex; flex-wrap: wrap; align-content: center; gap: 2px 18px;
     min-height: calc(40px * var(--scale, 1)); margin: 0; padding: 0; list-style: none; }
@media (max-width: 600px) { :host { flex-basis: 100% !important; } }
li { display: flex; align-items: center; gap: 6px; white-space: nowrap; }
"""


@dataclass(frozen=True)
class Entry:
    """A line of a plot: its label, colour, width [px] and dashes as SVG has them; or a cross."""

    label: str
    color: str
    width: float = 2.0
    dash: str = ""
    cross: bool = False

    def html(self) -> str:
        if self.cross:
            path = f'<path d="M9 1l8 8M17 1l-8 8" stroke="{self.color}" stroke-width="2"/>'
        else:
            path = (
                f'<path d="M0 5h26" stroke="{self.color}" stroke-width="{self.width:g}" '
                f'stroke-dasharray="{self.dash}"/>'
            )
        icon = f'<svg width="26" height="10" aria-hidden="true">{path}</svg>'
        return f"<li>{icon}{escape(self.label)}</li>"


class LegendView:
    """Attributes: `root` a pane; `entries` what it shows."""

    def __init__(self) -> None:
        self.entries: list[Entry] = []
        self._pinned: tuple[Entry, ...] = ()
        self._dark, self._failed, self._size = False, False, DESK
        self.root = pn.pane.HTML(
            "", stylesheets=[_STYLE], sizing_mode="stretch_width", margin=(1, 10)
        )
        self._draw()

    def show_failed(self, failed: bool) -> None:
        """Whether there are steps that did not converge."""
        if failed != self._failed:
            self._failed = failed
            self._draw()

    def show_pinned(self, pinned: Sequence[Entry]) -> None:
        """Lines of pinned runs."""
        if tuple(pinned) != self._pinned:
            self._pinned = tuple(pinned)
            self._draw()

    def darken(self, dark: bool) -> None:
        self._dark = dark
        self._draw()

    def enlarge(self, size: Size) -> None:
        self._size = size
        self._draw()

    def _draw(self) -> None:
        failed = [Entry("not converged", VERMILION, cross=True)] if self._failed else []
        self.entries = [
            Entry("this run", RUN_COLOR[self._dark]),
            Entry("quasi-static", GREY, 5.0),
            Entry("stability margin", MARGIN_COLOR, 2.0, "6 3"),
            *failed,
            *self._pinned,
        ]
        items = "".join(entry.html() for entry in self.entries)
        self.root.object = f'<ul style="font-size: {self._size.label}px">{items}</ul>'
