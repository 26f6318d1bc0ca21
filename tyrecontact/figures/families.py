"""The families: each figure's scenarios, label -> scenario, quasi-static ones first.

A docstring is caption and source of its figure.
"""

from __future__ import annotations

from collections.abc import Callable

from tyrecontact.figures.base import ERROR_LIMIT, at_rest, changed, dynamic, sticky
from tyrecontact.figures.registry import beside_the_thesis, figure
from tyrecontact.scenario import Scenario

#: rates that reach 0.2 mm in these times [m/s], and the thesis' C of d = C t^2 [m/s2]
_RAMPS = {"20 ms": 0.01, "13.3 ms": 0.015, "6.7 ms": 0.03, "2 ms": 0.1}
_PARABOLAS = {"C = 0.5": 0.5, "C = 1.13": 1.13, "C = 4.5": 4.5, "C = 50": 50.0}


@figure(18, 18, "thesis", chapter="3.5")
def validation() -> dict[str, Scenario]:
    """Quasi-static force by two solvers, the guarded one and the thesis' own (Fig. 18)."""
    return {"guarded": changed(at_rest(), numerics_solver="robust"), "thesis": at_rest()}


@figure(19, 19, "dynamic", chapter="4.1")
def instability() -> dict[str, Scenario]:
    """The dynamic run that blows up, and more iterations that do not help (Fig. 19)."""
    more = changed(dynamic(), numerics_max_iterations=50)
    return {"quasi-static": at_rest(), "dynamic": dynamic(), "50 iterations": more}


@figure(20, 20, "extrapolated", chapter="4.1")
def first_guess() -> dict[str, Scenario]:
    """A better first guess, from the last two steps, does not help (Fig. 20)."""
    better = changed(dynamic(), numerics_initial_guess="extrapolated")
    return {"quasi-static": at_rest(), "last": dynamic(), "extrapolated": better}


@figure(21, 21, "20 ms", chapter="4.1")
def ramps() -> dict[str, Scenario]:
    """Slower loading fails no later: 0.2 mm in 20, 13.3, 6.7 and 2 ms (Fig. 21)."""
    runs = {label: changed(dynamic(), loading_rate=rate) for label, rate in _RAMPS.items()}
    return {"quasi-static": at_rest(), **runs}


@figure(22, 22, "factor 2", chapter="4.2.1")
def interpolation() -> dict[str, Scenario]:
    """The kernel at half and a quarter of the time step, by interpolation (Fig. 22)."""
    return {f"factor {factor}": dynamic(factor) for factor in (1, 2, 4)}


def _cures(base: Callable[[int], Scenario]) -> dict[str, Scenario]:
    exchanged = changed(base(1), springs_exchange_count=80)
    return {**{f"factor {factor}": base(factor) for factor in (1, 2, 4)}, "exchanged": exchanged}


@figure(24, 26, "exchanged", chapter="4.2.3")
def cures_at_rest() -> dict[str, Scenario]:
    """What a finer step and exchanged springs change in the quasi-static force (Figs. 24-26)."""
    return _cures(at_rest)


@figure(27, 29, "factor 4", chapter="4.2.4")
def cures() -> dict[str, Scenario]:
    """A finer step or softer springs against the instability (Figs. 27-29)."""
    return _cures(dynamic)


@figure(30, 34, "2 ms", chapter="4.3.1")
def linear_loading() -> dict[str, Scenario]:
    """Loading at four constant rates, dynamic against quasi-static (Figs. 30-34)."""
    runs = {label: changed(dynamic(4), loading_rate=rate) for label, rate in _RAMPS.items()}
    return {"quasi-static": at_rest(4), **runs}


@figure(35, 38, "C = 50", chapter="4.3.2")
def quadratic_loading() -> dict[str, Scenario]:
    """Loading at four constant accelerations, d = C t², C in m/s² (Figs. 35-38)."""
    runs = {
        label: changed(dynamic(4), loading_profile="quadratic", loading_acceleration=2 * half)
        for label, half in _PARABOLAS.items()
    }
    return {"quasi-static": at_rest(4), **runs}


