"""A small text file that a visitor brings as a setting, such as a loading table."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any

import panel as pn
import panel_material_ui as pmui
import param

from .file_names import harmless
from .views.road_facts import line

#: a table with more bytes than this is no table
MAX_BYTES = 8_000_000
#: files of a visitor that are kept, so that undo finds the one before
KEPT = 3


class TextFile:
    """Keeps a file for one session, and hands on where it is.

    Parameters
    ----------
    title : what the file is.
    take : called with its path, or with "" when it was dropped.
    refuse : called with one sentence about a file that cannot be taken.

    Attributes
    ----------
    file : path of the one in use, or empty.
    input, status, clear : what a file is brought with, what is in use, and the way back.
    """

    def __init__(
        self, title: str, take: Callable[[str], None], refuse: Callable[[str], None]
    ) -> None:
        self._title, self._take, self._refuse = title, take, refuse
        self.file = ""
        self._names: dict[str, str] = {}  # path of a file -> name that it had
        self._numbers = count(1)
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._root: pn.Column | None = None

    @property
    def name(self) -> str:
        """That the file in use had, or empty."""
        return self._names.get(self.file, "")

    @property
    def root(self) -> pn.Column:
        """The controls; made when first shown."""
        if self._root is None:
            # the button itself would go on naming the last file, whether it is in use or not
            self.input = SmallFile(
                self._title, self._refuse, label=self._title, accept=".txt,.csv,.dat,.tsv",
                uploaded_label=f"{self._title}: another file", sizing_mode="stretch_width",
                margin=(6, 10),
            )  # fmt: skip
            self.input.param.watch(self._uploaded, "value")
            self.status = pn.pane.HTML(margin=(0, 10), sizing_mode="stretch_width")
            self.clear = pmui.Button(label="Do without the file", size="small", variant="outlined")
            self.clear.on_click(lambda _: self._take(""))
            self._root = pn.Column(
                self.input, self.status, self.clear, sizing_mode="stretch_width", margin=0
            )
            self._say()
        return self._root

    def show(self, file: str) -> None:
        """Say which file is in use after the scenario was changed elsewhere, as by undo."""
        if file == self.file:
            return
        self.file = file
        if self._root is not None:
            self._say()

    def close(self) -> None:
        """Remove what was kept on disk."""
        if self._folder is not None:
            self._folder.cleanup()
        self._folder, self.file = None, ""
        self._names.clear()

    def _say(self) -> None:
        """What is in use."""
        gone = "a file that is no longer kept: bring it again"
        self.status.object = line(f"In use: {self.name or gone}." if self.file else "No file.")
        self.clear.visible = bool(self.file)

    def _uploaded(self, event: param.parameterized.Event) -> None:
        if event.new and len(event.new) > MAX_BYTES:
            self._refuse(_too_large(self._title, len(event.new)))
        elif event.new:
            self._take(self._keep(event.new))
            self.input.value = None  # so that the same file can be brought again

    def _keep(self, content: bytes) -> str:
        """Write a file, and let the oldest go; undo finds the ones between."""
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="tyrecontact-")
        name = str(self.input.filename or "table.txt")
        # what is wrong with a file is said of the name that it has here
        path = Path(self._folder.name) / str(next(self._numbers)) / harmless(name, "", "table.txt")
        path.parent.mkdir()
        path.write_bytes(content)
        self._names[str(path)] = name
        while len(self._names) > KEPT:
            oldest = next(iter(self._names))
            del self._names[oldest]
            shutil.rmtree(Path(oldest).parent, ignore_errors=True)
        return str(path)


class SmallFile(pmui.FileInput):
    """One that takes no more into memory than a table has.

    The browser finds it by its name, and would not if that began with an underscore.
    """

    def __init__(self, title: str, refuse: Callable[[str], None], **settings: Any) -> None:
        super().__init__(**settings)
        self._title, self._refuse, self._got = title, refuse, 0

    def _handle_msg(self, msg: Any) -> None:
        """What the browser sends; anyone can make it send anything."""
        match msg:
            case {"status": "upload_event", "data": bytes() | bytearray() | memoryview() as data}:
                self._got += len(data)
                if self._got > MAX_BYTES:
                    self._file_buffer.clear()
                    return
            case {"status": "finished"}:
                got, self._got = self._got, 0
                if got > MAX_BYTES:
                    self._buffer.clear()
                    self._refuse(_too_large(self._title, got))
                    self._send_msg({"status": "finished"})
                    return
            case {"status": "initializing"}:
                self._got = 0
            case _:
                return
        super()._handle_msg(msg)


def _too_large(title: str, size: int) -> str:
    return f"{title} must have at most {MAX_BYTES / 1e6:.0f} MB, got {size / 1e6:.0f} MB"
