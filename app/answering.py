"""How what a visitor does reaches a session: when the page is there, under the document's lock, and
without holding what the visitor has left; and that the answer reaches the visitor.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any
from weakref import WeakMethod

import panel as pn
from bokeh.document import Document
from panel.io import document
from panel.io.document import with_lock
from panel.reactive import Syncable
from tornado.websocket import WebSocketClosedError

# Panel takes a press, and with it any change of the last 50 ms, without the document's lock, which
# every change of a plot needs
Syncable._event_coroutine = with_lock(Syncable._event_coroutine)  # type: ignore[method-assign]

_dispatch = document._dispatch_msgs


async def _dispatch_all(doc: Document) -> None:
    """Write to the browser what waits for it.

    Panel's writer believes that nothing waits if the one before it ends just when more has come.
    That would be left behind until the next change; the last frame of a run, for good.
    """
    document._WRITE_BLOCK[doc] = True
    with suppress(WebSocketClosedError):  # the visitor has left
        await _dispatch(doc)


document._dispatch_msgs = _dispatch_all


def pressing(action: Callable[[], None]) -> Callable[[Any], None]:
    """What a button calls: a change while the page is being loaded may never reach the browser."""
    return lambda _: pn.state.onload(action)


def weakly(method: Callable[[], None]) -> Callable[[], None]:
    """A method that does not keep its object: a document that is gone keeps its callbacks, and
    Panel may keep the document.
    """
    known = WeakMethod(method)

    def call() -> None:
        if (found := known()) is not None:
            found()

    return call
