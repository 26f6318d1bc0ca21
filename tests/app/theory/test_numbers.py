"""What the chapters say was measured is measured again, to the last digit that is printed."""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files
from typing import Any

import pytest

from tests.app.lessons.measures import measured
from tyrecontact import Simulation, presets
from tyrecontact.tread.stability import critical_stiffness

_NUMBER = r"(-?\d+(?:\.\d+)?)"


@cache
def _chapter(name: str) -> str:
    return files("app.theory").joinpath(f"{name}.md").read_text(encoding="utf-8")


def _told(chapter: str, before: str, unit: str, column: int = 0) -> tuple[float, float]:
    """The number with that unit that comes next after a text, or so many further on; and half of
    its last digit.
    """
    words = r"\s+".join(map(re.escape, before.split()))
    found = re.search(words, _chapter(chapter))
    assert found, f"{before!r} is not in {chapter}"
    numbers = re.findall(rf"{_NUMBER}\s*{re.escape(unit)}", _chapter(chapter)[found.end() :])
    digits = len(numbers[column].partition(".")[2])
    return float(numbers[column]), 0.5 * 10**-digits


def _agrees(value: float, told: tuple[float, float]) -> bool:
    number, half_a_digit = told
    return abs(value - number) <= half_a_digit


@pytest.mark.parametrize(
    ("before", "settings"),
    [
        ("| each element its own, tangent |", {}),
        ("| secant |", {"springs.reading": "secant"}),
        ("| polynomials of the tenth order |", {"springs.smoothing": "polynomial"}),
        ("| one mean spring for all |", {"springs.simplification": "mean"}),
        ("| four standard springs |", {"springs.simplification": "standard"}),
        ("| linear springs |", {"springs.simplification": "linear"}),
        ("it matters little:", {"springs.punch": "no-slip"}),
    ],
)
def test_force_with_other_springs(before: str, settings: dict[str, Any]) -> None:
    force = measured("default", settings).run.contact_force[-1]
    assert _agrees(force, _told("01-road", before, "N"))


@pytest.mark.parametrize(
    ("law", "settings"),
    [
        ("release force, as in the thesis' table", {}),
        ("release force, exactly 0.6 N", {"adhesion.table_step": 0.0}),
        ("multiplicative", {"adhesion.law": "multiplicative"}),
        ("bonds", {"adhesion.law": "bonds"}),
        ("receding contact", {"adhesion.law": "receding-contact"}),
        ("hysteresis", {"adhesion.law": "hysteresis"}),
    ],
)
def test_adherence_of_the_laws(law: str, settings: dict[str, Any]) -> None:
    force = measured("adhesion", settings).run.adherence_force
    assert force is not None
    assert _agrees(force, _told("07-adhesion", f"| {law} |", "N"))


@pytest.mark.parametrize("factor", [1, 2, 4])
def test_what_an_interpolated_kernel_loses(factor: int) -> None:
    kernel = _kernel(factor)
    told = _told("06-finer-step", f"| {factor} |", "µm/N")
    assert _agrees(kernel.static_compliance[0, 0] * 1e6, told)


@pytest.mark.parametrize(
    ("factor", "before"),
    [
        (1, "| band-limited, factor 1 |"),
        (2, "| band-limited, interpolated to factor 2 |"),
        (4, "| band-limited, interpolated to factor 4 |"),
    ],
)
def test_critical_stiffness(factor: int, before: str) -> None:
    stiffness = critical_stiffness(_kernel(factor), (20, 20))
    assert _agrees(stiffness / 1e3, _told("05-instability", before, "kN/m"))


@pytest.mark.parametrize("elements", [5, 10, 40])
def test_critical_stiffness_of_other_elements(elements: int) -> None:
    stiffness = critical_stiffness(_kernel(1, elements), (elements, elements))
    row = f"| {elements} × {elements} |"
    assert _agrees(stiffness / 1e3, _told("05-instability", row, "kN/m"))
    area = (20 / elements) ** 2
    assert _agrees(stiffness / 1e3 / area, _told("05-instability", row, "kN/m", column=1))


@pytest.mark.parametrize(
    ("chapter", "before", "settings"),
    [
        ("05-instability", "Ours does the same, at", {}),
        ("06-finer-step", "fails at", {
            "numerics.refinement": "recomputed", "numerics.time_resolution_factor": 2
        }),
    ],
)  # fmt: skip
def test_where_a_run_fails(chapter: str, before: str, settings: dict[str, Any]) -> None:
    run = measured("thesis-instability", settings).run
    assert _agrees(run.indentation[run.failed_at] * 1e3, _told(chapter, before, "mm"))


def test_what_a_finer_step_ends_with() -> None:
    force = measured("thesis-factor-4", {}).run.contact_force[-1]
    assert _agrees(force, _told("06-finer-step", "only 4 % too stiff at 0.2 mm:", "N"))
    assert force / measured("default", {}).run.contact_force[-1] == pytest.approx(1.04, abs=5e-3)


def _kernel(factor: int, elements: int = 20) -> Any:
    made = presets.get("thesis-instability")
    made.set("numerics.time_resolution_factor", factor)
    made.set("road.elements", elements)
    return Simulation(made).kernel
