"""How far the horizontal axis goes, before and after the quasi-static run is there."""

from __future__ import annotations

import numpy as np
import pytest

from app import baseline
from app.reach import Reach
from app.runner import Run
from app.session import Session
from app.views.style import EMPTY
from tests.app.frames import frame
from tyrecontact import Scenario


def forced(scenario: Scenario) -> None:
    """Pressed by a force: how deep that goes is not among the settings."""
    scenario.loading.param.update(drive="force", mass=1e-3, max_force=400.0, force_rate=4e5)


def test_before_a_run_there_is_an_axis_all_the_same() -> None:
    assert Reach().of(None) is EMPTY


def test_it_is_that_of_the_drive_until_the_quasi_static_run_is_there(finished: Run) -> None:
    reach, schedule = Reach(), finished.simulation.schedule
    np.testing.assert_array_equal(reach.of(finished), (schedule.time, finished.baseline.met))
    finished._computation.baseline = None
    np.testing.assert_array_equal(reach.of(finished), (schedule.time, schedule.drive))
    assert not reach.widen(finished, 0, finished.record.count)


def test_no_one_knows_how_deep_a_force_presses_so_it_grows_in_leaps(small: Scenario) -> None:
    forced(small)
    run, reach, leaps = Run(small), Reach(), 0
    run.start()
    assert run.join(60)
    known = run.baseline
    run._computation.baseline = None
    assert reach.of(run)[1] is EMPTY[1]
    depth = run.record.columns["indentation"]
    for count in range(1, run.record.count + 1):
        leaps += reach.widen(run, count - 1, count)
        assert reach.of(run)[1].max() >= depth[:count].max()
    assert 0 < leaps < 20
    assert reach.of(run)[1].max() < 3 * depth.max()
    run._computation.baseline = known
    assert not reach.widen(run, 0, run.record.count)
    reach.clear()
    run._computation.baseline = None
    assert reach.of(run)[1] is EMPTY[1]


def test_a_live_run_that_a_force_drives_is_drawn_as_wide_as_it_goes(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(baseline, "kept", lambda _: None)
    scenario = session.controls.scenario
    forced(scenario)
    session.controls.load("default", scenario)
    session.start(live=True)
    assert session.run.join(60)
    session.run._computation.baseline = None  # as while it goes on
    frame(session)
    span, depth = session.live.force.root.x_range, session.live.force.source.data["indentation_um"]
    assert 300 < max(depth) <= span.end < 3 * max(depth)
