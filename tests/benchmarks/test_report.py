"""The table of the benchmarks: what it says of much, of little, and of nothing measured."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from tests.benchmarks.cases import SIZES
from tests.benchmarks.report import BEGIN, END, Measured, judged, placed, slope, text

MACHINE = {"python_version": "3.11.7", "machine": "x86_64"}


def measured(*rows: dict[str, Any]) -> Measured:
    benchmarks = [{"name": "test", "stats": {"min": 1.0}, "extra_info": row} for row in rows]
    written = {"machine_info": MACHINE, "datetime": "2026-01-31T12:00", "benchmarks": benchmarks}
    return Measured.read(written)


def step(elements: int, seconds: float) -> dict[str, Any]:
    return {"case": "step", "kernel": "passive", "elements": elements, "seconds": seconds}


def verdicts(found: Measured) -> dict[str, str]:
    return {line.what: line.row()[-1] for line in judged(found)}


def test_nothing_measured_is_nothing_judged() -> None:
    assert set(verdicts(measured()).values()) == {""}
    assert "nan" not in text(measured())


@pytest.mark.parametrize(("seconds", "verdict"), [(1e-4, "yes"), (1e-2, "**no**")])
def test_a_step_is_judged_against_the_baseline_and_the_clock(seconds: float, verdict: str) -> None:
    direct = {"case": "direct", "kernel": "passive", "seconds": 0.1, "difference": 1e-12}
    found = verdicts(measured(step(20, seconds), direct))
    assert [found[what] for what in found if what.startswith("20 x 20")] == [verdict] * 2


def test_a_step_is_judged_against_a_solve_of_its_size() -> None:
    solve = {"case": "tamaas", "elements": 64, "seconds": 1e-2, "version": "2.9"}
    assert verdicts(measured(step(64, 1.4e-2), step(256, 1), solve)) | {
        "64 x 64: a dynamic step in solves by Tamaas": "yes",
        "256 x 256: a dynamic step in solves by Tamaas": "",
    } == verdicts(measured(step(64, 1.4e-2), step(256, 1), solve))
    assert "Tamaas 2.9" in text(measured(solve))


@pytest.mark.parametrize(("power", "verdict"), [(1.0, "yes"), (1.2, "**no**")])
def test_growth_is_judged_against_m_log_m(power: float, verdict: str) -> None:
    rows = [step(n, (n**2 * np.log(n**2)) ** power) for n in SIZES]
    assert verdicts(measured(*rows))["a step against M log M, from 64 x 64 on: exponent"] == verdict


def test_an_exponent_needs_three_points() -> None:
    assert slope(np.array([1.0, 2, 4]), [3, 12, 48]) == pytest.approx(2)
    assert math.isnan(slope(np.array([1.0, 2, 4]), [3, 12, math.nan]))


def test_the_table_takes_the_place_between_its_markers() -> None:
    document = f"before\n{BEGIN}\nold\n{END}\nafter\n"
    assert placed(document, "new") == f"before\n{BEGIN}\nnew\n{END}\nafter\n"
    with pytest.raises(ValueError, match="must hold the lines"):
        placed(f"before\n{BEGIN}\n", "new")
