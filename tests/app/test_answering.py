"""What a visitor does is answered under the document's lock, and holds nobody."""

from __future__ import annotations

import asyncio
import gc
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
    """A connection whose writes end when the test says so."""

    def __init__(self) -> None:
        self.got: list[Any] = []
        self.ends: list[asyncio.Future[None]] = []
        self._socket = self
        self.protocol = SimpleNamespace(create=lambda _, events: events)

    def write(self, events: list[Any]) -> list[asyncio.Future[None]]:
        self.got += [event.msg_data for event in events]
        self.ends.append(asyncio.get_running_loop().create_future())
        return self.ends[-1:]


def test_what_comes_while_the_last_writing_ends_is_written_too(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def write(browser: _Browser, events: Any = None, msg: Any = None) -> list[Any]:
        return browser.write(events or msg)

    async def frames() -> None:
        for frame in ("the last but one", "the last"):
            event = MessageSentEvent(document, "frame", frame)
            panel_document.schedule_write_events(document, [browser], [event])
            if frame != "the last":
                while not browser.ends:
                    await asyncio.sleep(0)
                browser.ends[0].set_result(None)  # its writer goes on before the next one begins
        for _ in range(10):
            await asyncio.sleep(0)

    document, browser = Document(), _Browser()
    monkeypatch.setitem(panel_document.extra_socket_handlers, _Browser, write)
    with set_curdoc(document):
        asyncio.run(frames())
    assert browser.got == ["the last but one", "the last"]
