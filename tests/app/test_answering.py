"""What a visitor does is answered under the document's lock, and holds nobody."""

from __future__ import annotations

import gc
from types import SimpleNamespace
from weakref import ref

import panel as pn
import panel_material_ui as pmui
from bokeh.document import Document
from bokeh.events import ButtonClick
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
