"""The tread that goes into a run: its element kernel in time, and how far its springs may go."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import holoviews as hv
import numpy as np

from tyrecontact import Simulation, assembly
from tyrecontact.scenario import Scenario
from tyrecontact.tread.kernels import Kernel, critical_stiffness

from . import rest
from .comparison import COLORS, thinned
from .headline import three_digits
from .input_sheet import Sheet, beside, height
from .style import BLUE, GREY, Size

#: of the kernel that is shown [s]: the thesis' figure is about the first samples
SHOWN = 0.5e-3
_TIME, _IMPULSE = "Time [ms]", "Displacement per impulse [m/(N s)]"
#: place -> offset (rows, columns)
PLACES = {"loaded element": (0, 0), "next to it": (0, 1), "across the corner": (1, 1)}
_DASHES = ("solid", "dashed", "dotdash")
_MOVING = (
    "How the tread moves after an impulse on one element, at that element and beside it, then "
    "under a force that stays (creep), and at last at rest, against distance "
    "(thesis, chapter 3.3; {fig}). "
)
_AT_REST = (
    "The tread at rest has no memory: a force on one element displaces it and its neighbours at "
    "once, ever less with distance (thesis, chapters 3.3 and 4.2.3). "
)


@dataclass(frozen=True)
class KernelInput:
    """What is drawn of a kernel.

    Attributes
    ----------
    kernel : of the run. coarse : the same before resampling to a finer time step, or None.
    critical : spring stiffness from which on time stepping may be unstable [N/m], or inf.
    """

    kernel: Kernel
    coarse: Kernel | None
    critical: float
    name: str
    factor: int

    @classmethod
    def of(cls, simulation: Simulation) -> KernelInput:
        """Takes a second, or much longer for a kernel that is computed for the first time."""
        kernel, numerics = simulation.kernel, simulation.scenario.numerics
        ny, nx = kernel.values.shape[1:]
        return cls(
            kernel=kernel,
            coarse=_before(simulation.scenario) if np.isfinite(kernel.time_step) else None,
            critical=critical_stiffness(kernel, (ny, nx)),
            name=numerics.kernel,
            factor=numerics.time_resolution_factor,
        )

    @property
    def moves(self) -> bool:
        """Whether the kernel has a time; that of the tread at rest has none."""
        return bool(np.isfinite(self.kernel.time_step))

    @property
    def facts(self) -> dict[str, str]:
        """Name -> value with unit."""
        kernel = self.kernel
        own = float(kernel.static_compliance[0, 0])
        facts = {"Kernel": self.name, "Compliance at rest": f"{three_digits(own * 1e6)} µm/N"}
        if self.moves:
            memory = kernel.lags * kernel.time_step
            facts |= {
                "Time step": f"{three_digits(kernel.time_step * 1e6)} µs (factor {self.factor})",
                "Lags": str(kernel.lags),
                "Memory": f"{three_digits(memory * 1e3)} ms",
            }
        limit = "none: unconditionally stable"
        if np.isfinite(self.critical):
            limit = f"{three_digits(self.critical / 1e3)} kN/m"
        return facts | {"Critical stiffness": limit}

    def sheet(self) -> Sheet:
        """Facts, caption, and Fig. 22 of the thesis with what follows from it."""
        if not self.moves:
            return Sheet(self.facts, _AT_REST + self._verdict(), (self.draw_distance,))
        fig = "Fig. 22, no resampling at factor 1"
        if self.coarse is not None:
            fig = "Fig. 22, grey: before resampling"
        plots = (
            partial(self.draw_impulse, "loaded element"),
            partial(self.draw_impulse, "next to it"),
            self.draw_creep,
            self.draw_distance,
        )
        return Sheet(self.facts, _MOVING.format(fig=fig) + self._verdict(), plots)

    def _verdict(self) -> str:
        """One sentence on stability."""
        if np.isinf(self.critical):
            return "No springs, however stiff, make its time stepping unstable."
        return (
            "With all elements in contact, time stepping may become unstable once their springs "
            f"are stiffer than {three_digits(self.critical / 1e3)} kN/m each."
        )

    def draw_impulse(self, place: str, size: Size) -> Any:
        """Displacement after an impulse, before and after resampling."""
        drawn = []
        if self.coarse is not None:
            x, y = _after_impulse(self.coarse, PLACES[place])
            drawn.append(
                hv.Curve((x, y), _TIME, _IMPULSE, label="factor 1").opts(
                    color=GREY, line_width=5, alpha=0.6
                )
            )
        x, y = _after_impulse(self.kernel, PLACES[place])
        label = f"factor {self.factor}"
        drawn.append(
            hv.Curve((x, y), _TIME, _IMPULSE, label=label).opts(color=BLUE, line_width=1.6)
        )
        drawn.append(hv.Scatter((x, y), _TIME, _IMPULSE, label=label).opts(color=BLUE, size=4))
        title = f"After an impulse, {place}"
        return _plot(hv.Overlay(drawn), title, size)

    def draw_creep(self, size: Size) -> Any:
        """Displacement under a constant force, over the whole memory."""
        kernel, drawn = self.kernel, []
        label = "Displacement per force [µm/N]"
        time = (np.arange(kernel.lags) + 1) * kernel.time_step * 1e3
        for (place, offset), color, dash in zip(PLACES.items(), COLORS, _DASHES, strict=False):
            row, column = _within(kernel, offset)
            x, y = thinned(time, kernel.values[:, row, column].cumsum() * 1e6)
            curve = hv.Curve((x, y), _TIME, label, label=place)
            drawn.append(curve.opts(color=color, line_dash=dash, line_width=1.8))
        most = 1e6 * float(kernel.values[:, 0, 0].cumsum().max())
        drawn[0] = drawn[0].opts(ylim=(0, 1.7 * most))  # room for the legend above
        return _plot(hv.Overlay(drawn), "Under a force that stays", size)

    def draw_distance(self, size: Size) -> Any:
        """Displacement at rest, along a row of elements."""
        kernel, label = self.kernel, "Displacement per force [µm/N]"
        values = kernel.static_compliance[0] * 1e6
        distance = np.arange(values.size) * kernel.spacing * 1e3
        x, y = "Distance from the loaded element [mm]", label
        drawn = hv.Curve((distance, values), x, y).opts(color=BLUE, line_width=1.6)
        drawn *= hv.Scatter((distance, values), x, y).opts(color=BLUE, size=6, tools=["hover"])
        return _plot(drawn, "At rest, along a row of elements", size)


def _before(scenario: Scenario) -> Kernel | None:
    """The kernel at the sampling frequency, where the run has a finer time step."""
    if scenario.numerics.time_resolution_factor == 1:
        return None
    plain = scenario.copy()
    plain.numerics.time_resolution_factor = 1
    return assembly.tread_kernel(plain)


def _after_impulse(kernel: Kernel, offset: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Time [ms] and displacement per impulse [m/(N s)], the first of it."""
    row, column = _within(kernel, offset)
    time = np.arange(kernel.lags) * kernel.time_step
    shown = time <= SHOWN
    return time[shown] * 1e3, kernel.values[shown, row, column] / kernel.time_step


def _within(kernel: Kernel, offset: tuple[int, int]) -> tuple[int, int]:
    """An offset as far as the patch goes."""
    ny, nx = kernel.values.shape[1:]
    return min(offset[0], ny - 1), min(offset[1], nx - 1)


def _plot(element: Any, title: str, size: Size) -> Any:
    drawn = element.opts(title=title)
    return beside(rest.pane(drawn, size, height(size)), size)
