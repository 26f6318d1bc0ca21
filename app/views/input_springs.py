"""The roughness springs that go into a run: their curves, the exchanged ones, and their spread.

HoloViews takes 1.3 s for 400 lines that know their element, Bokeh's multi-line 10 ms.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import holoviews as hv
import numpy as np
import panel as pn
from bokeh.models import ColumnDataSource, HoverTool, Range1d
from bokeh.plotting import figure

from tyrecontact import Simulation, assembly
from tyrecontact.road.simplification import exchange_index
from tyrecontact.road.springs import Springs

from . import rest
from .headline import three_digits
from .input_sheet import Sheet, beside, height
from .style import BLUE, GREY, VERMILION, Size

#: springs that are drawn at most, and points of each
MOST, POINTS = 400, 60
#: of those that are drawn apart
_MOST_APART = 64
#: compression up to which springs are drawn [m]
_SHOWN = 50e-6
#: share of the shown compression from which on the vertical axis holds all springs
_FROM = 0.1
#: readable on white and on black
_APART = "#009E73"
_USED = {"mean": "the mean spring, used", "standard": "standard springs, used",
         "linear": "linear springs, used"}  # fmt: skip
_CAPTION = (
    "Force and stiffness of each element's small-scale roughness against how far it is "
    "compressed, on a logarithmic axis since springs differ by orders of magnitude; "
)


@dataclass(frozen=True)
class SpringsInput:
    """What is drawn of springs; rows of the curves are springs, columns compressions.

    Attributes
    ----------
    compression [µm] : shape (points,), above 0.
    force [N], stiffness [kN/m] : shape (springs, points), as they were read off the road.
    element : (row, column) of each of those. exchanged : which of them are used no more.
    apart : what is drawn apart, (force, stiffness) as above, and `apart_label` its name.
    ranked : stiffness [kN/m] of all springs at the compression `at` [µm] at which they are ranked,
    swapped : which of those are exchanged.
    """

    compression: np.ndarray
    force: np.ndarray
    stiffness: np.ndarray
    element: np.ndarray
    exchanged: np.ndarray
    apart: tuple[np.ndarray, np.ndarray]
    apart_label: str
    ranked: np.ndarray
    swapped: np.ndarray
    at: float

    @classmethod
    def of(cls, simulation: Simulation) -> SpringsInput:
        """Raises InputError for a road that has no springs; takes up to a second."""
        settings, elements = simulation.scenario.springs, simulation.scenario.road.elements
        read, at = _as_read(simulation), settings.exchange_compression
        index = exchange_index(read, settings.exchange_count, at, settings.exchange_ranking)
        swapped = index != np.arange(read.count)
        here = np.full(read.count, at)
        order = np.argsort(read.force(here), kind="stable")
        chosen = _spread(order, MOST)
        depth = min(_SHOWN, read.depth) * (np.arange(1, POINTS + 1) / POINTS) ** 2
        force, stiffness = _curves(read, chosen, depth)
        simplified = settings.simplification != "none"
        apart = _spread(order, _MOST_APART) if simplified else order[[read.count // 2]]
        return cls(
            compression=depth * 1e6,
            force=force,
            stiffness=stiffness,
            element=np.stack(np.divmod(chosen, elements), axis=-1),
            exchanged=swapped[chosen],
            apart=_curves(simulation.springs if simplified else read, apart, depth),
            apart_label=_USED.get(settings.simplification, "the median spring"),
            ranked=read.stiffness(here) / 1e3,
            swapped=swapped,
            at=at * 1e6,
        )

    @property
    def facts(self) -> dict[str, str]:
        """Name -> value with unit."""
        median, low, high = (
            _stiffness(float(np.quantile(self.ranked, share))) for share in (0.5, 0, 1)
        )
        count, exchanged = self.ranked.size, int(self.swapped.sum())
        at = f"{three_digits(self.at)} µm"
        drawn = "" if len(self.force) == count else f", {len(self.force)} drawn"
        return {
            "Springs": f"{count}{drawn}",
            "Exchanged for softer ones": f"{exchanged}, ranked at {at}" if exchanged else "none",
            f"Median stiffness at {at}": median,
            "Softest there": low,
            "Stiffest there": high,
        }

    def sheet(self) -> Sheet:
        """Facts, caption, the curves and a histogram."""
        ends = "none is exchanged in this run (thesis, chapters 3.2 and 4.2.2, Fig. 23)."
        if self.swapped.any():
            ends = (
                "the stiffest, dashed, are exchanged for the next softer ones "
                "(thesis, chapter 4.2.2, Fig. 23)."
            )
        force = partial(self._draw_curves, "Spring force", "Force [N]", self.force, self.apart[0])
        stiffness = partial(
            self._draw_curves, "Spring stiffness", "Stiffness [kN/m]", self.stiffness, self.apart[1]
        )
        return Sheet(self.facts, _CAPTION + ends, (force, stiffness, self.draw_spread))

    def _draw_curves(
        self, title: str, label: str, values: np.ndarray, apart: np.ndarray, size: Size
    ) -> Any:
        fig = _log_plot(title, label, self.compression[-1], _window(values), height(size))
        kept = self._lines(fig, values, ~self.exchanged, "as read", GREY, "solid", 0.4)
        hovered = [kept]
        if self.exchanged.any():
            name = "exchanged for softer"
            hovered.append(self._lines(fig, values, self.exchanged, name, VERMILION, "dashed", 0.8))
        lines = {"x": [self.compression] * len(apart), "y": list(apart)}
        fig.multi_line(
            "x", "y", source=ColumnDataSource(lines), color=_APART,
            line_width=2.5 * size.line, legend_label=self.apart_label,
        )  # fmt: skip
        tips = [
            ("element", "row @row, column @column"),
            ("compression", "$x{0.00} µm"),
            (label, "$y{0.0000}"),
        ]
        fig.add_tools(HoverTool(renderers=hovered, tooltips=tips))
        fig.legend.update(location="bottom_right", background_fill_alpha=0.7, padding=4, spacing=0)
        size.apply(fig)
        return beside(pn.pane.Bokeh(fig, sizing_mode="stretch_width"), size)

    def _lines(
        self, fig: figure, values: np.ndarray, which: np.ndarray, name: str,
        color: str, dash: str, alpha: float,
    ) -> Any:  # fmt: skip
        row, column = self.element[which].T
        lines = ColumnDataSource(
            {"x": [self.compression] * len(row), "y": list(values[which].astype(np.float32)),
             "row": row, "column": column}
        )  # fmt: skip
        return fig.multi_line(
            "x", "y", source=lines, color=color, line_alpha=alpha, line_dash=dash,
            hover_line_alpha=1.0, hover_line_color=BLUE, legend_label=name,
        )  # fmt: skip

    def draw_spread(self, size: Size) -> Any:
        """How many springs are how stiff where they are ranked."""
        edges = _bins(self.ranked)
        axes = f"Stiffness at {three_digits(self.at)} µm [kN/m]", "Number of springs"
        drawn = _bars(edges, self.ranked, "all", axes).opts(
            fill_color=GREY, line_color=GREY, fill_alpha=0.5
        )
        if self.swapped.any():
            exchanged = _bars(edges, self.ranked[self.swapped], "exchanged for softer", axes)
            drawn *= exchanged.opts(
                fill_color=VERMILION, line_color=VERMILION, fill_alpha=0.5, line_dash="dashed"
            )
        most = int(np.histogram(self.ranked, edges)[0].max())
        drawn = drawn.opts(logx=True, title="Spread of the springs", ylim=(0, 1.4 * most))
        return beside(rest.pane(drawn, size, height(size)), size)


def _bars(edges: np.ndarray, values: np.ndarray, name: str, axes: tuple[str, str]) -> Any:
    counts = np.histogram(values, edges)[0]
    return hv.Histogram((edges, counts), kdims=axes[0], vdims=axes[1], label=name)


def _as_read(simulation: Simulation) -> Springs:
    """Springs before any was exchanged or simplified."""
    settings = simulation.scenario.springs
    if settings.exchange_count == 0 and settings.simplification == "none":
        return simulation.springs
    plain = simulation.scenario.copy()
    plain.springs.param.update(exchange_count=0, simplification="none")
    return assembly.roughness_springs(simulation.patch, plain)


def _spread(order: np.ndarray, most: int) -> np.ndarray:
    """At most so many of a ranking, equally far apart in it."""
    return order[np.unique(np.linspace(0, order.size - 1, min(most, order.size)).astype(int))]


def _curves(
    springs: Springs, chosen: np.ndarray, depth: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Force [N] and stiffness [kN/m] of chosen springs, shape (springs, points)."""
    some = springs.take(chosen)
    at = np.repeat(depth[:, None], chosen.size, axis=1)
    return some.force(at).T, some.stiffness(at).T / 1e3


