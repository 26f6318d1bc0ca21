"""Where the work of the drive goes: the energy account of a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

import holoviews as hv
import numpy as np

from tyrecontact import key_figures

from ..plain_words import three_digits, true_minus
from ..runner import Baseline
from .lines import RUN, Line, behind, dimensions, framed, lines
from .style import GREY, ORANGE, VERMILION
from .tab import Reading, Seen, TabView

#: term of the account -> name, colour, hatching and dash: never colour alone
TERMS = {
    "layer_work": ("tread", ORANGE, " ", "solid"),
    "spring_energy": ("springs", RUN, "/", "dashed"),
    "machine_energy": ("machine", "#CC79A7", "x", "dotdash"),
    "released_energy": ("releases", "#009E73", ".", "dotted"),
    "algorithmic_loss": ("time steps", VERMILION, "-", "dashdot"),
}
#: points of a curve
_POINTS = 500
#: a term with a smaller share of the work is not told
_TOLD = 1e-3
#: shares of the work of a run that goes well, shown of one that does not
_BELOW, _ABOVE = 0.5, 1.5
#: term of the account -> what has become of it
_GONE = {
    "layer_work": "has gone into the tread, which holds some and turns the rest into heat",
    "spring_energy": "is held by the roughness springs",
    "machine_energy": "is held by the machine",
    "released_energy": "was lost as bonds broke",
    "algorithmic_loss": "was lost to the coarseness of the time steps",
}
_PREFIXES = ("", "m", "µ", "n", "p", "f", "a")  #: no more is worth telling
_TIME = "Time [ms]"
_HIGH = " The first plot is as high as a run that goes well needs; the second shows all."


class EnergyView(TabView):
    """Attributes: `root` to look at; `reading` what is shown."""

    heights: ClassVar = {"missing": 220}

    @property
    def promise(self) -> str:
        return (
            "Here the energy account of the run will be seen: the work of the drive, and where it "
            "has gone. Press Run."
        )

    def read(self, seen: Seen) -> Reading:
        columns = seen.columns
        if not columns["drive_work"].any():
            return Reading("Road and tread have not met yet: no work has been done.")
        created = key_figures.energy_created(columns)
        usual = _work_at_rest(seen.run.baseline)
        wild = created is not None and usual > 0
        most = usual if wild else float(np.abs(columns["drive_work"]).max())
        # of a run under way what is to come, so that the unit stays
        scale, prefix = _prefix(most if seen.ended else max(usual, most))
        plots = {
            "account": _account(columns, scale, f"{prefix}J", usual if wild else None),
            "each": _each(columns),
            "missing": _missing(columns),
        }
        bad = created is not None
        told = _on_account(columns) if created is None else _on_creation(columns, created, wild)
        return Reading(told, bad, _figures(columns), plots)


def _work_at_rest(still: Baseline | None) -> float:
    """The most that the quasi-static run has taken up to a step [J]."""
    if still is None:
        return 0.0
    work = np.cumsum(still.contact_force * np.diff(still.indentation, prepend=0.0))
    return float(work.max(initial=0.0))


def _prefix(value: float) -> tuple[float, str]:
    """What makes a readable number of joules, and the prefix that says so."""
    scale = 1.0
    for prefix in _PREFIXES:
        if value * scale >= 1:
            return scale, prefix
        scale *= 1e3
    return 1.0, ""


def joules(value: float) -> str:
    """An energy [J] to three significant digits, with its unit."""
    scale, prefix = _prefix(abs(value))
    if scale == 1 and abs(value) < 1:  # beyond the last prefix: of no account
        return "0 J"
    return f"{three_digits(value * scale)} {prefix}J"


def _account(
    columns: Mapping[str, np.ndarray], scale: float, unit: str, usual: float | None
) -> hv.Overlay:
    """Where the work has gone, stacked: what is below zero downwards, so that the sum is right."""
    steps = _some(len(columns["time"]))
    time, work = columns["time"][steps] * 1e3, columns["drive_work"][steps] * scale
    terms = {name: columns[name][steps] * scale for name in _present(columns)}
    above, below = np.zeros(time.size), np.zeros(time.size)
    areas = []
    for name, values in terms.items():
        base = np.where(values < 0, below, above)
        areas.append(_area(name, time, base + values, base, unit))
        above, below = above + np.maximum(values, 0), below + np.minimum(values, 0)
    seen = None if usual is None else (-_BELOW * usual * scale, _ABOVE * usual * scale)
    return framed(
        hv.Overlay([*areas, _work(time, work, terms, unit)]), "Where the work has gone", seen
    )


def _present(columns: Mapping[str, np.ndarray]) -> list[str]:
    """Terms that take part in this run."""
    return [name for name in TERMS if columns[name].any()]


def _some(count: int) -> np.ndarray:
    """Steps of a curve, the last among them."""
    return np.unique(np.linspace(0, count - 1, min(count, _POINTS)).astype(int))


def _area(name: str, time: np.ndarray, upper: np.ndarray, lower: np.ndarray, unit: str) -> hv.Area:
    label, color, hatching, _ = TERMS[name]

    def hatch(plot: Any, _element: Any) -> None:
        plot.handles["glyph"].update(
            hatch_pattern=hatching, hatch_color=color, hatch_scale=10, hatch_alpha=0.9
        )

    x, y = dimensions(_TIME, f"Energy [{unit}]")
    return hv.Area((time, upper, lower), x, [y, hv.Dimension("y2")], label=label).opts(
        fill_color=color, fill_alpha=0.4, line_color=color, line_width=1.2, hooks=[hatch],
        framewise=True, backend="bokeh",
    )  # fmt: skip


def _work(
    time: np.ndarray, work: np.ndarray, terms: Mapping[str, np.ndarray], unit: str
) -> hv.Curve:
    """The work of the drive, on top of all; the pointer is told every term."""
    x, y = dimensions(_TIME, f"Energy [{unit}]")
    told = [("time", "@x{0.[000]} ms"), ("work done", f"@y{{0.[000]}} {unit}")]
    told += [(TERMS[name][0], f"@{name}{{0.[000]}} {unit}") for name in terms]
    curve = hv.Curve((time, work, *terms.values()), x, [y, *terms], label="work done")
    return curve.opts(
        color=GREY, line_width=3, line_dash="dashed", tools=["hover"], hover_tooltips=told,
        hover_mode="vline", framewise=True, backend="bokeh",
    )  # fmt: skip


def _each(columns: Mapping[str, np.ndarray]) -> hv.Overlay:
    """Every term by itself, in full."""
    steps = _some(len(columns["time"]))
    time, names = columns["time"][steps] * 1e3, _present(columns)
    scale, prefix = _prefix(max(float(np.abs(columns[n]).max()) for n in ("drive_work", *names)))
    parts = [behind("work done", time, columns["drive_work"][steps] * scale)]
    for name in names:
        label, color, _, dash = TERMS[name]
        parts.append(Line(label, time, columns[name][steps] * scale, color, dash))
    return lines("Each share by itself", _TIME, f"Energy [{prefix}J]", parts)


def _missing(columns: Mapping[str, np.ndarray]) -> hv.Overlay:
    share = key_figures.imbalance(columns) / np.abs(columns["drive_work"]).max()
    power = int(np.floor(np.log10(np.abs(share).max()))) if share.any() else 0
    line = Line("missing", columns["time"] * 1e3, share / 10.0**power, VERMILION, width=1.5)
    label = true_minus(f"Share [1e{power}]") if power else "Share"
    return lines("Missing from the account, of the work", _TIME, label, [line], legend=False)


def _on_creation(columns: Mapping[str, np.ndarray], step: int, wild: bool) -> str:
    """Bad news; `wild` where the first plot does not hold all of it."""
    layer = columns["layer_work"]
    deep = three_digits(columns["indentation"][step] * 1e6)
    return (
        f"From step {step + 1} at {deep} µm on the tread has given back more energy than it got, "
        f"{joules(-float(layer.min()))} more at the worst, which no tread can: stepped in time, "
        "its kernel makes energy out of nothing, and what comes after is not to be believed."
        + (_HIGH if wild else "")
    )


def _on_account(columns: Mapping[str, np.ndarray]) -> str:
    account = key_figures.energy_account(columns)
    work = account["drive_work"]
    text = f"The drive has put in {joules(work)}"
    shares = sorted(((account[name], name) for name in TERMS), reverse=True)
    told = [
        f"{joules(value)} ({three_digits(100 * value / work)} %) {_GONE[name]}"
        for value, name in shares
        if work > 0 and value >= _TOLD * work
    ]
    if told:
        text += ": " + ", ".join(told)
    return f"{text}. {_on_closing(columns)}"


def _share_missing(columns: Mapping[str, np.ndarray]) -> float:
    """The most that is missing from the account, of the most work."""
    missing = np.abs(key_figures.imbalance(columns)).max()
    return float(missing / np.abs(columns["drive_work"]).max())


def _on_closing(columns: Mapping[str, np.ndarray]) -> str:
    share = _share_missing(columns)
    if share > key_figures.ROUNDING:
        return f"{three_digits(100 * share)} % of it are missing, which is more than rounding."
    if share == 0:
        return "The account closes to the last digit."
    return f"The account closes to {true_minus(f'{share:.0e}')} of the work, which is rounding."


def _figures(columns: Mapping[str, np.ndarray]) -> dict[str, str]:
    account = key_figures.energy_account(columns)
    terms = {TERMS[n][0].capitalize(): joules(account[n]) for n in _present(columns)}
    closes = _share_missing(columns) <= key_figures.ROUNDING
    missing = "rounding" if closes else joules(account["imbalance"])
    return {"Work done": joules(account["drive_work"]), **terms, "Missing": missing}
