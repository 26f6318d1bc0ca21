"""The runs that the thesis' figures are made of, with the settings of its Appendix C."""

from __future__ import annotations

from tyrecontact.scenario import Scenario

#: the thesis' error limit of a Newton iteration [m], and of its largest indentation
ERROR_LIMIT, _DEEPEST = 1e-15, 0.2e-3
#: steps of a quasi-static ramp
_STILL_STEPS = 100

#: Of the default road, by `python -m tyrecontact.thesis.loads`:
#: preload [N] -> indentation that gives it [m], way back to no force per newton [m/N]
LOADS = {
    14: (36.9e-6, 1.126e-6),
    62: (64.8e-6, 0.471e-6),
    110: (83.3e-6, 0.404e-6),
    150: (97.7e-6, 0.394e-6),
}
#: entries of the thesis' spring tables are so far apart [m], which its text does not say; with
#: these most bonds let go at its 0.3 to 0.6 N
TABLE_STEP = 2.5e-6


def dynamic(factor: int = 1) -> Scenario:
    """The thesis' dynamic run: band-limited kernel, plain Newton, no adhesion (Appendix C)."""
    return Scenario(
        adhesion={"release_force": 0.0},
        numerics={
            "kernel": "band-limited",
            "solver": "thesis",
            "initial_guess": "last",
            "tolerance": ERROR_LIMIT / _DEEPEST,
            "max_iterations": 10,
            "time_resolution_factor": factor,
        },
    )


def at_rest(factor: int = 1) -> Scenario:
    """The thesis' quasi-static run: its kernel summed over time, interpolation included."""
    still = dynamic(factor)
    still.numerics.param.update(kernel="static", statics="band-limited", max_iterations=50)
    still.loading.rate = _DEEPEST * still.numerics.sampling_frequency * factor / _STILL_STEPS
    return still


def sticky(load: int = 62, unloading: float = 2.4, hold: float = 10e-3) -> Scenario:
    """The thesis' adhesion run: pressed to a load [N], held [s], pulled off [N/ms] (Fig. 40).

    With the passive kernel and the guarded solver at the original time step: a quarter of the
    cost, and stable in any hold. `families.factor_2` has the thesis' own for comparison.
    """
    indentation, way = LOADS[load]
    return Scenario(
        adhesion={"release_force": 0.6, "table_step": TABLE_STEP},
        loading={
            "profile": "load-hold-unload",
            "max_indentation": indentation,
            "hold_time": hold,
            "unloading_rate": unloading * 1e3 * way,
            "retraction": 150e-6,
        },
        numerics={"tolerance": 1e-8},
    )


def changed(base: Scenario, **changes: object) -> Scenario:
    """A scenario with some settings changed: `loading_rate=...` is loading.rate."""
    for path, value in changes.items():
        base.set(path.replace("_", ".", 1), value)
    return base
