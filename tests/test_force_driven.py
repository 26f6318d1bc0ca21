"""Scenarios whose road is moved by a force or through a spring, from settings to results."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tyrecontact import Results, Scenario, Simulation
from tyrecontact.errors import InputError


def scenario(**loading: Any) -> Scenario:
    made = {"profile": "load-hold-unload", "hold_time": 2e-3, "max_indentation": 60e-6,
            "rate": 0.1, "unloading_rate": 0.1, "retraction": 1e-4}  # fmt: skip
    return Scenario(
        road={"elements": 4, "size": 4e-3, "pixel": 5e-5},
        loading={**made, **loading},
        adhesion={"release_force": 0.2},
        numerics={"lags": 32},
    )


def force_driven(**loading: Any) -> Scenario:
    made = {"drive": "force", "mass": 1e-3, "max_force": 5.0, "force_rate": 5e3,
            "unloading_force_rate": 5e3, "pull": 4.0}  # fmt: skip
    return scenario(**{**made, **loading})


def run(question: Scenario) -> Results:
    return Simulation(question).run()


def test_a_slow_force_is_borne_by_the_contact() -> None:
    """Once the mass has landed, it takes m d'' only: little of a slow ramp."""
    results = run(force_driven(profile="linear", force_rate=500.0))
    late = results.drive > 3
    np.testing.assert_allclose(results.contact_force[late], results.drive[late], rtol=5e-3)
    assert np.all(np.diff(results.indentation[late]) > 0)


def test_a_force_that_pulls_harder_than_the_bonds_takes_the_road_away() -> None:
    results = run(force_driven())
    assert results.stop_reason == "completed"
    assert results.contacts[-1] == 0
    assert results.releases.sum() > 5
    adherence = results.adherence_force
    assert adherence is not None
    # pulled as hard as the bonds bear, and by the mass that is already moving
    assert adherence > 0.3
    after = results.indentation[results.contacts == 0]
    assert after[-1] < -1e-4


def test_a_machine_indents_less_than_its_end_moves() -> None:
    rigid, machine = run(scenario()), run(scenario(drive="machine", machine_stiffness=1e5))
    np.testing.assert_array_equal(machine.drive, rigid.indentation)
    stretch = machine.drive - machine.indentation
    # k_m (X - d) = F without a mass
    np.testing.assert_allclose(1e5 * stretch, machine.contact_force, atol=1e-7)
    assert machine.indentation.max() < 0.9 * rigid.indentation.max()


def test_the_stiffest_machine_is_a_rigid_one() -> None:
    rigid, stiff = run(scenario()), run(scenario(drive="machine", machine_stiffness=1e12))
    # 10 N on 1e12 N/m is 1e-11 m, on contacts of 1e5 N/m
    np.testing.assert_allclose(stiff.contact_force, rigid.contact_force, atol=1e-5)
    np.testing.assert_allclose(stiff.indentation, rigid.indentation, atol=1e-10)


def test_a_swinging_machine_begins_at_rest_above_the_road() -> None:
    """Its mass is where the swing begins, and is not struck there."""
    swing: dict[str, Any] = {"profile": "sinusoidal", "period": 20e-3, "retraction": 5e-5}
    heavy = run(scenario(**swing, drive="machine", machine_stiffness=1e6, mass=0.01))
    assert heavy.indentation[0] == pytest.approx(-5e-5, rel=1e-9)
    assert np.abs(np.diff(heavy.indentation[:5])).max() < 2e-8
    rigid = run(scenario(**swing))
    assert rigid.indentation[0] == -5e-5
    assert rigid.drive_work[0] == 0
    # 100 cycles of its own a period, the stretch aside
    assert heavy.indentation.max() == pytest.approx(rigid.indentation.max(), rel=0.2)


def test_a_swinging_force_begins_at_none_and_ends_pulling() -> None:
    results = run(force_driven(profile="sinusoidal", period=10e-3))
    assert (results.drive[0], results.drive[-1]) == (0.0, -4.0)
    assert results.drive.max() == 5.0
    assert results.contact_force.max() == pytest.approx(5.0, rel=0.05)
    assert results.contacts[-1] == 0


@pytest.mark.parametrize(
    ("loading", "sentence"),
    [
        ({"drive": "force"}, "loading.mass must be positive for a force-driven road, got 0 kg"),
        ({"drive": "force", "mass": 1.0, "profile": "quadratic"}, "loading.profile must be linear"),
        ({"profile": "table"}, "loading.table must name a file for the profile table, got none"),
    ],
)
def test_what_cannot_be_driven_is_refused_before_anything_is_computed(
    loading: dict[str, Any], sentence: str
) -> None:
    with pytest.raises(InputError, match=f"^{sentence}"):
        Simulation(scenario(**loading))


def table(tmp_path: Path, text: str) -> str:
    file = tmp_path / "path.txt"
    file.write_text(text)
    return str(file)


def test_a_table_of_the_users_own_is_followed(tmp_path: Path) -> None:
    file = table(tmp_path, "0 0\n1e-3 6e-5\n2e-3 6e-5\n4e-3 -1e-4\n")
    results = run(scenario(profile="table", table=file))
    expected = np.interp(results.time, [0, 1e-3, 2e-3, 4e-3], [0, 6e-5, 6e-5, -1e-4])
    # knots are moved to the nearest step, half of one at 0.08 m/s
    np.testing.assert_allclose(results.indentation, expected, atol=0.08 / 51200)
    assert results.contacts[-1] == 0


@pytest.mark.parametrize(
    ("text", "drive", "sentence"),
    [
        ("0 0\n1e-2 -1e-5\n", "rigid", "must reach contact, got a profile of at most 0 m"),
        ("0 -1\n1e-2 -2\n", "force", "must reach contact, got a profile of at most -1 N"),
        ("0 0\n1e-2 0.05\n", "rigid", r"table must stay below tread.thickness, 0.01 m, got 0.05 m"),
        ("0 0\n1e5 1e-5\n", "rigid", "must take 3 to 500000 steps"),
    ],
)
def test_tables_that_go_nowhere_or_too_far_are_refused(
    tmp_path: Path, text: str, drive: str, sentence: str
) -> None:
    question = scenario(profile="table", table=table(tmp_path, text), drive=drive, mass=1.0)
    with pytest.raises(InputError, match=f"^loading[. ]{sentence}"):
        Simulation(question)


def test_rates_that_never_reach_contact_are_refused() -> None:
    with pytest.raises(InputError, match=r"^loading must take 3 to 500000 steps, got \d+ \(20 s"):
        Simulation(scenario(profile="linear", rate=1e-4, max_indentation=2e-3))


@pytest.mark.parametrize("law", ["hysteresis", "receding-contact"])
def test_punches_of_frozen_area_need_tangent_springs(law: str) -> None:
    question = scenario()
    question.adhesion.law, question.springs.reading = law, "secant"
    with pytest.raises(
        InputError, match=f"springs.reading must be tangent for .* {law}, got secan"
    ):
        Simulation(question)
    question.adhesion.law = "bonds"
    assert Simulation(question)


def test_the_quasi_static_companion_of_a_driven_road_is_in_equilibrium() -> None:
    machine = Simulation(scenario(drive="machine", machine_stiffness=1e5, mass=0.01))
    still = machine.quasi_static(40).run()
    assert still.stop_reason == "completed"
    # k_m (X - d) = F, whatever the mass; the companion is solved to 6e-12 m
    np.testing.assert_allclose(
        1e5 * (still.drive - still.indentation), still.contact_force, atol=1e-5
    )
    force = Simulation(force_driven(mass=0.01)).quasi_static(60).run()
    pressed = (force.drive > 1) & (np.diff(force.drive, prepend=0.0) > 0)
    # a step at rest is as if a dashpot of 1e4 N/m held the road, on contacts of 1e5 N/m
    np.testing.assert_allclose(force.contact_force[pressed], force.drive[pressed], rtol=0.1)
