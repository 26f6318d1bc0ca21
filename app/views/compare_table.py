"""Tables of runs side by side, and the key to their lines, as HTML."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from ..compared import Row
from ..pinned import Look, Pinned
from .style import Size

#: dash of Bokeh -> lengths of strokes and gaps in the sample of a line [px]
_DASHES = {"solid": "", "dashed": "7 4", "dotted": "2 4", "dotdash": "2 4 7 4"}

STYLE = """
:host, :host > div { display: block; width: 100%; min-width: 0; }
.pair { display: flex; flex-wrap: wrap; gap: 0 32px; align-items: flex-start; }
.pair > .scroll { flex: 1 1 var(--room); }
.scroll { overflow-x: auto; contain: inline-size; margin: 0 0 10px; }
.scroll:focus-visible { outline: 2px solid currentColor; }
table { border-collapse: collapse; }
caption { text-align: left; font-weight: 600; padding: 4px 0; }
th, td { padding: 4px 14px 4px 0; text-align: left; vertical-align: top; font-weight: 400;
         border-bottom: 1px solid color-mix(in srgb, currentColor 22%, transparent); }
thead th { font-weight: 600; }
tbody th { min-width: 9em; }
td { white-space: nowrap; font-variant-numeric: tabular-nums; }
svg { vertical-align: middle; margin-right: 6px; }
.key { display: flex; flex-wrap: wrap; gap: 2px 22px; padding: 4px 0; }
.note { margin: 2px 0; line-height: 1.45; max-width: 110ch; }
"""


def table(caption: str, runs: Sequence[Pinned], rows: Sequence[Row], size: Size) -> str:
    """A table with a column for each run; it scrolls sideways in itself where it is too wide."""
    heads = "".join(f'<th scope="col">{_sample(run.look)}{escape(run.label)}</th>' for run in runs)
    body = "".join(f'<tr><th scope="row">{escape(row.name)}</th>{_cells(row)}</tr>' for row in rows)
    return (
        f'<div class="scroll" role="region" aria-label="{escape(caption)}" tabindex="0" '
        f'style="font-size:{size.label}px"><table><caption>{escape(caption)}</caption>'
        f"<thead><tr><td></td>{heads}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def beside(tables: Sequence[str], runs: int) -> str:
    """Tables of so many runs beside each other, where there is room for them."""
    room = f"min(100%, {14 + 9 * runs}em)"
    return f'<div class="pair" style="--room: {room}">{"".join(tables)}</div>'


def key(runs: Sequence[Pinned], size: Size) -> str:
    """Which line is which run, for all plots."""
    found = "".join(f"<span>{_sample(run.look)}{escape(run.label)}</span>" for run in runs)
    return f'<div class="key" style="font-size:{size.label}px">{found}</div>'


def sentences(said: Sequence[str], size: Size) -> str:
    """One paragraph for each."""
    found = "".join(f'<p class="note">{escape(text)}</p>' for text in said)
    return f'<div style="font-size:{size.title}px">{found}</div>'


def _sample(look: Look) -> str:
    return (
        '<svg width="34" height="10" aria-hidden="true"><line x1="1" y1="5" x2="33" y2="5" '
        f'stroke="{look.color}" stroke-width="2.5" stroke-dasharray="{_DASHES[look.dash]}"/></svg>'
    )


def _cells(row: Row) -> str:
    return "".join(f"<td>{escape(value)}</td>" for value in row.values)
