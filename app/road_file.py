"""The control that takes a road file: drop, pitch and unit, and what was understood."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import panel_material_ui as pmui
import param

from tyrecontact.errors import InputError
from tyrecontact.road import scans

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
        self.file = pmui.FileInput(
            label="Road file",
            accept=".npy,.npz,.txt,.csv,.dat,.asc,.tsv",
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
        self.status.object = _NONE
        self._take("", 0.0, "")

    def close(self) -> None:
        """Remove what was kept on disk."""
        if self._folder is not None:
            self._folder.cleanup()
        self._folder = self._path = None

    def _uploaded(self, event: param.parameterized.Event) -> None:
        if not event.new:
            return
        self.forget()
        self._folder = tempfile.TemporaryDirectory(prefix="tyrecontact-")
        # only the ending is taken from the visitor's name
        self._path = Path(self._folder.name) / f"road{Path(str(self.file.filename)).suffix.lower()}"
        self._path.write_bytes(event.new)
        self._understand()

    def _understand(self) -> None:
        if self._path is None:
            return
        name = self.file.filename
        if not self.pitch.value or not self.unit.value:
            self._take("", 0.0, "")
            self.status.object = f"{name}: give its pitch and the unit of its heights."
            return
        pitch = self.pitch.value * 1e-6
        try:
            patch = scans.read(self._path, pitch=pitch, unit=self.unit.value)
        except InputError as error:
            self._take("", 0.0, "")
            sentence = str(error).replace(self._path.name, str(name))
            self.status.object = f"Not used: {sentence}."
            self._refuse(sentence)
            return
        height, width = patch.extent
        self.status.object = (
            f"{name}: {width * 1e3:.3g} x {height * 1e3:.3g} mm, rms {patch.rms * 1e6:.3g} µm, "
            f"rms slope {patch.rms_slope:.2g}, skewness {patch.skewness:.2g}."
        )
        self._take(str(self._path), pitch, self.unit.value)
