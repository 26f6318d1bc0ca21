"""What a part of the tab Inputs is made of: figures, a caption, and plots drawn one at a time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import panel as pn

from .style import DESK, HALL, Size

#: of a plot [px], for a desk and for a lecture hall
_HEIGHT, _TALL = 300, 430
#: least width of a plot [px]; where two do not fit side by side they go below each other
_WIDTH, _WIDE = 320, 560
#: largest width of a map [px]
SQUARE, _WIDEST_IN_HALL = 440, 520

STYLE = """
:host { --muted: color-mix(in srgb, currentColor 68%, transparent); }
.facts { display: grid; grid-template-columns: repeat(auto-fill, minmax(8em, 1fr)); gap: 2px 14px;
         margin: 0; }
.facts > div { min-width: 0; }
dt { font-size: 0.86em; color: var(--muted); }
dd { margin: 0 0 4px; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
p { margin: 6px 0 0; line-height: 1.45; max-width: 110ch; }
.state { font-weight: 600; }
.empty { padding: 24px 0; }
"""

_WRAP = ":host { flex-wrap: wrap; align-items: flex-start; }"


@dataclass(frozen=True)
class Sheet:
    """A part, ready to be drawn.

    Attributes
    ----------
    facts : name -> value with its unit.
    caption : what is seen, and where the thesis has it.
    plots : each makes a plot of a size of type; the work of one is little.
    """

    facts: dict[str, str]
    caption: str
    plots: Sequence[Callable[[Size], Any]]


def text(sheet: Sheet | None, state: str, size: Size) -> str:
    """Facts and caption of a sheet as HTML, below what is to be said of its state."""
    said = f'<p class="state" role="status">{escape(state)}</p>' if state else ""
    if sheet is None:
        return f'<div class="empty" style="font-size:{size.label + 1}px">{said}</div>'
    facts = "".join(
        f"<div><dt>{escape(name)}</dt><dd>{escape(value)}</dd></div>"
        for name, value in sheet.facts.items()
    )
    return (
        f'<div style="font-size:{size.label + 1}px">{said}<dl class="facts">{facts}</dl>'
        f"<p>{escape(sheet.caption)}</p></div>"
    )


def height(size: Size) -> int:
    """Of a plot [px]."""
    return _TALL if size == HALL else _HEIGHT


def width(size: Size) -> int:
    """The least of a plot [px]."""
    return _WIDE if size == HALL else _WIDTH


def beside(plot: Any, size: Size) -> Any:
    """A plot that stands beside others where there is room."""
    least = width(size)
    plot.styles = {"flex": f"1 1 {least}px", "min-width": f"min(100%, {least}px)"}
    return plot


def square(plot: Any, size: Size) -> Any:
    """A map that keeps its shape, as wide as there is room but no taller than a screen."""
    most = _WIDEST_IN_HALL if size == HALL else SQUARE
    plot.param.update(sizing_mode="scale_width", height=None, max_width=most)
    return beside(plot, DESK)


def grid() -> pn.Row:
    """Where plots stand, side by side as far as they fit.

    No FlexBox: the page's theme does not reach what is put into one later.
    """
    return pn.Row(sizing_mode="stretch_width", stylesheets=[_WRAP], margin=0)
