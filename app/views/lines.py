"""Lines in one plot at rest: what they are, and how HoloViews draws them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import holoviews as hv
import numpy as np

from .comparison import thinned
from .style import GREY

#: line of a run: readable on white and on black
RUN = "#2F8FD0"
Window = tuple[float, float] | None
#: a run that goes wild is shown in so much more than a run that goes well takes
_ROOM = 0.25


@dataclass(frozen=True)
class Line:
    """One line: x, y in the units of the axes."""

    label: str
    x: np.ndarray
    y: np.ndarray
    color: str
    dash: str = "solid"
    width: float = 2.0
    alpha: float = 1.0


def behind(label: str, x: np.ndarray, y: np.ndarray, dash: str = "solid") -> Line:
    """What a run is compared with lies wide and grey behind it."""
    return Line(label, x, y, GREY, dash, 5.0, 0.5)


def lines(
    title: str,
    x_label: str,
    y_label: str,
    parts: Sequence[Line],
    window: Window = None,
    legend: bool = True,
) -> hv.Overlay:
    """A plot of lines, the first one at the back.

    Parameters
    ----------
    x_label, y_label : with the unit in brackets: "Force [N]".
    window : of the vertical axis; None for all of the lines.
    """
    drawn = [_curve(part, x_label, y_label) for part in parts]
    return framed(hv.Overlay(drawn), title, window, legend)


def framed(
    overlay: hv.Overlay,
    title: str,
    window: Window = None,
    legend: bool = True,
    across: Window = None,
) -> hv.Overlay:
    """An overlay with its title, its legend above, and ranges that follow the data.

    `window` and `across` are those of the vertical and of the horizontal axis.
    """
    plain = title.replace("{", "{{").replace("}", "}}")  # HoloViews fills in what is in braces
    return overlay.opts(
        title=plain, framewise=True, show_grid=True, legend_position="top", legend_cols=3,
        show_legend=legend, ylim=window or (None, None),
        xlim=across or (None, None), padding=(0, 0.05), backend="bokeh",
    )  # fmt: skip


def tips(label: str, x_label: str, y_label: str) -> list[tuple[str, str]]:
    """Values at the pointer, each with its unit."""
    named = [_told(y_label, "y"), _told(x_label, "x")]
    return [("", label), *named] if label else named


def _told(axis: str, column: str) -> tuple[str, str]:
    name, _, unit = axis.partition(" [")
    return name.lower(), f"@{column}{{0.[000]}} {unit.rstrip(']')}".rstrip()


def dimensions(x_label: str, y_label: str) -> tuple[hv.Dimension, hv.Dimension]:
    return hv.Dimension("x", label=x_label), hv.Dimension("y", label=y_label)


def _curve(part: Line, x_label: str, y_label: str) -> hv.Curve:
    x, y = dimensions(x_label, y_label)
    curve = hv.Curve(thinned(part.x, part.y), x, y, label=part.label)
    return curve.opts(
        color=part.color, line_dash=part.dash, line_width=part.width, line_alpha=part.alpha,
        tools=["hover"], hover_tooltips=tips(part.label, x_label, y_label), framewise=True,
        backend="bokeh",
    )  # fmt: skip


def window(shown: Sequence[np.ndarray], usual: Sequence[np.ndarray]) -> Window:
    """None where what is `shown` needs less than three times the room of what is `usual`.

    Otherwise somewhat more than is usual: nothing could be read off at the scale of a run that
    has gone wild.
    """
    low, high = _span(usual)
    least, most = _span(shown)
    room = high - low
    if room == 0 or (least >= low - room and most <= high + room):
        return None
    return low - _ROOM * room, high + _ROOM * room


def _span(parts: Sequence[np.ndarray]) -> tuple[float, float]:
    """From the least to the largest number of all, 0 among them."""
    known = [part[np.isfinite(part)] for part in parts]
    values = np.concatenate([*known, np.zeros(1)])
    return float(values.min()), float(values.max())
