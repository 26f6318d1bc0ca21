"""A small text file that a visitor brings as a setting, such as a loading table."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Any

import panel_material_ui as pmui
import param

from .file_names import harmless

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
    """

    def __init__(
        self, title: str, take: Callable[[str], None], refuse: Callable[[str], None]
    ) -> None:
        self._title, self._take, self._refuse = title, take, refuse
        self.file = ""
        self._names: dict[str, str] = {}  # path of a file -> name that it had
        self._numbers = count(1)
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._input: pmui.FileInput | None = None

    @property
    def name(self) -> str:
        """That the file in use had, or empty."""
        return self._names.get(self.file, "")

    @property
    def root(self) -> pmui.FileInput:
        """The control; made when first shown."""
        if self._input is None:
            self._input = SmallFile(
                self._title, self._refuse, label=self._title, accept=".txt,.csv,.dat,.tsv",
                sizing_mode="stretch_width", margin=(6, 10),
            )  # fmt: skip
            self._input.param.watch(self._uploaded, "value")
        return self._input

    def show(self, file: str) -> None:
        """Say which file is in use after the scenario was changed elsewhere, as by undo."""
        if file == self.file:
            return
        self.file = file
        if self._input is not None and self._input.filename != (self.name or None):
            self._input.param.update(value=None, filename=self.name or None)

    def close(self) -> None:
        """Remove what was kept on disk."""
        if self._folder is not None:
            self._folder.cleanup()
        self._folder, self.file = None, ""
        self._names.clear()

    def _uploaded(self, event: param.parameterized.Event) -> None:
        if event.new and len(event.new) > MAX_BYTES:
            self._refuse(_too_large(self._title, len(event.new)))
        elif event.new:
            self._take(self._keep(event.new))

    def _keep(self, content: bytes) -> str:
        """Write a file, and let the oldest go; undo finds the ones between."""
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="tyrecontact-")
        name = str(self.root.filename or "table.txt")
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
