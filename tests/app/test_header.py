"""The header: what can be pressed when."""

from __future__ import annotations

from app.header import Header
from app.runner import Phase, Run
from tyrecontact import Scenario


def test_before_a_run_there_is_nothing_to_pause_or_stop() -> None:
    header = Header()
    header.update(None)
    assert header.pause.disabled
    assert header.stop.disabled
    assert not header.run.disabled
    assert not header.step.disabled


def test_a_run_can_be_paused_and_stopped_until_it_has_ended(small: Scenario) -> None:
    header, run = Header(), Run(small, 30.0, paused=True)
    run.start()
    header.update(run)
    assert not header.stop.disabled
    assert header.pause.description == "Go on (Space)"
    assert header.pause.icon == "play_arrow"
    run.resume()
    header.update(run)
    assert header.pause.description == "Pause (Space)"
    run.stop()
    assert run.join(30)
    header.update(run)
    assert header.pause.disabled
    assert header.stop.disabled


def test_a_phones_buttons_do_what_the_headers_do() -> None:
    header, pressed = Header(), []
    header.share.on_click(lambda _: pressed.append("share"))
    header.preset.on_click(lambda _: pressed.append("preset"))
    presets, share, _ = header.for_phones()
    share.param.trigger("clicks")
    presets.param.trigger("clicks")
    assert pressed == ["share", "preset"]


def test_a_run_that_is_only_compared_cannot_be_paused(finished: Run) -> None:
    header = Header()
    finished.phase = Phase.COMPARING
    header.update(finished)
    assert header.pause.disabled
    assert not header.stop.disabled
