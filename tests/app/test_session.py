"""One visitor without a browser: the frames are called by hand."""

from __future__ import annotations

import time
from types import SimpleNamespace

import numpy as np
import panel as pn
import pytest

from app import links
from app.limits import Limits
from app.phase import Phase
from app.session import Session
from app.views import inputs, trace
from app.views.style import DESK, HALL
from tests.app.frames import frame, frames_until_step, frames_until_the_end
from tyrecontact import Scenario, presets


def test_a_run_is_drawn_row_by_row_to_its_end(session: Session) -> None:
    session.start()
    frames_until_the_end(session)
    assert session.run.phase is Phase.FINISHED
    force = session.run.results().contact_force
    np.testing.assert_array_equal(session.live.force.source.data["force"], force)
    assert len(session.live.iterations.source.data["iterations"]) == len(force)
    assert len(session.live.iterations.margin.data["margin"]) == len(force)
    assert session.headline.root.state["progress"] == 1.0
    assert session.header.stop.disabled
    assert session.header.pause.disabled


def test_a_run_with_more_than_is_kept_and_drawn_is_shown_to_its_end(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace, "POINTS", 20)
    session.controls.change("numerics.field_memory", 10 * 36 * 33.0)  # of 52 steps
    session.start()
    frames_until_the_end(session)
    record, results = session.run.record, session.run.results()
    assert record.field_stride > 1
    force = np.asarray(session.live.force.source.data["force"])
    assert len(force) <= 22
    assert (force.max(), force[-1]) == (results.contact_force.max(), results.contact_force[-1])
    assert session.headline.sentence == f"Complete, {record.count} steps: all converged."


