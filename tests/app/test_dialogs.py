"""Dialogs: presets, what can be taken away, help."""

from __future__ import annotations

import pytest

from app.browser import Browser
from app.controls import Controls
from app.dialogs import Dialogs


@pytest.fixture
def chosen() -> list[str]:
    return []


@pytest.fixture
def dialogs(chosen: list[str]) -> Dialogs:
    controls, browser = Controls(lambda _: None, lambda _: None), Browser()
    browser.address = "http://localhost:5006/app"
    controls.change("loading.rate", 0.05)
    return Dialogs(controls, browser, chosen.append, lambda: ("default", None))


def test_a_preset_that_is_chosen_is_handed_on_and_the_dialog_closes(
    dialogs: Dialogs, chosen: list[str]
) -> None:
    dialogs.presets()
    assert dialogs.root.open
    assert dialogs.root.title == "Presets"
    dialogs.root.objects[0].value = "adhesion"
    assert chosen == ["adhesion"]
    assert not dialogs.root.open


def test_the_link_is_the_pages_address_and_what_differs(dialogs: Dialogs) -> None:
    dialogs.share()
    link = dialogs.root.objects[0].value
    assert link.startswith("http://localhost:5006/app?v=1&p=default&")
    assert "=0.05" in link


def test_whether_copying_worked_is_said(dialogs: Dialogs) -> None:
    dialogs.share()
    note = dialogs.root.objects[2]
    dialogs._browser._handle_msg({"copied": True})
    assert note.object == "Copied."
    dialogs._browser._handle_msg({"copied": False})
    assert "by hand" in note.object


def test_help_names_the_keys(dialogs: Dialogs) -> None:
    dialogs.help()
    assert "Ctrl+Z" in dialogs.root.objects[0].object
