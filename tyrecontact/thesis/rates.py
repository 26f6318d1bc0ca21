"""Findings of the thesis' chapter 4.3: dynamic against quasi-static, at many rates."""

from __future__ import annotations

import numpy as np

from tyrecontact.thesis import measures
from tyrecontact.thesis.findings import Claim, Family, Finding, Judge, Measure, Numbers
from tyrecontact.thesis.wording import percent, percents

_RAMPS = ("20 ms", "13.3 ms", "6.7 ms", "2 ms")
_PARABOLAS = ("C = 0.5", "C = 1.13", "C = 4.5", "C = 50")
#: where dynamic and quasi-static forces are compared [m]
_DEPTHS = np.array([60e-6, 120e-6, 190e-6])
#: no large difference
_CLOSE = 0.1
_CURVE = "the force of this road grows otherwise with the indentation than that of the thesis' scan"
_NOT_CLOSE = (
    "the tread's loss factor makes a faster contact stiffer; the thesis' own criterion is its eye"
)
_NOT_MOST = "the slowest ramp differs as much: what is left there is no effect of the rate"


def _loading_rates(labels: tuple[str, ...]) -> Measure:
    def measure(family: Family) -> list[float]:
        return [measures.loading_rate(family[label]) * 1e-3 for label in labels]

    return measure


def _excesses(family: Family, labels: tuple[str, ...]) -> dict[str, np.ndarray]:
    still = family["quasi-static"]
    return {label: measures.excess(family[label], still, _DEPTHS) for label in labels}


def _close_but_for_the_fastest(labels: tuple[str, ...]) -> Judge:
    def measure(family: Family) -> tuple[str, bool]:
        found = _excesses(family, labels)
        text = "; ".join(f"{label}: {percents(values)}" for label, values in found.items())
        return text, all(np.abs(found[label]).max() <= _CLOSE for label in labels[:-1])

    return measure


def _fastest_differs_most(labels: tuple[str, ...]) -> Judge:
    def measure(family: Family) -> tuple[str, bool]:
        largest = [float(np.abs(v).max()) for v in _excesses(family, labels).values()]
        return ", ".join(map(percent, largest)), largest[-1] == max(largest)

    return measure


def _stiffer(label: str) -> Measure:
    def measure(family: Family) -> list[float]:
        return list(100 * measures.excess(family[label], family["quasi-static"], _DEPTHS))

    return measure


def _of(figure: str, kind: str, labels: tuple[str, ...], rates: list[float]) -> list[Finding]:
    """The findings that linear and quadratic loading share."""
    return [
        Numbers(
            figure,
            f"Loading rates, {kind} (a line from a tenth of the force on)",
            rates,
            "N/ms",
            _loading_rates(labels),
            _CURVE,
        ),
        Claim(
            figure,
            f"Dynamic and quasi-static force are close, {kind}, but for the fastest rate",
            "no major differences",
            "at most 10 % at 60, 120 and 190 µm",
            _close_but_for_the_fastest(labels),
            _NOT_CLOSE,
        ),
        Claim(
            figure,
            f"The fastest rate differs most, {kind}",
            "except for the highest loading rate",
            "the largest difference of the four",
            _fastest_differs_most(labels),
            _NOT_MOST,
        ),
    ]


def _excess_at(label: str, shares: list[float]) -> Numbers:
    return Numbers(
        "rate-effect",
        f"Dynamic less quasi-static force at 60, 120, 190 µm, {label} (physics, 9)",
        shares,
        "%",
        _stiffer(label),
        "the specification's numbers are of another road; at 300 mm/s 60 µm are reached 0.2 ms "
        "after first touch, when waves have not yet crossed the tread twice. The time step is not "
        "the cause: factors 1 to 8 give the same to 2 %",
        slack=1.0,
    )


FINDINGS: tuple[Finding, ...] = (
    *_of("fig-30-34", "linear", _RAMPS, [30, 40, 80, 270]),
    *_of("fig-35-38", "quadratic", _PARABOLAS, [40, 60, 120, 390]),
    _excess_at("30 mm/s", [3, 1.8, 1.3]),
    _excess_at("300 mm/s", [11, 7, 5]),
)
