"""From settings to roughness springs."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation, assembly
from tyrecontact.parts.road import Road

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


def small(**numerics: object) -> Scenario:
    return Scenario(road=ROAD, numerics={"lags": 16, **numerics})


def test_springs_follow_the_modulus_and_the_exchange() -> None:
    scenario = small()
    patch, depth = assembly.road_patch(scenario.road), np.full(36, 9e-6)
    force = assembly.roughness_springs(patch, scenario).force(depth)
    scenario.springs.youngs_modulus *= 2
    doubled = assembly.roughness_springs(patch, scenario).force(depth)
    np.testing.assert_allclose(doubled, 2 * force, rtol=1e-12)  # rounding
    scenario.springs.exchange_count = 10
    softer = assembly.roughness_springs(patch, scenario).force(depth)
    assert np.sum(softer != doubled) == 10
    assert softer.max() < doubled.max()


@pytest.mark.parametrize(
    "change",
    [
        {"punch": "no-slip"},
        {"reading": "secant"},
        {"smoothing": "polynomial"},
        {"simplification": "mean"},
        {"simplification": "standard"},
        {"simplification": "linear"},
        {"exchange_count": 10},
    ],
    ids=lambda change: next(iter(change.values())),
)
def test_every_kind_of_spring_runs_to_the_end(quick: Scenario, change: dict[str, object]) -> None:
    plain = Simulation(quick)
    for name, value in change.items():
        quick.set(f"springs.{name}", value)
    simulation = Simulation(quick)
    delta = np.full(36, 9e-6)
    assert np.any(simulation.springs.force(delta) != plain.springs.force(delta))
    results = simulation.run()
    assert results.converged.all()
    assert len(results.contact_force) == len(simulation)
    assert np.all(np.diff(results.contact_force) > 0)


@pytest.mark.parametrize(
    ("first", "then"),
    [
        (
            {"simplification": "standard", "standard_count": 2},
            {"simplification": "standard", "standard_count": 5},
        ),
        (
            {"simplification": "linear", "linear_compression": 5e-6},
            {"simplification": "linear", "linear_compression": 2e-5},
        ),
        (
            {"exchange_count": 6, "exchange_compression": 1e-6},
            {"exchange_count": 6, "exchange_compression": 1e-4},
        ),
        (
            {"exchange_count": 6, "exchange_compression": 2e-6},
            {
                "exchange_count": 6,
                "exchange_compression": 2e-6,
                "exchange_ranking": "stiffness",
            },
        ),
    ],
)
def test_what_refines_a_kind_of_spring_matters(
    first: dict[str, object], then: dict[str, object]
) -> None:
    patch, delta = assembly.road_patch(Road(**ROAD)), np.full(36, 9e-6)
    force = [
        assembly.roughness_springs(patch, Scenario(road=ROAD, springs=springs)).force(delta)
        for springs in (first, then)
    ]
    assert np.any(force[0] != force[1])