@figure(39, 39, "0.6 N", chapter="5.1")
def mirrored_springs() -> dict[str, Scenario]:
    """Springs that pull as they press, up to a release force of 0.6 N (Fig. 39)."""
    return {"0.6 N": sticky()}


@figure(42, 42, "110 N", chapter="5.2")
def slow_release() -> dict[str, Scenario]:
    """A long and slow release, after the experiment: no avalanche (Fig. 42)."""
    return {"110 N": sticky(load=110, unloading=0.6, hold=60e-3)}


@figure(43, 43, "0.9 N", chapter="5.3")
def release_forces() -> dict[str, Scenario]:
    """The release force makes the adherence: 0.3, 0.6 and 0.9 N (Fig. 43)."""
    return {
        f"{force} N": changed(sticky(), adhesion_release_force=force) for force in (0.3, 0.6, 0.9)
    }


@figure(44, 44, "150 N", chapter="5.3")
def preloads() -> dict[str, Scenario]:
    """The adherence grows with the preload: 14, 62 and 150 N (Fig. 44)."""
    return {"14 N": sticky(14, 1.8), "62 N": sticky(62, 2.4), "150 N": sticky(150, 3.8)}


@figure(45, 45, "30 ms", chapter="5.3")
def dwells() -> dict[str, Scenario]:
    """The adherence does not know how long the load lasted: 1, 10 and 30 ms (Fig. 45)."""
    return {f"{time} ms": sticky(hold=time * 1e-3) for time in (1, 10, 30)}


@figure(46, 46, "24.0 N/ms", chapter="5.3")
def unloading_rates() -> dict[str, Scenario]:
    """The adherence does not know the rate of unloading: 1.7 to 24 N/ms (Fig. 46)."""
    return {f"{rate} N/ms": sticky(unloading=rate) for rate in (1.7, 2.4, 3.7, 7.2, 24.0)}


@figure(49, 49, "dynamic", chapter="5.4")
def sinusoidal() -> dict[str, Scenario]:
    """Pressed and pulled off along a sine, dynamic and quasi-static (Fig. 49)."""
    moved = changed(sticky(), loading_profile="sinusoidal", loading_period=0.1)
    moved.loading.retraction = 120e-6
    still = changed(moved.copy(), numerics_kernel="static")
    return {"quasi-static": still, "dynamic": moved}


@beside_the_thesis("cause", "passive kernel")
def cause() -> dict[str, Scenario]:
    """Not in the thesis: the instability is the kernel's, whatever the solver (physics, 5)."""
    guarded = changed(dynamic(), numerics_solver="robust", numerics_max_iterations=50)
    passive = changed(dynamic(), numerics_kernel="passive")
    return {"band-limited kernel": dynamic(), "guarded solver": guarded, "passive kernel": passive}


@beside_the_thesis("factor-2", "150 N")
def factor_2() -> dict[str, Scenario]:
    """Two adhesion runs with the thesis' own kernel and solver, at its factor 2 (chapter 5.1)."""
    runs = {"62 N": sticky(62, 24.0), "150 N": sticky(150, 24.0)}
    for run in runs.values():
        run.numerics = dynamic(2).numerics
        run.numerics.tolerance = ERROR_LIMIT / run.loading.max_indentation
        run.numerics.margin_interval = 20
    return runs


@beside_the_thesis("rate-effect", "300 mm/s")
def rate_effect() -> dict[str, Scenario]:
    """Not in the thesis: how much stiffer a faster contact is, passive kernel (physics, 9)."""
    bare = Scenario(adhesion={"release_force": 0.0})
    still = changed(bare.copy(), numerics_kernel="static", loading_rate=0.1)
    fast = changed(bare.copy(), loading_rate=0.3, numerics_time_resolution_factor=4)
    return {"quasi-static": still, "30 mm/s": bare, "300 mm/s": fast}
