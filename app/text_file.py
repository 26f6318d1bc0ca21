"""A small text file that a visitor brings as a setting, such as a loading table."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import panel_material_ui as pmui
import param

from tyrecontact.errors import InputError

#: a table with more bytes than this is no table
MAX_BYTES = 8_000_000


class TextFile:
    """Keeps a file for one session, and hands on where it is.

    Parameters
    ----------
    title : what the file is.
    take : called with its path, or with "" when it was dropped.
    refuse : called with one sentence about a file that cannot be taken.

    Attributes
    ----------
    name : that the file had, or empty.
    """

    def __init__(
        self, title: str, take: Callable[[str], None], refuse: Callable[[str], None]
    ) -> None:
        self._title, self._take, self._refuse = title, take, refuse
        self.name = ""
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._input: pmui.FileInput | None = None

    @property
    def root(self) -> pmui.FileInput:
        """The control; made when first shown."""
        if self._input is None:
            self._input = pmui.FileInput(
                label=self._title, accept=".txt,.csv,.dat,.tsv", sizing_mode="stretch_width",
                margin=(6, 10),
            )  # fmt: skip
            self._input.param.watch(self._uploaded, "value")
        return self._input

    def clear(self) -> None:
        """Drop the file; nobody is told."""
        self.close()
        if self._input is not None:
            self._input.param.update(value=None, filename=None)

    def close(self) -> None:
        """Remove what was kept on disk."""
        if self._folder is not None:
            self._folder.cleanup()
        self._folder, self.name = None, ""

    def _uploaded(self, event: param.parameterized.Event) -> None:
        content = event.new
        if not content:
            return
        try:
            path = self._keep(content)
        except InputError as error:
            self._refuse(str(error))
            return
        self._take(str(path))

    def _keep(self, content: bytes) -> Path:
        if len(content) > MAX_BYTES:
            size = f"{len(content) / 1e6:.0f} MB"
            raise InputError(
                f"{self._title} must have at most {MAX_BYTES / 1e6:.0f} MB, got {size}"
            )
        self.close()
        self._folder = tempfile.TemporaryDirectory(prefix="tyrecontact-")
        # nothing of the visitor's name is taken
        path = Path(self._folder.name) / "table.txt"
        path.write_bytes(content)
        self.name = str(self.root.filename or path.name)
        return path
