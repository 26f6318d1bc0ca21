"""What is drawn of each figure of the thesis: its runs as panels of curves."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import xarray as xr

from tyrecontact.results import Results
from tyrecontact.thesis import measures

from .views.comparison import BEHIND, COLORS, Curve, Panel, Style, styles

Family = Mapping[str, Results]
Draw = Callable[[Family], Panel]

_DEEP, _TIME, _FORCE = "Indentation [µm]", "Time [ms]", "Force [N]"


def _look(family: Family) -> dict[str, Style]:
    """What the others are compared with lies behind them, unless it goes wild itself."""
    sound = [name for name, run in family.items() if run.failed_at is None]
    behind = next((name for name in ("quasi-static", "factor 1") if name in sound), None)
    return styles(list(family), behind)


def _all(family: Family, x: Callable, y: Callable, without: bool = False) -> list[Curve]:
    """All runs, or `without` the quasi-static one; colours are those of the whole family."""
    look = _look(family)
    return [
        Curve(label, x(run), y(run), look[label])
        for label, run in family.items()
        if not (without and label == "quasi-static")
    ]


def _deep(run: Results) -> np.ndarray:
    return run.indentation * 1e6


def _time(run: Results) -> np.ndarray:
    return run.time * 1e3


def force_by_depth(to: float = 200.0) -> Draw:
    """Force against indentation up to `to` [µm], as high as a run that goes well needs."""

    def panel(family: Family) -> Panel:
        curves = _all(family, _deep, lambda run: run.contact_force)
        usual = max(_usual_force(run, to) for run in family.values())
        return Panel("Contact force", _DEEP, _FORCE, curves, (0, to), (-0.04 * usual, 1.25 * usual))

    return panel


def _usual_force(run: Results, to: float) -> float:
    depth, force = measures.force_curve(run)
    return float(np.nanmax(force[depth <= to * 1e-6], initial=1.0))


def iterations_by_depth(to: float = 200.0) -> Draw:
    def panel(family: Family) -> Panel:
        curves = _all(family, _deep, lambda run: run.iterations.astype(float), without=True)
        return Panel(
            "Newton iterations a step", _DEEP, "Iterations", curves, (0, to), (0, 15), steps=True
        )

    return panel


def force_by_time(family: Family) -> Panel:
    curves = _all(family, _time, lambda run: run.contact_force, _is_ramp(family))
    return Panel("Contact force", _TIME, _FORCE, curves)


def depth_by_time(family: Family) -> Panel:
    curves = _all(family, _time, _deep, _is_ramp(family))
    return Panel("Indentation", _TIME, _DEEP, curves)


def iterations_by_time(family: Family) -> Panel:
    curves = _all(family, _time, lambda run: run.iterations.astype(float))
    return Panel("Newton iterations a step", _TIME, "Iterations", curves, None, (0, 11), steps=True)


def _is_ramp(family: Family) -> bool:
    """Whether runs only load: then the time of the quasi-static one means nothing."""
    return any(run.scenario.loading.profile in {"linear", "quadratic"} for run in family.values())


def difference_by_depth(reference: str, percent: bool = False) -> Draw:
    """Force less that of one member."""

    def panel(family: Family) -> Panel:
        look, curves = _look(family), []
        still = family[reference]
        for label, run in family.items():
            depth, force = measures.force_curve(run)
            due = measures.force_at(still, depth * (1 - 1e-9))
            if label == reference or depth.size < 2:
                continue
            shown = depth >= 20e-6  # shares of next to nothing tell nothing
            change = 100 * (force / np.where(due > 0, due, np.nan) - 1) if percent else force - due
            use = shown if percent else np.ones(depth.size, bool)
            curves.append(Curve(label, depth[use] * 1e6, change[use], look[label]))
        unit = "%" if percent else "N"
        return Panel(f"Force less that of {reference}", _DEEP, f"Difference [{unit}]", curves)

    return panel


def stiffness_by_depth(family: Family) -> Panel:
    return _stiffness(family, lambda depth, force: depth * 1e6, _DEEP)


def stiffness_by_force(family: Family) -> Panel:
    return _stiffness(family, lambda depth, force: force, _FORCE)


def _stiffness(family: Family, x: Callable, x_label: str) -> Panel:
    """As high as a run that goes well needs."""
    look, curves, usual = _look(family), [], 0.0
    for label, run in family.items():
        depth, force, stiffness = measures.stiffness_curve(run)
        curves.append(Curve(label, x(depth, force), stiffness / 1e6, look[label]))
        if run.failed_at is None:
            usual = max(usual, float(np.nanmax(stiffness, initial=0.0)) / 1e6)
    window = (-0.04 * usual, 1.25 * usual) if usual else None
    return Panel("Contact stiffness", x_label, "Stiffness [MN/m]", curves, None, window)


def margin_by_depth(family: Family) -> Panel:
    curves = _all(family, _deep, lambda run: run.stability_margin)
    title = "Margin of the time stepping (below 0: unstable)"
    return Panel(title, _DEEP, "Margin", curves, (0, 200), (-1.0, 1.1))


_ON_ONE_ROAD = (force_by_depth(), stiffness_by_depth, stiffness_by_force)
_LOADING = (
    depth_by_time, force_by_time, force_by_depth(), difference_by_depth("quasi-static"),
    stiffness_by_depth, stiffness_by_force,
)  # fmt: skip
_RELEASE = (force_by_time, depth_by_time)
#: figure -> its panels
PANELS: Mapping[str, tuple[Draw, ...]] = {
    "fig-18": (force_by_depth(),),
    "fig-19": (force_by_depth(120), iterations_by_depth(120)),
    "fig-20": (force_by_depth(120), iterations_by_depth(120)),
    "fig-21": (force_by_depth(120), iterations_by_depth(120)),
    "fig-24-26": (*_ON_ONE_ROAD, difference_by_depth("factor 1")),
    "fig-27-29": (*_ON_ONE_ROAD, iterations_by_depth()),
    "fig-30-34": _LOADING,
    "fig-35-38": _LOADING,
    "fig-42": _RELEASE,
    "fig-43": _RELEASE,
    "fig-44": _RELEASE,
    "fig-45": _RELEASE,
    "fig-46": _RELEASE,
    "fig-49": _RELEASE,
    "cause": (force_by_depth(), iterations_by_depth(), margin_by_depth),
    "factor-2": (force_by_time, iterations_by_time),
    "rate-effect": (force_by_depth(), difference_by_depth("quasi-static", percent=True)),
}


def kernel_panels(dataset: xr.Dataset) -> list[Panel]:
    """Fig. 22: the kernel of the loaded element and of its neighbour."""
    labels = ["factor 1", "factor 2", "factor 4"]
    look = {"factor 1": BEHIND, "factor 2": Style(COLORS[0]), "factor 4": Style(COLORS[1])}
    panels = []
    for place, title in (("self", "Kernel, loaded element"), ("neighbour", "Kernel, neighbour")):
        curves = []
        for label in labels:
            name = label.replace(" ", "_")
            time = dataset[f"time_{name}"].to_numpy() * 1e3
            curves.append(Curve(label, time, dataset[f"{place}_{name}"].to_numpy(), look[label]))
        panels.append(Panel(title, _TIME, "Displacement per impulse [m/(N s)]", curves))
    return panels


_SPRING_WINDOWS = {
    "force": ("Spring force", (-1.0, 2.0)),
    "stiffness": ("Spring stiffness", (-0.05, 1.0)),
}


def spring_panels(dataset: xr.Dataset) -> list[Panel]:
    """Fig. 39: force and stiffness of four springs."""
    depth = dataset["compression"].to_numpy() * 1e6
    panels = []
    for name, label, scale in (("force", _FORCE, 1.0), ("stiffness", "Stiffness [MN/m]", 1e-6)):
        curves = [
            Curve(f"spring {number + 1}", depth, values * scale, Style(COLORS[number]))
            for number, values in enumerate(dataset[name].to_numpy())
        ]
        # what pulls is small beside what presses: the window is on the release
        title, window = _SPRING_WINDOWS[name]
        panels.append(Panel(title, "Compression [µm]", label, curves, None, window))
    return panels
