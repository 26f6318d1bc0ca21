"""What can be taken away of the run on show: its files, and the plots as pictures."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import panel as pn
import panel_material_ui as pmui

from tyrecontact import Results

from .. import code, exports
from ..runner import Run
from .file_button import file_button

_SAVE = (Path(__file__).parent / "save_plots.js").read_text(encoding="utf-8")
_NO_RUN = "Press Run: then the run can be taken away here, as far as it has come."
_NO_STEP = "The run has no step yet."


class Downloads:
    """Attributes: `root` a column; `files`, `pictures` ending -> button; `note` what there is."""

    def __init__(self) -> None:
        self.root = pn.Column(sizing_mode="stretch_width")
        self.files: dict[str, pmui.FileDownload] = {}
        self.pictures: dict[str, pmui.Button] = {}
        self._preset = "default"
        self._run: Run | None = None

    def show(self, preset: str, run: Run | None) -> None:
        """Offer the files of a run.

        Parameters
        ----------
        preset : that the scenario of the run came from.
        run : on show, or None before the first.
        """
        self._preset, self._run = preset, run
        if not self.files:
            self._build()
        count = run.record.count if run is not None and run.record is not None else 0
        nothing = _NO_RUN if run is None else _NO_STEP
        self.note.object = f"The run, {count} steps:" if count else nothing
        for file in self.files.values():
            file.disabled = not count
        for picture in self.pictures.values():
            picture.tags = [exports.stem(preset)]

    def contents(self, ending: str) -> tuple[str, bytes]:
        """Name and contents of the file "nc", "csv" or "toml" of the run on show."""
        results = self._results()
        name = exports.file_name(self._preset, ending)
        if ending == "nc":
            return name, exports.netcdf(results)
        if ending == "csv":
            return name, exports.csv(self._preset, results).encode()
        bare = code.without_folders(results.scenario)
        return name, code.toml(self._preset, bare).encode()

    def _results(self) -> Results:
        assert self._run is not None
        results = self._run.results()
        assert results is not None  # the buttons are disabled until there are some
        return results

    def _build(self) -> None:
        self.note = pmui.Typography(_NO_RUN, variant="body2", margin=(6, 10, 0, 10))
        labels = {
            "nc": "netCDF: all of it",
            "csv": "CSV: every step",
            "toml": "TOML: its scenario",
        }
        for ending, label in labels.items():
            self.files[ending] = file_button(label, partial(self.contents, ending))
        for kind in ("png", "svg"):
            button = pmui.Button(label=f"Plots as {kind.upper()}", size="small", variant="outlined")
            button.js_on_click(args={"kind": kind, "button": button}, code=_SAVE)
            self.pictures[kind] = button
        self.root.extend([self.note, pn.FlexBox(*self.files.values(), *self.pictures.values())])
