"""Findings of the thesis' chapter 5: what holds road and tread together, and what does not."""

from __future__ import annotations

import numpy as np

from tyrecontact import figures
from tyrecontact.contact.adhesion import table_limits
from tyrecontact.simulation import Simulation
from tyrecontact.thesis import measures
from tyrecontact.thesis.findings import Claim, Family, Finding, Judge, Measure, Numbers

_ROAD = (
    "the adherence is the sum over the elements that are in tension at once, which the spread of "
    "the road's tops and the springs' stiffness near the release force decide"
)
_INDENTATION = "figures.LOADS was measured on another road: `python -m tyrecontact.thesis.loads`"


def _loads(family: Family) -> list[float]:
    return [float(run.contact_force.max()) for run in family.values()]


def _unloading_rates(family: Family) -> list[float]:
    return [measures.unloading_rate(run) * 1e-3 for run in family.values()]


def _adherences(family: Family) -> list[float]:
    return [measures.adherence(run) for run in family.values()]


def _in_words(values: list[float]) -> str:
    return ", ".join(f"{value:.3g}" for value in values) + " N"


def _limits(_: Family) -> tuple[str, bool]:
    scenario = figures.member("fig-39", "0.6 N")
    adhesion = scenario.adhesion
    if not adhesion.table_step:
        return f"{adhesion.release_force:g} N exactly", False
    limits = table_limits(Simulation(scenario).springs, adhesion.release_force, adhesion.table_step)
    inside = float(np.mean((limits >= 0.3) & (limits <= 0.6)))
    middle = float(np.median(limits))
    found = f"{middle:.2g} N in the middle, {100 * inside:.0f} % of them within 0.3 to 0.6 N"
    return found, inside >= 0.5 and 0.3 <= middle <= 0.6


def _above_100(family: Family) -> tuple[str, bool]:
    load = _loads(family)[0]
    return f"{load:.3g} N", load > 100


def _no_avalanche(family: Family) -> tuple[str, bool]:
    share = max(measures.largest_event(run) for run in family.values())
    return f"{100 * share:.0f} % of the contacts in the largest event", share < 0.5


def _grows(least: float) -> Judge:
    def measure(family: Family) -> tuple[str, bool]:
        found = np.array(_adherences(family))
        return _in_words(list(found)), bool(np.all(found[1:] >= least * found[:-1]))

    return measure


def _same(allowed: float) -> Judge:
    def measure(family: Family) -> tuple[str, bool]:
        found = np.array(_adherences(family))
        apart = measures.spread(found)
        return f"{_in_words(list(found))}: {100 * apart:.1f} % apart", apart <= allowed

    return measure


def _alike(family: Family) -> tuple[str, bool]:
    apart = measures.mean_difference(family["dynamic"], family["quasi-static"])
    return f"{100 * apart:.1f} % of the largest force apart on average", apart <= 0.05


def _stays_stable(family: Family) -> tuple[str, bool]:
    said = []
    for label, run in family.items():
        failed = run.failed_at
        if failed is None:
            said.append(f"{label}: no step fails, adherence {measures.adherence(run):.3g} N")
        else:
            said.append(f"{label}: fails at {run.time[failed] * 1e3:.3g} ms")
    return "; ".join(said), all(run.failed_at is None for run in family.values())


def _loads_of(figure: str, expected: list[float]) -> Numbers:
    return Numbers(figure, "Preloads", expected, "N", _loads, _INDENTATION)


def _rates_of(figure: str, expected: list[float]) -> Numbers:
    measure: Measure = _unloading_rates
    return Numbers(figure, "Unloading rates", expected, "N/ms", measure, _INDENTATION)


FINDINGS: tuple[Finding, ...] = (
    Claim(
        "fig-39",
        "The table lets bonds go before the release force of 0.6 N (Appendix C.4)",
        "between 0.3 and 0.6 N",
        "the median, and half of the elements or more, within",
        _limits,
        "stiff springs gain more than 0.3 N from one entry of the table to the next",
    ),
    Claim(
        "factor-2",
        "Doubling the time resolution avoids the instability (chapter 5.1)",
        "avoided",
        "no step fails, hold included",
        _stays_stable,
        "in a hold even a weak instability has time to grow: springs pressed beyond the critical "
        "stiffness of factor 2, 1.1e5 N/m, are unstable whatever the rate. The other runs of "
        "chapter 5 use the passive kernel, which has no such limit",
    ),
    Numbers(
        "factor-2",
        "Adherence after 62 and 150 N, with the thesis' own kernel at factor 2",
        [23, 28],
        "N",
        _adherences,
        _ROAD,
    ),
    Claim("fig-42", "Preload", "above 100 N", "above 100 N", _above_100, _INDENTATION),
    _rates_of("fig-42", [0.6]),
    Claim(
        "fig-42",
        "The release is gradual",
        "no big avalanche effect",
        "no event takes half of the contacts, while a tenth of them hold",
        _no_avalanche,
        "the elements of this road are more alike than those of the thesis'",
    ),
    Claim(
        "fig-43",
        "The release force makes the adherence: 0.3, 0.6, 0.9 N",
        "greatly affected",
        "at least 1.2 times as much for each more",
        _grows(1.2),
        _ROAD,
    ),
    _loads_of("fig-44", [14, 62, 150]),
    _rates_of("fig-44", [1.8, 2.4, 3.8]),
    Numbers(
        "fig-44",
        "Adherence after preloads of 14, 62 and 150 N",
        [16, 23, 28],
        "N",
        _adherences,
        _ROAD,
    ),
    Claim(
        "fig-44",
        "The adherence grows with the preload",
        "affected by the load",
        "more for each larger load",
        _grows(1.0),
        _ROAD,
    ),
    Claim(
        "fig-45",
        "The adherence does not know the dwell: 1, 10, 30 ms",
        "the same",
        "at most 5 % apart",
        _same(0.05),
        "the tread still creeps in the shortest hold, and presses more elements later",
    ),
    _rates_of("fig-46", [1.7, 2.4, 3.7, 7.2, 24]),
    Claim(
        "fig-46",
        "The adherence does not know the rate of unloading",
        "nearly the same",
        "at most 10 % apart",
        _same(0.1),
        "at the fastest rate the tread's own delay holds some elements together longer",
    ),
    Claim(
        "fig-49",
        "Dynamic and quasi-static adherence are the same",
        "the same",
        "at most 10 % apart",
        _same(0.1),
        "the dynamic run presses harder, and so bonds more elements",
    ),
    Claim(
        "fig-49",
        "Dynamic and quasi-static force are alike throughout",
        "very similar",
        "at most 5 % of the largest force apart on average",
        _alike,
        "the tread's delay shifts the dynamic curve",
    ),
)
