"""The other side of the page: frames that keep pace with it, keys, and nothing it can break."""

from __future__ import annotations

import pytest

from app.browser import _AHEAD, Browser


def test_frames_wait_for_a_browser_that_does_not_keep_up() -> None:
    browser = Browser()
    sent = 0
    while browser.is_ready and sent < 10:
        browser.send_frame()
        sent += 1
    assert sent == _AHEAD
    browser._handle_msg({"shown": 1})
    assert browser.is_ready


def test_a_browser_that_says_nothing_gets_a_frame_now_and_then(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    browser = Browser()
    for _ in range(_AHEAD):
        browser.send_frame()
    assert not browser.is_ready
    monkeypatch.setattr(browser, "_sent", browser._sent - 2.0)
    assert browser.is_ready


def test_keys_and_width_are_handed_on() -> None:
    browser, keys, widths = Browser(), [], []
    browser.on_key, browser.on_width = keys.append, widths.append
    browser._handle_msg({"key": "Space"})
    browser._handle_msg({"width": 390, "address": "http://localhost:5006/app"})
    assert (keys, widths) == (["Space"], [390])
    assert browser.address == "http://localhost:5006/app"


@pytest.mark.parametrize(
    "message", [None, "text", 3, {}, {"shown": "many"}, {"key": 7}, {"shown": 10**9}, {"width": []}]
)
def test_no_message_does_harm(message: object) -> None:
    browser = Browser()
    browser._handle_msg(message)
    assert browser.shown <= browser.frame
