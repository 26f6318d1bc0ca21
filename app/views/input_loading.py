"""The loading that goes into a run: what drives the road in each step, and how fast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import holoviews as hv
import numpy as np

from tyrecontact import Simulation

from . import rest
from .comparison import thinned
from .headline import three_digits
from .input_sheet import Sheet, beside, height
from .style import BLUE, ORANGE, Size

#: a loading that takes longer [s] is drawn in seconds
_LONG = 1.0
#: up to so many steps each is marked
_MARKED_UP_TO = 150
#: drive -> what it is, its unit and factor, the unit of its rate and factor
_DRIVES = {
    "rigid": ("Indentation", "µm", 1e6, "mm/s", 1e3),
    "machine": ("Far end of the machine's spring", "µm", 1e6, "mm/s", 1e3),
    "force": ("Force on the mass", "N", 1.0, "N/ms", 1e-3),
}
_CAPTION = {
    "rigid": "How deep the road is pressed into the tread, step by step, and how fast; below zero "
    "it is above first contact (thesis, chapters 4.3 and 5.1, Figs. 30, 35 and 49).",
    "machine": "Where the far end of the machine's spring is, step by step, and how fast it moves; "
    "the road follows it (the thesis prescribes the indentation itself, chapter 4.3).",
    "force": "The force that presses the road, step by step, and how fast it changes; the road "
    "goes where forces are in balance (the thesis prescribes the indentation, chapter 4.3).",
}


@dataclass(frozen=True)
class LoadingInput:
    """All steps of a run.

    Attributes
    ----------
    time [s], drive [m or N] : shape (steps,). at_rest : steps at whose end the tread is at rest.
    time_step : [s]. kind : "rigid", "machine" or "force". profile : its name.
    """

    time: np.ndarray
    drive: np.ndarray
    at_rest: np.ndarray
    time_step: float
    kind: str
    profile: str

    @classmethod
    def of(cls, simulation: Simulation) -> LoadingInput:
        schedule, loading = simulation.schedule, simulation.scenario.loading
        return cls(
            time=schedule.time,
            drive=schedule.drive,
            at_rest=schedule.at_rest,
            time_step=simulation.time_step,
            kind=loading.drive,
            profile=loading.profile,
        )

    @property
    def rate(self) -> np.ndarray:
        """Mean rate of each step but the first [m/s or N/s]."""
        change: np.ndarray = np.diff(self.drive) / np.diff(self.time)
        return change

    @property
    def facts(self) -> dict[str, str]:
        """Name -> value with unit."""
        _, unit, factor, rate_unit, rate_factor = _DRIVES[self.kind]
        rate = self.rate * rate_factor
        facts = {
            "Profile": self.profile,
            "Steps": str(self.time.size),
            "Time step": f"{three_digits(self.time_step * 1e6)} µs",
            "Duration": self._told(float(self.time[-1])),
            "Largest": f"{three_digits(float(self.drive.max()) * factor)} {unit}",
            "Fastest loading": f"{three_digits(float(rate.max()))} {rate_unit}",
        }
        if rate.min() < 0:
            facts["Fastest unloading"] = f"{three_digits(-float(rate.min()))} {rate_unit}"
        if self.at_rest.any():
            facts["Steps of a long hold, at rest"] = str(int(self.at_rest.sum()))
        return facts

    def sheet(self) -> Sheet:
        """Facts, caption, drive and rate."""
        return Sheet(self.facts, _CAPTION[self.kind], (self.draw_drive, self.draw_rate))

    def draw_drive(self, size: Size) -> Any:
        """The drive against time; each step is marked where there are few."""
        what, unit, factor, *_ = _DRIVES[self.kind]
        time, label = self._axis, f"{what} [{unit}]"
        x, y = thinned(self._shown_time, self.drive * factor)
        drawn = hv.Curve((x, y), time, label).opts(color=BLUE, line_width=1.8)
        if self.time.size <= _MARKED_UP_TO:
            drawn *= hv.Scatter((x, y), time, label).opts(color=BLUE, size=4)
        if self.at_rest.any():
            at = self.at_rest
            held = (self._shown_time[at], self.drive[at] * factor)
            drawn *= hv.Scatter(held, time, label, label="step at rest").opts(
                color=ORANGE, marker="square", size=7
            )
        return self._plot(drawn, f"{what} in each step", size)

    def draw_rate(self, size: Size) -> Any:
        """The rate against time, level within a step."""
        *_, unit, factor = _DRIVES[self.kind]
        # a level from the beginning of a step to its end
        rate = self.rate * factor
        x, y = thinned(self._shown_time, np.append(rate, rate[-1]))
        drawn = hv.Curve((x, y), self._axis, f"Rate [{unit}]")
        low, high = min(0.0, float(y.min())), max(0.0, float(y.max()))
        room = 0.08 * (high - low) or 1.0
        # zero is in view: a constant rate is constant, whatever the rounding of its differences
        drawn = drawn.opts(
            color=BLUE, line_width=1.8, interpolation="steps-post", ylim=(low - room, high + room)
        )
        return self._plot(drawn, "Rate of loading", size)

    @property
    def _axis(self) -> str:
        return "Time [s]" if self.time[-1] > _LONG else "Time [ms]"

    @property
    def _shown_time(self) -> np.ndarray:
        return self.time * (1.0 if self.time[-1] > _LONG else 1e3)

    @staticmethod
    def _told(time: float) -> str:
        return f"{three_digits(time)} s" if time > _LONG else f"{three_digits(time * 1e3)} ms"

    @staticmethod
    def _plot(element: Any, title: str, size: Size) -> Any:
        return beside(rest.pane(element.opts(title=title), size, height(size)), size)
