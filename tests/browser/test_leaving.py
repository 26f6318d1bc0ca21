"""Closing the tab ends the run, and nothing of the visit is kept."""

from __future__ import annotations

import gc
import logging
import threading
import time
from collections.abc import Callable, Iterator
from weakref import WeakSet

import panel as pn
import panel_material_ui as pmui
import pytest
from bokeh.document import Document
from playwright.sync_api import Browser, BrowserContext

from app.page import lay_out
from app.session import Session
from tests.browser.serving import served

_VISITS = 20
_LOGS = ("asyncio", "bokeh", "panel", "tornado")
#: those that somebody still holds
_sessions: WeakSet[Session] = WeakSet()


def _build() -> pmui.Page:
    pn.config.respect_explicit_sizing = True
    session = Session()
    _sessions.add(session)
    return lay_out(session)


@pytest.fixture(scope="module")
def monkeypatch_module() -> Iterator[pytest.MonkeyPatch]:
    with pytest.MonkeyPatch.context() as patch:
        yield patch


@pytest.fixture(scope="module")
def address(monkeypatch_module: pytest.MonkeyPatch) -> Iterator[str]:
    """The page, which forgets a closed tab within a second or two."""
    # what pytest keeps of the log holds clicks and broken sockets, and they hold the page
    for name in _LOGS:
        monkeypatch_module.setattr(logging.getLogger(name), "level", logging.CRITICAL)
    with served(
        _build, unused_session_lifetime_milliseconds=500, check_unused_sessions_milliseconds=500
    ) as address:
        yield address


@pytest.fixture(scope="module")
def visitor(browser: Browser) -> Iterator[BrowserContext]:
    """One visitor with many tabs: the scripts of the page are loaded once."""
    context = browser.new_context()
    yield context
    context.close()


def _running() -> int:
    return sum(thread.name == "tyrecontact-run" for thread in threading.enumerate())


def _wait_for(condition: Callable[[], bool], seconds: float) -> bool:
    limit = time.monotonic() + seconds
    while not condition() and time.monotonic() < limit:
        time.sleep(0.1)
    return condition()


def _held(kind: type) -> int:
    gc.collect()
    if kind is Session:
        return len(_sessions)
    return sum(isinstance(thing, kind) for thing in gc.get_objects())


def test_closing_the_tab_ends_the_run(visitor: BrowserContext, address: str) -> None:
    tab = visitor.new_page()
    tab.goto(address)
    tab.get_by_role("combobox", name="Pace of a run").click()
    tab.get_by_role("menuitem", name="in about 20 s").click()
    tab.get_by_role("button", name="Run", exact=True).click()
    tab.get_by_role("status").filter(has_text="Step ").wait_for(timeout=60_000)
    assert _running() == 1
    tab.close()
    # the run has nearly 20 s to go: only the leaving can end it
    assert _wait_for(lambda: _running() == 0, 8)


def test_visits_leave_no_document_session_or_thread_behind(
    visitor: BrowserContext, address: str
) -> None:
    assert _wait_for(lambda: _held(Session) <= 1, 20)
    documents, threads = _held(Document), threading.active_count()
    for number in range(_VISITS):
        tab = visitor.new_page()
        with tab.expect_websocket(timeout=60_000):
            tab.goto(address)
        if number % 2 == 0:  # the others leave while the page is still put together
            tab.get_by_role("status").wait_for(timeout=60_000)
        if number % 5 == 0:
            tab.get_by_role("button", name="Run", exact=True).click()
            tab.get_by_role("tab", name="Inputs").click()
        tab.close()
    # Panel's own clean-up holds the first visit that was pressed, for as long as the server runs
    assert _wait_for(lambda: _held(Session) <= 1, 20), _held(Session)
    assert _wait_for(lambda: _held(Document) <= documents, 20), (documents, _held(Document))
    assert _wait_for(lambda: threading.active_count() <= threads, 20), threading.enumerate()
