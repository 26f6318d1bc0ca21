"""The control that takes a road file: drop, pitch and unit, and what was understood."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import panel_material_ui as pmui
import param

from tyrecontact.errors import InputError
from tyrecontact.road import prepare, scans
from tyrecontact.road.formats import instruments
from tyrecontact.road.understood import understood

#: an upload with more bytes than this is refused
MAX_BYTES = 64_000_000
_NONE = "No file: a worn road is made from the seed."


class RoadFile:
    """Keeps an uploaded file for one session and hands it on once it can be read.

    Parameters
    ----------
    take : called with (path, pitch [m], unit) of a road that can be read, or ("", 0, "").
    refuse : called with one sentence about a file that cannot.
    """

    def __init__(
        self, take: Callable[[str, float, str], None], refuse: Callable[[str], None]
    ) -> None:
        self._take, self._refuse = take, refuse
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._path: Path | None = None
        self._name = ""
        self.file = pmui.FileInput(
            label="Road file",
            accept=",".join((*scans.ENDINGS, ".gz", *instruments.ENDINGS)),
            sizing_mode="stretch_width",
        )
        self.pitch = pmui.FloatInput(
            label="Pitch of the file [µm]", value=None, size="small", sizing_mode="stretch_width"
        )
        self.unit = pmui.Select(
            label="Unit of its heights", options=["", *scans.UNITS], value="", size="small",
            sizing_mode="stretch_width",
        )  # fmt: skip
        self.clear = pmui.Button(label="Back to the made road", size="small", variant="outlined")
        self.status = pmui.Typography(_NONE, variant="caption", margin=(0, 10))
        self.root = pmui.Column(
            self.file, self.pitch, self.unit, self.status, self.clear, sizing_mode="stretch_width"
        )
        self.file.param.watch(self._uploaded, "value")
        self.pitch.param.watch(lambda _: self._understand(), "value")
        self.unit.param.watch(lambda _: self._understand(), "value")
        self.clear.on_click(lambda _: self.forget())

    def forget(self) -> None:
        """Drop the file; the road is made again."""
        self.close()
        self.file.param.update(value=None, filename=None)
        self.status.object = _NONE
        self._take("", 0.0, "")

    def close(self) -> None:
        """Remove what was kept on disk."""
        if self._folder is not None:
            self._folder.cleanup()
        self._folder = self._path = None

    def _uploaded(self, event: param.parameterized.Event) -> None:
        content, name = event.new, str(self.file.filename)
        if not content:
            return
        self.forget()
        try:
            ending = scans.require_known(name)
        except InputError as error:
            self._reject(str(error))
            return
        if len(content) > MAX_BYTES:
            size = f"{len(content) / 1e6:.0f} MB"
            self._reject(f"{name} must have at most {MAX_BYTES / 1e6:.0f} MB, got {size}")
            return
        self._name = name
        self._folder = tempfile.TemporaryDirectory(prefix="tyrecontact-")
        # only the ending is taken from the visitor's name
        self._path = Path(self._folder.name) / f"road{ending}"
        self._path.write_bytes(content)
        self._understand()

    def _reject(self, sentence: str) -> None:
        self._take("", 0.0, "")
        self.status.object = f"Not used: {sentence}."
        self._refuse(sentence)

    def _understand(self) -> None:
        if self._path is None:
            return
        pitch, unit = (self.pitch.value or 0.0) * 1e-6, self.unit.value or ""
        try:
            found = understood(
                prepare.levelled(scans.read(self._path, pitch or None, unit or None))
            )
        except scans.NotCarriedError as error:
            self._take("", 0.0, "")
            asked = str(error).replace(self._path.name, "the file")
            self.status.object = (
                f"{self._name}: give its pitch and the unit of its heights ({asked})."
            )
            return
        except InputError as error:
            self._reject(str(error).replace(self._path.name, self._name))
            return
        self._take(str(self._path), pitch, unit)
        self.status.object = f"{self._name}: {found.sentence()}"
