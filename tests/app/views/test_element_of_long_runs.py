"""The followed element where a run has more maps than are kept."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from app.runner import Run
from app.views.element import ElementView
from tyrecontact import Scenario, Simulation
from tyrecontact.results import Record

ROW, COLUMN = 2, 3
#: for the maps of 10 of 52 steps [B]
MEMORY = 10 * 36 * 33.0


def test_a_run_whose_maps_are_thinned_is_followed_at_the_steps_kept(small: Scenario) -> None:
    small.numerics.field_memory = MEMORY
    run = Run(small)
    run.start()
    assert run.join(60)
    view = ElementView()
    view.prepare(run)
    view.update(run, 42, ended=True)
    view.follow(ROW, COLUMN)
    kept = [0, 8, 16, 24, 32, 40, 48, 51]
    times = run.record.columns["time"]
    np.testing.assert_allclose(view.forces.path.data["time_ms"], times[kept] * 1e3)
    assert view.forces.now.data["time_ms"] == [pytest.approx(times[40] * 1e3)]


def test_a_run_that_is_thinned_while_it_goes_on_is_followed_to_its_newest_step(
    small: Scenario,
) -> None:
    simulation = Simulation(small)
    record = Record(len(simulation), simulation.bodies.kernel.shape, MEMORY)
    run, view = SimpleNamespace(record=record, simulation=simulation, scenario=small), ElementView()
    view.prepare(run)
    view.follow(ROW, COLUMN)
    for step in simulation:
        record.append(step)
        view.update(run, record.count - 1, ended=False)
        newest = record.columns["time"][record.count - 1]
        assert view.forces.path.data["time_ms"][-1] == pytest.approx(newest * 1e3)
