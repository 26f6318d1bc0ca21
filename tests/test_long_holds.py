"""Holds at rest: the same as step by step, for a road that is held, pressed by a spring or a force.

The tread forgets in 32 steps, so that a hold of 15 ms is a long one: it goes on at rest after 64
steps, and agrees with one of 768. What differs then is what Newton's tolerance of 1e-14 m leaves on
springs of up to 1e6 N/m.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tyrecontact import Results, Scenario, Simulation

Pair = tuple[Results, Results]
FORCE = {
    "drive": "force", "mass": 1e-3, "max_force": 3.0, "force_rate": 6e3,
    "unloading_force_rate": 6e3, "pull": 5.0,
}  # fmt: skip
DRIVES: dict[str, dict[str, Any]] = {
    "rigid": {},
    "machine": {"drive": "machine", "machine_stiffness": 1e5},
    "force": FORCE,
}


@pytest.fixture(scope="module")
def both() -> Callable[..., Pair]:
    """The same run with its hold step by step and at rest."""

    def run(law: str, **loading: Any) -> Pair:
        scenario = Scenario(
            road={"elements": 4, "size": 4e-3, "pixel": 5e-5},
            loading={
                "max_indentation": 60e-6, "rate": 0.1024, "profile": "load-hold-unload",
                "hold_time": 0.015, "unloading_rate": 0.1, "retraction": 1e-4, **loading,
            },
            adhesion={"law": law, "release_force": 0.2, "bond_stress": 5e5, "binding_rate": 100},
            numerics={"lags": 32},
        )  # fmt: skip
        found = []
        for holds in ("stepped", "quasi-static"):
            scenario.numerics.long_holds = holds
            found.append(Simulation(scenario).run())
        return found[0], found[1]

    return run


def end_of_hold(results: Results) -> int:
    return int(np.flatnonzero(results.drive == results.drive.max())[-1])


def assert_same(stepped: Results, still: Results) -> None:
    one, other = end_of_hold(stepped), end_of_hold(still)
    assert other < one / 3
    assert stepped.time[one] == pytest.approx(still.time[other], rel=1e-12)
    np.testing.assert_allclose(still.element_force[other], stepped.element_force[one], atol=1e-8)
    np.testing.assert_array_equal(still.age[other], stepped.age[one])  # in single precision
    # and so is all that follows
    np.testing.assert_allclose(still.contact_force[other:], stepped.contact_force[one:], atol=1e-7)
    assert still.releases.sum() == stepped.releases.sum() > 0


@pytest.mark.parametrize("drive", DRIVES)
def test_a_hold_at_rest_is_a_hold_step_by_step(both: Callable[..., Pair], drive: str) -> None:
    assert_same(*both("release-force", **DRIVES[drive]))


@pytest.mark.parametrize("law", ["bonds", "receding-contact"])
def test_bonds_and_ages_come_out_of_a_hold_the_same(both: Callable[..., Pair], law: str) -> None:
    assert_same(*both(law))


@pytest.mark.parametrize("drive", DRIVES)
def test_minutes_keep_the_forces_and_the_account(drive: str) -> None:
    scenario = Scenario(
        road={"elements": 4, "size": 4e-3, "pixel": 5e-5},
        loading={
            "max_indentation": 60e-6, "rate": 0.1024, "profile": "load-hold-unload",
            "hold_time": 960.0, "unloading_rate": 0.1, "retraction": 1e-4, **DRIVES[drive],
        },
        adhesion={"release_force": 0.2},
        numerics={"lags": 32},
    )  # fmt: skip
    results = Simulation(scenario).run()
    assert len(results) < 1500
    held = np.flatnonzero(results.drive == results.drive.max())
    late = results.contact_force[held[100:]]
    assert results.time[held[-1]] - results.time[held[0]] == pytest.approx(960, rel=1e-6)
    np.testing.assert_allclose(late, late[-1], rtol=1e-8)  # at rest, nothing moves
    if drive == "force":
        assert late[-1] == pytest.approx(3.0, rel=1e-8)
    account = results.energy
    scale = sum(abs(value) for value in account.values())
    assert abs(account["imbalance"]) < 1e-12 * scale  # rounding of the sums
    assert results.layer_work.min() >= 0
    # the tolerance of 6e-15 m on a force of 8 N
    assert np.diff(results.algorithmic_loss).min() > -6e-15 * 8