def test_nothing_is_sent_to_a_browser_that_does_not_keep_up(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.start()
    frames_until_step(session, 2)
    session.browser.shown = -5
    session.browser.send_frame()
    drawn = len(session.live.force.source.data["force"])
    time.sleep(1.0)
    session.browser._sent = time.monotonic()
    session.frame()
    assert len(session.live.force.source.data["force"]) == drawn
    frame(session)
    assert len(session.live.force.source.data["force"]) > drawn
    session.close()


def test_a_second_run_supersedes_the_first_and_nothing_of_it_is_drawn(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.start()
    first = session.run
    frames_until_step(session, 2)
    session.whatif.pace.value = "as fast as it can"
    session.controls.change("loading.max_indentation", 0.05e-3)
    session.start()
    frames_until_the_end(session)
    assert first.join(10)
    assert first.phase is Phase.STOPPED
    drawn = np.asarray(session.live.force.source.data["indentation_um"])
    np.testing.assert_allclose(drawn, session.run.results().indentation * 1e6)


def test_live_runs_every_change_and_ends_with_the_last_one(session: Session) -> None:
    session.whatif.live.value = True
    for rate in (0.08, 0.06, 0.05):
        session.controls.field("loading.rate").root.value = rate * 1e3
    assert session.run.scenario.loading.rate == pytest.approx(0.05)
    frames_until_the_end(session)
    assert session.run.baseline is not None
    assert len(session.live.force.baseline.data["force"]) > 0
    session.whatif.live.value = False
    run = session.run
    session.controls.change("loading.rate", 0.1)
    assert session.run is run


def test_pause_step_go_on_and_stop(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.step()
    frames_until_step(session, 1)
    assert session.run.phase is Phase.PAUSED
    assert session.run.record.count == 1
    frame(session)
    assert session.header.pause.description == "Go on (Space)"
    session.step()
    frames_until_step(session, 2)
    session.toggle()
    frames_until_step(session, 4)
    session.toggle()
    while session.run.phase is not Phase.PAUSED:
        time.sleep(0.005)
    session.stop()
    assert session.run.join(10)
    frame(session)
    assert session.run.phase is Phase.STOPPED
    assert len(session.live.force.source.data["force"]) == session.run.record.count
    assert "Stopped at step" in session.headline.sentence


def test_keys_do_what_the_buttons_do(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    for key, phase in (
        ("Space", Phase.RUNNING),
        ("Space", Phase.PAUSED),
        ("Escape", Phase.STOPPED),
    ):
        session.browser.on_key(key)
        limit = time.monotonic() + 30
        while session.run.phase is not phase:
            assert time.monotonic() < limit
            time.sleep(0.005)
        frames_until_step(session, 1)
    session.browser.on_key("ArrowLeft")
    assert session.live.player.step == max(session.run.record.count - 2, 0) or (
        session.run.record.count == 1
    )
    session.browser.on_key("End")
    assert session.live.player.step is None
    session.controls.change("loading.rate", 0.2)
    session.browser.on_key("Undo")
    assert session.controls.value("loading.rate") == 0.1
    session.browser.on_key("no such key")


def test_scrubbing_shows_another_map_and_marks_the_place(session: Session) -> None:
    session.start()
    frames_until_the_end(session)
    newest = session.live.contact_map.drawing.image.data
    session.live.player.scrub(10)
    assert session.live.contact_map.drawing.image.data is not newest
    place = session.run.record.columns["indentation"][10] * 1e6
    assert session.live.force.cursor.location == pytest.approx(place)
    session.live.player.follow()
    assert not session.live.force.cursor.visible


def test_leaving_ends_the_run(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.start()
    run = session.run
    session.close()
    assert run.join(10)
    assert run.phase is Phase.STOPPED
    session.frame()  # a last tick of the clock finds nothing to draw


def test_what_is_refused_during_a_run_stays_to_be_read(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.start()
    frames_until_step(session, 2)
    session.controls.change("tread.thickness", -1.0)
    frame(session)
    assert "tread.thickness must be" in session.headline.notice
    session.controls.change("tread.thickness", 11e-3)
    frame(session)
    assert session.headline.notice == ""
    session.close()


def test_a_run_that_is_refused_says_why_and_the_next_one_works(session: Session) -> None:
    session.controls.change("springs.exchange_count", 100)  # of 36 springs
    session.start()
    frames_until_the_end(session)
    assert session.run.phase is Phase.REFUSED
    asked = "springs.exchange_count must be at most half the elements, 18, got 100"
    assert asked in session.headline.sentence
    session.controls.change("springs.exchange_count", 4)
    session.start()
    frames_until_the_end(session)
    assert session.run.phase is Phase.FINISHED


def test_a_preset_chosen_changes_form_caption_and_axis(session: Session) -> None:
    session.load_preset("adhesion")
    assert session.controls.scenario.loading.profile == "load-hold-unload"
    assert "pulled off" in session.whatif.caption.object
    assert session.live.axis.value == "time"
    assert session.header.preset.label == "adhesion"


def test_presentation_mode_enlarges_the_type_and_goes_back(session: Session) -> None:
    told: list[bool] = []
    session.on_present = told.append
    session.browser.on_key("p")
    assert session.live.force.root.title.text_font_size == f"{HALL.title}px"
    session.browser.on_key("p")
    assert session.live.force.root.title.text_font_size == f"{DESK.title}px"
    assert told == [True, False]


def test_a_tab_that_tells_of_the_form_follows_it(session: Session) -> None:
    session.tabs.open("Code")
    session.controls.change("loading.rate", 0.123)
    assert "0.123" in session.tabs.made("Code")._view.texts["Python"]


def test_a_link_is_seen_on_the_axis_that_suits_its_loading(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    search = "?v=1&p=default&" + links.query("default", _returning()).split("&", 2)[2]
    monkeypatch.setattr(type(pn.state), "location", SimpleNamespace(search=search))
    assert Session().live.axis.value == "time"


def _returning() -> Scenario:
    scenario = presets.get("default")
    scenario.set("loading.profile", "load-hold-unload")
    return scenario


def test_inputs_are_not_prepared_beyond_the_limits(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(inputs, "limits", lambda: Limits(elements=2))
    session.tabs.open("Inputs")
    view = session.tabs.made("Inputs")._view
    view.worker.join(20)
    view.arrive()
    assert "must be at most 2 on this server" in view.text.object
