"""The visitor's browser: what it has shown, which keys were pressed, what it is to copy."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from bokeh.document import Document
from bokeh.events import Event
from panel.custom import JSComponent
from panel.io.state import set_curdoc

#: frames that may be under way to the screen, so that neither side waits for the other
_AHEAD = 5
#: of so many frames the browser tells of one: each answer takes the solver's time
_ANSWERED = 3
#: seconds after which a browser that says nothing (a hidden tab) is sent a frame all the same
_PATIENCE = 1.0


class Browser(JSComponent):
    """The other side of the page, without a look of its own.

    Frames are sent as fast as they are shown: what a slow browser has not drawn yet would stand
    before every answer to a click.

    Attributes
    ----------
    frame : number of frames sent.  shown : number of the last one that is on the screen.
    address : of the page, without its query; empty until the browser has told.
    on_key, on_width : called with the name of a key; with the window's width [px] at first.
    """

    _esm = Path(__file__).parent / "browser.js"

    def __init__(self, **params: Any) -> None:
        super().__init__(**params)
        self.frame = self.shown = 0
        self.address = ""
        self.on_key: Callable[[str], None] = _ignore
        self.on_width: Callable[[int], None] = _ignore
        self.on_copied: Callable[[bool], None] = _ignore
        self._sent = 0.0

    @property
    def is_ready(self) -> bool:
        """Whether another frame would be shown soon."""
        behind = self.frame - self.shown
        return behind < _AHEAD or time.monotonic() - self._sent > _PATIENCE

    def send_frame(self) -> None:
        """Call after all changes of a frame: the browser tells when it has drawn them."""
        self._sent = time.monotonic()
        self.frame += 1
        self._send_msg({"frame": self.frame, "answer": self.frame % _ANSWERED == 0})

    def copy(self, text: str) -> None:
        """Put a text into the clipboard; `on_copied` is called with whether it worked."""
        self._send_msg({"copy": text})

    def set_style(self, **values: str) -> None:
        """Set variables of the page's style: `scale` of its type, height `taken` from plots."""
        self._send_msg({"style": {f"--{name}": value for name, value in values.items()}})

    def _process_bokeh_event(self, doc: Document, event: Event) -> None:
        # without Panel's count of what the page is busy with, which costs more than the answer
        with set_curdoc(doc):
            self._process_event(event)

    def _handle_msg(self, data: Any) -> None:
        """What the browser says; anyone can make it say anything."""
        if not isinstance(data, dict):
            return
        if isinstance(shown := data.get("shown"), int):
            self.shown = max(self.shown, min(shown, self.frame))
        if isinstance(key := data.get("key"), str):
            self.on_key(key)
        if isinstance(copied := data.get("copied"), bool):
            self.on_copied(copied)
        if isinstance(address := data.get("address"), str):
            self.address = address[:2000]
        if isinstance(width := data.get("width"), int):
            self.on_width(width)


def _ignore(_: Any) -> None:
    """Nobody listens yet."""
