"""Several runs in one plot at rest, for reports: curves of a family against each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from bokeh.models import ColumnDataSource, HoverTool, Range1d
from bokeh.plotting import figure

from .style import BLUE, GREY, ORANGE, VERMILION, plot
from .trace import extremes

#: Okabe and Ito's, in the order in which they tell lines apart best
COLORS = (BLUE, VERMILION, "#009E73", ORANGE, "#CC79A7", "#56B4E9")
#: points of a curve; more than a screen is wide would be hidden behind each other
_POINTS = 900
_HEIGHT = 290


@dataclass(frozen=True)
class Style:
    """How a run is drawn in all plots of its family."""

    color: str
    width: float = 1.8
    alpha: float = 1.0


#: what the others are compared with lies wide and grey behind them
BEHIND = Style(GREY, 5.0, 0.5)


@dataclass(frozen=True)
class Curve:
    """One line: x, y in the units of the axes."""

    label: str
    x: np.ndarray
    y: np.ndarray
    style: Style


@dataclass(frozen=True)
class Panel:
    """One plot of a family.

    Attributes
    ----------
    curves : what is drawn, the first one at the back.
    x_range, y_range : shown; all of the curves where None.
    steps : whether values are counts, drawn as stairs.
    """

    title: str
    x_label: str
    y_label: str
    curves: Sequence[Curve]
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None
    steps: bool = field(default=False)


def styles(labels: Sequence[str], behind: str | None = None) -> dict[str, Style]:
    """A style for each run of a family; the one `behind` the others is what they compare with."""
    found, colors = {}, iter(COLORS * (1 + len(labels) // len(COLORS)))
    for label in labels:
        found[label] = BEHIND if label == behind else Style(next(colors))
    return found


def draw(panel: Panel) -> figure:
    """The plot, in the house style, without a legend: the family has one for all its plots."""
    fig = plot(panel.title, panel.y_label, _HEIGHT, 1.0)
    fig.update(min_border_left=58, min_border_right=14)
    fig.xaxis.axis_label = panel.x_label
    fig.x_range = Range1d(*(panel.x_range or _span([curve.x for curve in panel.curves], 0.0)))
    fig.y_range = Range1d(*(panel.y_range or _span([curve.y for curve in panel.curves], 0.05)))
    fig.title.text_font_size = "13px"
    fig.axis.axis_label_text_font_size = "12px"
    fig.axis.major_label_text_font_size = "11px"
    fig.yaxis.ticker.desired_num_ticks = 6
    fig.xaxis.ticker.desired_num_ticks = 5
    for curve in panel.curves:
        _draw_line(fig, curve, panel.steps)
    tips = [("", "@label"), (panel.y_label, "@y{0.[000]}"), (panel.x_label, "@x{0.[000]}")]
    fig.add_tools(HoverTool(tooltips=tips, mode="mouse"))
    return fig


def _draw_line(fig: figure, curve: Curve, steps: bool) -> None:
    x, y = thinned(curve.x, curve.y)
    label = [curve.label] * x.size
    source = ColumnDataSource(
        {"x": x.astype(np.float32), "y": y.astype(np.float32), "label": label}
    )
    kwargs = {"mode": "center"} if steps else {}
    (fig.step if steps else fig.line)(
        "x", "y", source=source, line_color=curve.style.color, line_width=curve.style.width,
        line_alpha=curve.style.alpha, **kwargs,
    )  # fmt: skip


def thinned(x: np.ndarray, y: np.ndarray, points: int = _POINTS) -> tuple[np.ndarray, np.ndarray]:
    """At most about `points` of a curve, the least and the largest of each stretch among them."""
    if x.size <= points:
        return x, y
    kept = extremes(y, -(-2 * x.size // points))
    chosen = np.union1d(kept, [0, x.size - 1])
    return x[chosen], y[chosen]


def _span(values: Sequence[np.ndarray], margin: float) -> tuple[float, float]:
    """From the least to the largest of all that is finite, and a share more."""
    finite = np.concatenate([part[np.isfinite(part)] for part in values] or [np.zeros(1)])
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 1.0)
    room = margin * (high - low) or (0.0 if high > low else 1.0)
    return low - room, high + room
