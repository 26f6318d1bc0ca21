"""What one simulation has made and another would make alike is handed on, not made again."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tyrecontact.simulation import Simulation

_SPRINGS = tuple(
    f"springs.{name}" for name in ("youngs_modulus", "punch", "reading", "smoothing")
)  # as they are read off the road
_STEPPING = (
    "sampling_frequency",
    "time_resolution_factor",
    "lags",
    "kernel",
    "quadrature",
    "refinement",
    "statics",
)
_KERNEL = ("tread", "road.size", "road.elements", *(f"numerics.{name}" for name in _STEPPING))
#: part of a simulation -> what it depends on: parts of a scenario, or single settings
DEPENDS = {
    "patch": ("road",),
    "original_springs": ("road", *_SPRINGS),
    "springs": ("road", "springs"),
    "kernel": _KERNEL,
    "lattice": _KERNEL,
    "margin": _KERNEL,
}


def hand_on(made: Simulation, fresh: Simulation) -> None:
    """Give `fresh` what `made` has computed so far and `fresh` would compute alike.

    Nothing is copied: the parts are shared, and neither simulation writes to them. A file counts
    by its time of change and its size.
    """
    if made.stamps != fresh.stamps:
        return
    old, new = made.scenario.to_dict(), fresh.scenario.to_dict()
    for part, settings in DEPENDS.items():
        if part in vars(made) and _asked(old, settings) == _asked(new, settings):
            setattr(fresh, part, vars(made)[part])


def _asked(parts: dict[str, dict[str, Any]], settings: Iterable[str]) -> list[Any]:
    """Values of settings, or of all settings of a part."""
    split = (path.partition(".") for path in settings)
    return [parts[part][name] if name else parts[part] for part, _, name in split]
