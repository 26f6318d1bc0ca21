"""How road and tread let go of each other: bond by bond, or in avalanches."""

from __future__ import annotations

from collections.abc import Mapping
from weakref import ref

import holoviews as hv
import numpy as np

from tyrecontact import key_figures
from tyrecontact.contact.bonds import ElementState

from ..runner import Run
from .headline import three_digits
from .lines import RUN, Line, dimensions, framed, lines, tips
from .style import ORANGE, VERMILION
from .tab import Reading, Seen, TabView

#: maps that are looked into for a curve
_MAPS = 300
#: an event that breaks this share of the bonds, or more of them, is called an avalanche
_AVALANCHE = 0.2
#: of fewer bonds nothing of the kind is said
_JUDGED = 20
_TIME = "Time [ms]"
_HOW = (
    'choose the preset "adhesion", or a release criterion above 0 N and a profile that unloads '
    "and retracts"
)


class ReleaseView(TabView):
    """Attributes: `root` to look at; `reading` what is shown."""

    def __init__(self) -> None:
        super().__init__()
        self._about: ref[Run] | None = None
        self._pulled: dict[int, int] = {}

    @property
    def promise(self) -> str:
        return (
            "Here will be seen how the contacts break when the road is pulled off. To see any, "
            f"{_HOW}; then press Run."
        )

    def read(self, seen: Seen) -> Reading:
        if not seen.columns["contacts"].any():
            return Reading("Road and tread have not met yet: there is nothing to release.")
        plots = {"contacts": _contacts(seen, self._in_tension(seen.run, seen.columns))}
        if not seen.columns["releases"].any():
            return Reading(_no_release(seen), plots=plots)
        sizes = key_figures.avalanches(seen.columns)
        plots.update(steps=_steps(seen.columns), sizes=_sizes(sizes), force=_by_force(seen.columns))
        return Reading(_sentence(seen, sizes), False, _figures(seen, sizes), plots)

    def _in_tension(self, run: Run, columns: Mapping[str, np.ndarray]) -> dict[int, int]:
        """Step -> number of elements that are pulled, of some steps; each is counted once."""
        if self._about is None or run is not self._about():
            self._about, self._pulled = ref(run), {}
        assert run.record is not None
        count = len(columns["time"])
        stride = max(1, count // _MAPS)
        stride = 1 << (stride - 1).bit_length()  # so that later maps are among the earlier ones
        for step in [*range(0, count, stride), count - 1]:
            if step not in self._pulled:
                number, maps = run.record.fields(step)
                self._pulled[step] = int(np.count_nonzero(maps["state"] == ElementState.TENSION))
                if number != step:
                    self._pulled[number] = self._pulled.pop(step)
        return {step: self._pulled[step] for step in sorted(self._pulled) if step < count}


def _contacts(seen: Seen, pulled: Mapping[int, int]) -> hv.Overlay:
    columns = seen.columns
    time, steps = columns["time"] * 1e3, np.array(list(pulled))
    parts = [
        Line("in contact", time, columns["contacts"].astype(float), RUN),
        Line("of them pulled", time[steps], np.array(list(pulled.values()), float), ORANGE,
             "dashed"),
    ]  # fmt: skip
    if columns["releases"].any():
        broken = np.cumsum(columns["releases"]).astype(float)
        parts.append(Line("broken so far", time, broken, VERMILION, "dotdash"))
    return lines("Elements in contact", _TIME, "Elements", parts)


def _steps(columns: Mapping[str, np.ndarray]) -> hv.Overlay:
    label, time = "Bonds broken", columns["time"] * 1e3
    broke = np.flatnonzero(columns["releases"])
    x, y = dimensions(_TIME, label)
    points = (time[broke], columns["releases"][broke])
    stems = hv.Spikes(points, x, y).opts(color=RUN, line_width=1.5, framewise=True)
    heads = hv.Scatter(points, x, y).opts(
        color=RUN, size=5, tools=["hover"], hover_tooltips=tips("", _TIME, label), framewise=True
    )
    across = (float(time[0]), float(time[-1]))
    return framed(hv.Overlay([stems, heads]), "Bonds broken in each step", None, False, across)


def _sizes(sizes: np.ndarray) -> hv.Overlay:
    x, y = dimensions("Bonds in the event", "Events")
    events = np.bincount(sizes)[1:]
    bars = hv.Histogram((np.arange(events.size + 1) + 0.5, events), kdims=[x], vdims=[y]).opts(
        fill_color=RUN, fill_alpha=0.75, line_color=RUN, tools=["hover"],
        hover_tooltips=tips("", "Bonds in the event", "Events"), framewise=True,
    )  # fmt: skip
    title = "Sizes of events: releases within 1 % of the drive's way"
    return framed(hv.Overlay([bars]), title, legend=False)


def _by_force(columns: Mapping[str, np.ndarray]) -> hv.Overlay:
    """What still holds against the force, from the last moment before the first bond broke."""
    first = max(int(np.flatnonzero(columns["releases"])[0]) - 1, 0)
    first = max(first, key_figures.turn(columns) or 0)
    left = columns["contacts"][first:].astype(float)
    force = columns["contact_force"][first:]
    part = Line("in contact", force, left, RUN)
    title = "Elements in contact against force, pulling off"
    return lines(title, "Force [N]", "Elements", [part], legend=False)


def _no_release(seen: Seen) -> str:
    loading, adhesion = seen.run.scenario.loading, seen.run.scenario.adhesion
    none = "No bond has broken"
    if adhesion.law in ("release-force", "multiplicative") and adhesion.release_force == 0:
        return f"{none}: the release criterion of 0 N is no adhesion. To see some break, {_HOW}."
    if loading.profile in ("linear", "quadratic"):
        return f"{none}, as this loading only presses. To see some break, {_HOW}."
    if seen.ended:
        return f"{none}: the road was not pulled far enough. To see some break, {_HOW}."
    return f"{none} so far; they may, once the road is pulled back."


def _sentence(seen: Seen, sizes: np.ndarray) -> str:
    columns = seen.columns
    broken, largest = int(columns["releases"].sum()), int(sizes.max())
    text = f"{broken} bonds have broken in {sizes.size} events. "
    if sizes.size == 1:
        text = f"{broken} bonds have broken, all in one event. "
    share = largest / broken
    if broken >= _JUDGED and sizes.size > 1:
        kind = "an avalanche" if share >= _AVALANCHE else "no avalanche: they let go bit by bit"
        text += f"The largest took {largest} of them ({three_digits(100 * share)} %), {kind}. "
    pull = -float(columns["contact_force"].min())
    adherence = key_figures.adherence_force(columns) if seen.failed_at is None else None
    if adherence is not None:
        text += f"Road and tread are apart; it took a pull of {three_digits(adherence)} N."
    elif pull > 0:
        end = "the run ended" if seen.ended else "so far"
        text += f"The hardest pull {'before ' * seen.ended}{end} was {three_digits(pull)} N."
    return text.strip()


def _figures(seen: Seen, sizes: np.ndarray) -> dict[str, str]:
    columns = seen.columns
    found = {
        "Bonds broken": str(int(columns["releases"].sum())),
        "Events": str(sizes.size),
        "Largest event": f"{int(sizes.max())} bonds",
        "Most in one step": f"{int(columns['releases'].max())} bonds",
    }
    adherence = key_figures.adherence_force(columns) if seen.failed_at is None else None
    if adherence is not None:
        found["Adherence force"] = f"{three_digits(adherence)} N"
    return found