def _window(values: np.ndarray) -> tuple[float, float]:
    """Of the vertical axis: from the softest spring, pressed a little, to the stiffest."""
    low = float(values[:, int(_FROM * POINTS)].min())
    return max(low, 1e-9), max(2 * float(values.max()), 1e-8)


def _bins(values: np.ndarray) -> np.ndarray:
    """Edges of equal ratio around positive values."""
    low, high = float(values.min()) * 0.95, float(values.max()) * 1.05
    return np.geomspace(max(low, 1e-9), max(high, 2e-9), 41)


def _log_plot(
    title: str, label: str, reach: float, window: tuple[float, float], tall: int
) -> figure:
    """A quiet figure with a logarithmic vertical axis."""
    fig = figure(
        title=title, x_axis_label="Compression [µm]", y_axis_label=label,
        x_range=Range1d(start=0, end=reach),
        y_range=Range1d(start=window[0], end=window[1]), y_axis_type="log", height=tall,
        sizing_mode="stretch_width", output_backend="canvas",
        tools="pan,box_zoom,reset,save", active_drag=None, toolbar_location="above",
        min_border_left=64, min_border_right=16,
    )  # fmt: skip
    fig.toolbar.update(logo=None, autohide=True)
    fig.axis.axis_label_text_font_style = "normal"
    return fig


def _stiffness(value: float) -> str:
    """A stiffness [kN/m] in the unit that fits."""
    return f"{three_digits(value)} kN/m" if value < 1e3 else f"{three_digits(value / 1e3)} MN/m"
