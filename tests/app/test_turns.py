"""Words, iterations and map take turns; what a visitor does brings all of them at once."""

from __future__ import annotations

import time

import pytest

from app.phase import Phase
from app.session import Session
from app.views import trace
from tests.app.frames import frame, frames_until_step, frames_until_the_end, wait_for_step


def _parts(session: Session) -> tuple[str, int, object]:
    """What words, iterations and map show of a run: of which step each is."""
    live = session.live
    drawn = len(live.iterations.source.data["iterations"])
    return live.player.root.state["label"], drawn, live.contact_map._on_show


def test_words_iterations_and_map_each_come_within_three_frames(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.start()
    frames_until_step(session, 3)
    before = _parts(session)
    limit = time.monotonic() + 30
    count = session.run.record.count
    while session.run.record.count < count + 4:
        time.sleep(0.01)
        assert time.monotonic() < limit
    for _ in range(3):
        frame(session)
    assert all(now != then for now, then in zip(_parts(session), before, strict=True))
    session.stop()
    session.run.join()


def test_a_pause_a_step_and_an_end_bring_all_in_one_frame(session: Session) -> None:
    session.start(paused=True)
    limit = time.monotonic() + 30
    while session.run.phase is not Phase.PAUSED:
        time.sleep(0.005)
        assert time.monotonic() < limit
    for count in range(1, 6):
        session.step()
        frames_until_step(session, count)
        frame(session)
        label, drawn, (_, step) = _parts(session)
        assert label.startswith(f"step {count} of")
        assert (drawn, step) == (count, count - 1)
        assert f"step {count} " in session.headline.sentence
    session.stop()
    session.run.join()
    frame(session)
    assert "Stopped at step 5" in session.headline.sentence


def test_a_run_that_goes_on_says_so_in_its_next_frame(session: Session) -> None:
    session.whatif.pace.value = "in about 20 s"
    session.start(paused=True)
    session.step()
    frames_until_step(session, 1)
    limit = time.monotonic() + 30
    for _ in range(3):
        while session.run.phase is not Phase.PAUSED:
            time.sleep(0.005)
            assert time.monotonic() < limit
        frame(session)
        assert session.headline.sentence.startswith("Paused")
        session.pause()
        while session.run.phase is not Phase.RUNNING:
            time.sleep(0.005)
        frame(session)
        assert session.headline.sentence.startswith("Step ")
        session.pause()
    session.stop()
    session.run.join()


def test_the_mark_of_a_step_follows_the_choice_of_the_axis_after_the_end(session: Session) -> None:
    session.start()
    frames_until_the_end(session)
    session.live.player.scrub(30)
    results = session.run.results()
    for axis, values in (("time", results.time * 1e3), ("indentation", results.indentation * 1e6)):
        session.live.axis.value = axis
        assert session.live.force.cursor.location == pytest.approx(values[30])


def test_a_pause_draws_the_last_step_though_none_has_come_since_the_last_frame(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace, "POINTS", 12)  # so that the points of this run come by stretches
    session.start(paused=True)
    run, force, iterations = session.run, session.live.force, session.live.iterations
    for count in range(1, 28):
        session.step()
        wait_for_step(session, count)
        if count == 20:
            frame(session)
    with monkeypatch.context() as going_on:
        going_on.setattr(type(run), "paused", False)
        session.live.draw(run, False)
    time_now = run.record.columns["time"][26] * 1e3
    for shown in (force.source, iterations.source):
        assert shown.data["time_ms"][-1] < time_now
    session.live.draw(run, False)
    for shown in (force.source, iterations.source):
        assert shown.data["time_ms"][-1] == pytest.approx(time_now)
    session.stop()
    run.join()


def test_plots_are_cleared_by_a_frame_so_that_no_frame_of_the_last_run_comes_later(
    session: Session,
) -> None:
    session.start()
    frames_until_the_end(session)
    source = session.live.force.source
    before = source.data
    session.start(paused=True)
    assert source.data is before
    frame(session)
    assert len(source.data["force"]) == 0
    session.stop()
    session.run.join()


def test_a_run_that_was_superseded_before_its_first_frame_is_not_drawn(session: Session) -> None:
    session.start()
    frames_until_the_end(session)
    session.start(paused=True)
    superseded = session.run
    session.start(paused=True)
    session.step()
    frames_until_step(session, 1)
    superseded.join()
    assert len(session.live.force.source.data["force"]) == 1
    session.stop()
    session.run.join()
