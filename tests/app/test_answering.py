"""What a visitor does is answered under the document's lock, and holds nobody."""

from __future__ import annotations

import asyncio
import gc
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace
from typing import Any
from weakref import ref

import panel as pn
import panel_material_ui as pmui
import pytest
from bokeh.document import Document
from bokeh.document.events import MessageSentEvent
from bokeh.events import ButtonClick
from panel.io import document as panel_document
from panel.io.state import set_curdoc
from tornado.websocket import WebSocketClosedError

from app.answering import pressing, weakly


def test_a_press_that_follows_a_change_is_taken_under_the_lock() -> None:
    """Without it the change, which is run with the press, could not reach a plot."""
    document, button = Document(), pmui.Button(label="Run")
    document._session_context = lambda: SimpleNamespace(session=None)
    with set_curdoc(document):
        pn.state._change_callbacks[document] = {"change": lambda: None}
        button._server_event(document, ButtonClick(model=None))
    (waiting,) = document.session_callbacks
    assert not getattr(waiting.callback, "nolock", False)


def test_a_press_is_answered_at_once_where_the_page_is_there() -> None:
    pressed: list[str] = []
    pressing(lambda: pressed.append("Run"))(None)
    assert pressed == ["Run"]


class _Counted:
    def __init__(self) -> None:
        self.calls = 0

    def call(self) -> None:
        self.calls += 1


def test_a_callback_holds_nobody_and_does_nothing_afterwards() -> None:
    counted = _Counted()
    callback, held = weakly(counted.call), ref(counted)
    callback()
    assert counted.calls == 1
    del counted
    gc.collect()
    assert held() is None
    callback()


class _Browser:
    """A connection whose writes end when the test says so; one that has `left` takes none."""

    def __init__(self) -> None:
        self.left = False
        self.got: list[Any] = []
        self.ends: list[asyncio.Future[None]] = []
        self._socket = self
        self.protocol = SimpleNamespace(create=lambda _, events: events)

    def write(self, events: Any = None, msg: Any = None) -> list[asyncio.Future[None]]:
        if self.left:
            raise WebSocketClosedError
        self.got += [event.msg_data for event in events or msg]
        self.ends.append(asyncio.get_running_loop().create_future())
        return self.ends[-1:]


@pytest.fixture
def browser(monkeypatch: pytest.MonkeyPatch) -> _Browser:
    monkeypatch.setitem(panel_document.extra_socket_handlers, _Browser, _Browser.write)
    return _Browser()


def send(browser: _Browser, document: Document, frame: str) -> None:
    event = MessageSentEvent(document, "frame", frame)
    panel_document.schedule_write_events(document, [browser], [event])


def run(coroutine: Any) -> list[str]:
    """Complaints of a loop; on a thread, as that of a browser may be running on this one."""
    complaints: list[str] = []

    async def watched() -> None:
        asyncio.get_running_loop().set_exception_handler(
            lambda _, context: complaints.append(context["message"])
        )
        with set_curdoc(Document()):
            await coroutine
        gc.collect()  # a task that nobody asked for its error complains when it goes

    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, watched()).result()
    return complaints


def test_what_comes_while_the_last_writing_ends_is_written_too(browser: _Browser) -> None:
    async def frames() -> None:
        document = pn.state.curdoc
        send(browser, document, "the last but one")
        while not browser.ends:
            await asyncio.sleep(0)
        browser.ends[0].set_result(None)  # its writer goes on before the next one begins
        send(browser, document, "the last")
        for _ in range(10):
            await asyncio.sleep(0)

    assert run(frames()) == []
    assert browser.got == ["the last but one", "the last"]


def test_a_frame_for_a_visitor_who_has_left_is_let_go(browser: _Browser) -> None:
    async def frames() -> None:
        browser.left = True
        send(browser, pn.state.curdoc, "the last")
        for _ in range(10):
            await asyncio.sleep(0)

    assert run(frames()) == []
