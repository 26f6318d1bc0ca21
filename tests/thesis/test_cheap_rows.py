"""Rows that cost next to nothing, on the real road and the real kernels."""

from __future__ import annotations

import pytest

from tyrecontact import Simulation, figures
from tyrecontact.results import Results
from tyrecontact.thesis import FINDINGS, curves, findings, runs


@pytest.fixture(scope="module")
def families() -> dict[str, dict[str, Results]]:
    """The quasi-static families; kernels need no run."""
    found: dict[str, dict[str, Results]] = {"fig-22": {}, "fig-39": {}}
    for name in ("fig-18", "fig-24-26"):
        family = figures.find(name).family()
        found[name] = {label: runs.run(scenario.to_dict()) for label, scenario in family.items()}
    return found


def test_the_rows_that_hold_on_any_road(families: dict[str, dict[str, Results]]) -> None:
    rows = {row.statement: row for row in findings.judged(FINDINGS, families)}
    assert rows["Quasi-statically, two solvers give one curve"].agrees
    assert rows["Time step at factors 1, 2 and 4"].agrees
    slip = rows["Time shown of the kernel"]
    assert (slip.agrees, slip.found) == (False, "5 (−80 %) ms")
    assert "slip" in slip.reason
    little = rows["Quasi-statically the cures change little at the forces under a tyre"]
    assert little.agrees, little.found


def test_interpolation_takes_from_the_statics_exactly_what_the_specification_says() -> None:
    kernels = {
        factor: Simulation(figures.dynamic(factor)).kernel.static_compliance for factor in (1, 2, 4)
    }
    values = Simulation(figures.dynamic()).kernel.values
    for factor in (2, 4):
        lost = (1 - 1 / factor) * (values[0] + values[-1]) / 2
        found = kernels[1] - kernels[factor]
        assert abs(found - lost).max() < 1e-12 * values[0, 0, 0]  # rounding
        still = figures.at_rest(factor)
        assert Simulation(still).kernel.values[0] == pytest.approx(kernels[factor], rel=1e-12)


def test_figures_without_a_run_are_drawn_from_bodies() -> None:
    kernels = curves.kernels()
    own = kernels["self_factor_1"].to_numpy()
    assert own[0] == own.max() > 0
    # every second sample of the finer one is a sample of the coarser one
    assert kernels["self_factor_2"].to_numpy()[::2] == pytest.approx(own, rel=1e-12)
    springs = curves.springs()
    force, depth = springs["force"].to_numpy(), springs["compression"].to_numpy()
    assert (force[:, depth > 0] >= 0).all()
    assert -0.6 - 1e-12 <= force.min() < 0
    assert (springs["stiffness"].to_numpy() >= 0).all()
