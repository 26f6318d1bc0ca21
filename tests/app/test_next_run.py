"""What a run leaves to the next one, and what it must not."""

from __future__ import annotations

import gc
from weakref import ref

import numpy as np
import pytest

from app import baseline
from app.phase import Phase
from app.session import Session
from app.views.element_words import INVITATION, WAITING
from tests.app.frames import frame, frames_until_step, frames_until_the_end


def blow_up(session: Session) -> None:
    """Let the form stand for a run that fails."""
    for path, value in (
        ("loading.max_indentation", 200e-6), ("numerics.kernel", "band-limited"),
        ("numerics.solver", "thesis"), ("numerics.max_iterations", 10),
        ("numerics.initial_guess", "last"),
    ):  # fmt: skip
        session.controls.change(path, value)


def test_beside_a_run_that_is_refused_nothing_of_the_last_one_is_left(session: Session) -> None:
    blow_up(session)
    session.start()
    frames_until_the_end(session)
    live = session.live
    live.element.follow(2, 3)
    live.player.scrub(20)
    assert "not converged" in [entry.label for entry in live.legend.entries]
    assert live.force.cursor.visible
    assert live.iterations.cursor.visible
    assert len(live.element.forces.path.data["force"]) > 0
    session.controls.change("springs.exchange_count", 100)  # of 36 springs
    session.start()
    frames_until_the_end(session)
    assert session.run.phase is Phase.REFUSED
    assert "not converged" not in [entry.label for entry in live.legend.entries]
    assert not live.force.cursor.visible
    assert not live.iterations.cursor.visible
    plots = live.element.forces
    for source in (plots.path, plots.now, plots.curve, live.element.heights.touching):
        assert all(len(column) == 0 for column in source.data.values())
    assert live.element.sentence == WAITING.format(2, 3)
    live.element.chooser.buttons[0].param.trigger("clicks")
    assert live.element.sentence.startswith("Press Run first")


def test_the_element_is_followed_on_from_the_first_step_of_the_next_run(session: Session) -> None:
    session.start()
    frames_until_the_end(session)
    session.live.element.follow(2, 3)
    session.start(paused=True)
    session.step()
    frames_until_step(session, 1)
    frame(session)
    assert session.live.element.sentence.startswith("Element row 2, column 3: ")
    assert len(session.live.element.forces.path.data["force"]) == 1
    session.stop()
    session.run.join()


def test_a_frame_is_drawn_only_around_an_element_that_is_followed(session: Session) -> None:
    framed = session.live.contact_map.drawing.frame
    session.start()
    frames_until_the_end(session)
    session.live.element.follow(5, 5)
    assert len(framed.data["x"]) == 1
    for elements in (3, 6):  # the first has no such element, so that it is let go
        session.controls.change("road.elements", elements)
        session.start()
        frames_until_the_end(session)
        assert session.live.element.sentence == INVITATION
        assert len(framed.data["x"]) == 0


def test_a_quasi_static_run_that_comes_late_leaves_room_for_all_of_the_run(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(baseline, "kept", lambda _: None)
    blow_up(session)
    session.start(live=True)
    frames_until_the_end(session)
    force = session.run.record.columns["contact_force"]
    assert session.run.baseline.contact_force.max() * 1.1 < force.max()
    assert session.live.force.root.y_range.end >= force.max()
    assert session.live.force.root.y_range.start <= force.min()


def test_a_tab_may_be_open_while_a_live_run_has_no_quasi_static_one_yet(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(baseline, "kept", lambda _: None)
    session.tabs.open("Stiffness")
    session.whatif.pace.value = "in about 20 s"
    session.start(live=True)
    frames_until_step(session, 12)
    session.tabs.show(session.run)
    assert session.run.baseline is None
    assert "comes after the last step" in session.tabs.made("Stiffness").reading.sentence
    session.stop()
    frames_until_the_end(session)
    reading = session.tabs.made("Stiffness").reading
    assert "There is no quasi-static run" in reading.sentence
    assert np.isfinite(reading.plots["by depth"].dimension_values("y")).any()


def test_what_can_be_taken_away_follows_the_run(session: Session) -> None:
    session.load_preset("adhesion")
    session.dialogs.share()
    downloads = session.dialogs._downloads
    assert downloads.pictures["png"].tags == ["tyrecontact-adhesion"]  # of the inputs, say
    session.load_preset("default")
    session.controls.change("road.elements", 6)
    session.dialogs.share()
    session.whatif.pace.value = "as fast as it can"
    session.start()
    assert all(file.disabled for file in downloads.files.values())
    frames_until_the_end(session)
    assert not any(file.disabled for file in downloads.files.values())
    assert downloads.note.object == f"The run, {session.run.record.count} steps:"


def test_a_tab_that_is_not_looked_at_keeps_no_run_alive(session: Session) -> None:
    session.tabs.open("Compare")
    session.start()
    frames_until_the_end(session)
    before = ref(session.run)
    session.tabs.open("Watch")
    session.start()
    frames_until_the_end(session)
    gc.collect()
    assert before() is None
