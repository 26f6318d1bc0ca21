"""The loading that goes into a run: all its steps, in the units of its drive."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.views.input_loading import LoadingInput
from app.views.style import DESK
from tyrecontact import Scenario, Simulation


def test_all_steps_are_drawn_with_their_rate(small: Scenario) -> None:
    simulation = Simulation(small)
    loading = LoadingInput.of(simulation)
    curve, marks = loading.draw_drive(DESK).object
    np.testing.assert_allclose(curve["Time [ms]"], simulation.schedule.time * 1e3)
    np.testing.assert_allclose(curve["Indentation [µm]"], simulation.schedule.drive * 1e6)
    assert len(marks) == len(simulation)
    rate = loading.draw_rate(DESK).object
    np.testing.assert_allclose(rate["Rate [mm/s]"], 100, rtol=0.02)
    # not a picture of the rounding of a constant
    axis = loading.draw_rate(DESK).get_root().children[0].y_range
    assert axis.start < 0
    assert axis.end > 100
    assert loading.facts["Steps"] == str(len(simulation))
    assert loading.facts["Time step"] == "19.5 µs"
    assert loading.facts["Largest"] == "100 µm"
    assert "Fastest unloading" not in loading.facts


@pytest.mark.parametrize(
    ("settings", "label", "unit"),
    [
        ({"drive": "machine"}, "Far end of the machine's spring [µm]", "mm/s"),
        ({"drive": "force", "mass": 0.1, "profile": "sinusoidal"}, "Force on the mass [N]", "N/ms"),
    ],
)
def test_units_are_those_of_the_drive(
    small: Scenario, settings: dict, label: str, unit: str
) -> None:
    small.loading.param.update(**settings)
    loading = LoadingInput.of(Simulation(small))
    drawn = loading.draw_drive(DESK).object
    first = drawn.get(0) if hasattr(drawn, "get") else drawn
    assert str(first.vdims[0]) == label
    assert str(loading.draw_rate(DESK).object.vdims[0]) == f"Rate [{unit}]"
    assert loading.sheet().caption


def test_a_long_hold_is_told_and_drawn_in_seconds(small: Scenario) -> None:
    small.loading.param.update(profile="load-hold-unload", hold_time=30.0, rate=1.0)
    loading = LoadingInput.of(Simulation(small))
    assert loading.facts["Duration"].endswith(" s")
    assert int(loading.facts["Steps of a long hold, at rest"]) == loading.at_rest.sum() > 10
    assert "Fastest unloading" in loading.facts
    drawn = loading.draw_drive(DESK).object
    assert [layer.label for layer in drawn][-1] == "step at rest"
    assert str(drawn.get(0).kdims[0]) == "Time [s]"


def test_a_long_table_is_thinned(small: Scenario, tmp_path: Path) -> None:
    path = tmp_path / "table.txt"
    path.write_text("0 0\n0.2 1e-4\n", encoding="utf-8")
    small.loading.param.update(profile="table", table=str(path))
    loading = LoadingInput.of(Simulation(small))
    assert loading.time.size > 10_000
    assert len(loading.draw_drive(DESK).object) < 1000
    assert len(loading.draw_rate(DESK).object) < 1000
