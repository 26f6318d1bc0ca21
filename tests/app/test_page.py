"""The page's wiring without a browser: the frames are called by hand."""

from __future__ import annotations

import time

import numpy as np
import pytest

from app.page import Session
from app.runner import Phase
from app.views import trace
from tyrecontact import Scenario


@pytest.fixture
def session(small: Scenario) -> Session:
    made = Session()
    made.controls.load(small)
    made.pace.value = "as fast as it can"
    return made


def _frames_until_the_end(session: Session) -> None:
    limit = time.monotonic() + 60
    while not session.run.phase.ended:
        session.frame()
        time.sleep(0.01)
        assert time.monotonic() < limit
    session.frame()


def test_a_run_is_drawn_row_by_row_to_its_end(session: Session) -> None:
    session.start()
    _frames_until_the_end(session)
    assert session.run.phase is Phase.FINISHED
    force = session.run.results().contact_force
    np.testing.assert_array_equal(session.force.source.data["force"], force)
    assert len(session.iterations.source.data["iterations"]) == len(force)
    assert session.progress.value == 100
    assert session.stop_button.disabled


def test_a_run_with_more_than_is_kept_and_drawn_is_shown_to_its_end(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace, "POINTS", 20)
    session.controls.widgets["numerics.field_memory"].value = 10 * 36 * 33e-6  # MB, of 52 steps
    session.start()
    _frames_until_the_end(session)
    record, results = session.run.record, session.run.results()
    assert record.field_stride > 1
    force = np.asarray(session.force.source.data["force"])
    assert len(force) <= 22
    assert (force.max(), force[-1]) == (results.contact_force.max(), results.contact_force[-1])
    drawn = session.contact_map.drawing.image.data["value"][0]
    last = record.fields(-1)[1]["element_force"]
    np.testing.assert_allclose(drawn[last > 0], last[last > 0], rtol=1e-6)
    assert session.headline.sentence == f"Complete, {record.count} steps: all converged."


def test_a_second_run_supersedes_the_first_and_nothing_of_it_is_drawn(session: Session) -> None:
    session.pace.value = "in about 20 s"
    session.start()
    first = session.run
    time.sleep(0.5)
    session.frame()
    session.pace.value = "as fast as it can"
    session.controls.widgets["loading.max_indentation"].value = 0.05
    session.start()
    _frames_until_the_end(session)
    assert first.join(10)
    assert session.run is not first
    drawn = np.asarray(session.force.source.data["indentation_um"])
    np.testing.assert_allclose(drawn, session.run.results().indentation * 1e6)


def test_stop_keeps_what_was_drawn(session: Session) -> None:
    session.pace.value = "in about 20 s"
    session.start()
    while session.run.record is None or session.run.record.count < 2:
        time.sleep(0.01)
    session.stop()
    assert session.run.join(10)
    session.frame()
    assert session.run.phase is Phase.STOPPED
    assert len(session.force.source.data["force"]) == session.run.record.count
    assert "Stopped at step" in session.headline.sentence


def test_leaving_ends_the_run(session: Session) -> None:
    session.pace.value = "in about 20 s"
    session.start()
    run = session.run
    session.close()
    assert run.join(10)
    assert run.phase is Phase.STOPPED
    session.frame()  # a last tick of the clock finds nothing to draw


def test_what_is_refused_during_a_run_stays_to_be_read(session: Session) -> None:
    session.pace.value = "in about 20 s"
    session.start()
    while session.run.record is None or session.run.record.count < 2:
        time.sleep(0.01)
    session.controls.widgets["tread.thickness"].value = -1.0
    session.frame()
    assert "tread.thickness must be" in session.headline.root.object
    session.controls.widgets["tread.thickness"].value = 11.0
    session.frame()
    assert "tread.thickness" not in session.headline.root.object
    session.stop()
    assert session.run.join(10)


def test_a_run_that_is_refused_says_why_and_the_next_one_works(session: Session) -> None:
    session.controls.widgets["springs.exchange_count"].value = 100  # of 36 springs
    session.start()
    _frames_until_the_end(session)
    assert session.run.phase is Phase.REFUSED
    assert (
        "springs.exchange_count must be at most half the elements, 18, got 100"
        in session.headline.sentence
    )
    session.controls.widgets["springs.exchange_count"].value = 4
    session.start()
    _frames_until_the_end(session)
    assert session.run.phase is Phase.FINISHED


def test_a_preset_chosen_on_the_page_changes_form_caption_and_axis(session: Session) -> None:
    session.preset.value = "adhesion"
    assert session.controls.scenario.loading.profile == "load-hold-unload"
    assert "pulled off" in session.caption.object
    assert session.axis.value == "time"
