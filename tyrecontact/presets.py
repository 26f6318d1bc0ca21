"""Ready-made scenarios; each is a function whose docstring is its caption and source."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from tyrecontact.errors import unknown_name
from tyrecontact.scenario import Scenario

#: the thesis' error limit of 1e-15 m, per its indentation of 0.2 mm
_THESIS_TOLERANCE = 5e-12


def default() -> Scenario:
    """Thesis defaults with the passive kernel: a ramp to 0.2 mm at 30 mm/s, stable throughout."""
    return Scenario()


def thesis_instability() -> Scenario:
    """The thesis' dynamic run that blows up (Fig. 19): band-limited kernel, plain Newton."""
    return Scenario(
        adhesion={"release_force": 0.0},
        numerics={
            "kernel": "band-limited",
            "solver": "thesis",
            "initial_guess": "last",
            "tolerance": _THESIS_TOLERANCE,
            "max_iterations": 10,
        },
    )


def thesis_factor_2() -> Scenario:
    """The first cure of the thesis, half the time step by interpolation (Fig. 27)."""
    scenario = thesis_instability()
    scenario.numerics.time_resolution_factor = 2
    return scenario


def thesis_factor_4() -> Scenario:
    """A quarter of the time step by interpolation: the thesis' run to 0.2 mm (Fig. 27)."""
    scenario = thesis_instability()
    scenario.numerics.time_resolution_factor = 4
    return scenario


def thesis_exchange() -> Scenario:
    """The thesis' second cure, the 80 stiffest springs exchanged (Fig. 27): it reaches further."""
    scenario = thesis_instability()
    scenario.springs.exchange_count = 80
    return scenario


def quasi_static() -> Scenario:
    """The tread at rest in every step (Fig. 18): what all dynamic runs are compared with."""
    return Scenario(numerics={"kernel": "static"})


def adhesion() -> Scenario:
    """Pressed in by 0.063 mm, held, and pulled off a sticky road (after Figs. 42 and 43)."""
    return Scenario(
        loading={
            "profile": "load-hold-unload",
            "max_indentation": 63e-6,
            "hold_time": 2e-3,
            "unloading_rate": 3e-3,
        }
    )


PRESETS: Mapping[str, Callable[[], Scenario]] = MappingProxyType(
    {
        "default": default,
        "thesis-instability": thesis_instability,
        "thesis-factor-2": thesis_factor_2,
        "thesis-factor-4": thesis_factor_4,
        "thesis-exchange": thesis_exchange,
        "quasi-static": quasi_static,
        "adhesion": adhesion,
    }
)


def names() -> list[str]:
    """Names of all presets, in the order in which they tell the story."""
    return list(PRESETS)


def get(name: str) -> Scenario:
    """A new scenario of a preset.

    Raises
    ------
    InputError : no preset has that name; the nearest is offered.
    """
    return _function(name)()


def caption(name: str) -> str:
    """One line on what a preset shows, and where it is from."""
    return (_function(name).__doc__ or "").strip().partition("\n")[0]


def _function(name: str) -> Callable[[], Scenario]:
    if not isinstance(name, str) or name not in PRESETS:
        raise unknown_name("preset", name, PRESETS)
    return PRESETS[name]
