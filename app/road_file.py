"""The control that takes a road file: upload, dialog, and the line that says what is used."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

import panel as pn
import panel_material_ui as pmui

from tyrecontact.parts.road import Road

from .file_names import harmless
from .latest import Latest
from .road_dialog import SETTINGS, RoadDialog
from .road_reading import Look, Reading
from .road_upload import Upload
from .views.road_facts import line

_NONE = "No file: a road is made from the seed."
_GONE = "This file is no longer kept: bring it again, or go back to the made road."
#: files of a visitor that are kept, so that undo finds the road before
_KEPT = 3


@dataclass(frozen=True)
class _InUse:
    """A file that was used: its name, and a line on it."""

    name: str
    line: str


class RoadFile:
    """Keeps a visitor's files for one session and hands on what was confirmed in the dialog.

    Parameters
    ----------
    take : called with the values of settings by path, "road.file" last and "" without a file.
    refuse : called with one sentence about a file that cannot be used.
    road : gives the settings of the form, for what the dialog does not ask (elements, fill limit).

    Attributes
    ----------
    root : what stands in the form. dialog : to be placed once, anywhere on the page.
    """

    def __init__(
        self,
        take: Callable[[dict[str, Any]], None],
        refuse: Callable[[str], None],
        road: Callable[[], Road] = Road,
    ) -> None:
        self._take, self._refuse, self._road = take, refuse, road
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._numbers = count(1)
        self._used: dict[str, _InUse] = {}
        self._reading: Reading | None = None
        self._look: Look | None = None
        self._asked: RoadDialog | None = None
        self.file = ""
        self._document = pn.state.curdoc  # None where there is no browser, as in tests
        self.work = Latest(self._answered)
        self.upload = Upload(
            self._place, self._say, self._arrived, self._reject, label="Bring a road file",
            uploaded_label="Bring another road file", sizing_mode="stretch_width",
        )  # fmt: skip
        self.status = pn.pane.HTML(line(_NONE), margin=(0, 10), sizing_mode="stretch_width")
        self.change = pmui.Button(label="Change…", size="small", variant="outlined", visible=False)
        self.clear = pmui.Button(
            label="Back to the made road", size="small", variant="outlined", visible=False
        )
        self.change.on_click(lambda _: self.reopen())
        self.clear.on_click(lambda _: self.forget())
        self.root = pn.Column(
            self.upload, self.status, pn.Row(self.change, self.clear), sizing_mode="stretch_width"
        )
        self.dialog = pn.Column(margin=0)

    @property
    def name(self) -> str:
        """That the file in use had, or empty."""
        used = self._used.get(self.file)
        return used.name if used else ""

    def show(self, file: str) -> None:
        """Say which file is in use after the scenario was changed elsewhere, as by undo."""
        self.file = file
        used = self._used.get(file)
        self._say(used.line if used else _GONE if file else _NONE)
        self.change.visible = used is not None
        self.clear.visible = bool(file)

    def reopen(self) -> None:
        """The dialog again, on the file in use."""
        form = self._road()
        road = Road(**{name: getattr(form, name) for name in (*SETTINGS, "seed")})
        self._begin(Path(self.file), self.name, road, fresh=False)

    def forget(self) -> None:
        """The road is made again; the file is kept for undo."""
        self._drop()
        self.show("")
        fresh = Road()
        self._take({f"road.{name}": getattr(fresh, name) for name in (*SETTINGS, "file")})

    def close(self) -> None:
        """The visitor has left: remove what was kept on disk."""
        self.work.close()
        self.upload.abandon()
        self._reading = None
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None

    def _place(self, name: str, ending: str) -> Path:
        """Where a file is written, in a folder of its own: runs and tables tell its name."""
        self._drop()
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="tyrecontact-")
        path = Path(self._folder.name) / str(next(self._numbers)) / harmless(name, ending, "road")
        path.parent.mkdir()
        return path

    def _say(self, sentence: str) -> None:
        self.status.object = line(sentence)

    def _arrived(self, path: Path, name: str) -> None:
        self.show(self.file)
        form, fresh = self._road(), Road()
        kept = {name: getattr(form, name) for name in ("elements", "seed")}
        self._begin(path, name, Road(**kept, size=fresh.size), fresh=True)

    def _reject(self, name: str, sentence: str) -> None:
        """A file that was not even taken."""
        self.show(self.file)
        self._made().refuse(name, sentence)
        self._mount()
        self._say(f"Not used: {sentence}.")
        self._refuse(sentence)

    def _begin(self, path: Path, name: str, road: Road, fresh: bool) -> None:
        self._drop()
        self._reading = Reading(path, name)
        self._made().open(name, road, fresh)
        self._mount()

    def _made(self) -> RoadDialog:
        if self._asked is None:
            self._asked = RoadDialog(self._look_again, self.use, self.cancel)
        return self._asked

    def _mount(self) -> None:
        """Put the dialog on the page when it is first needed, with all that it begins with."""
        if not self.dialog.objects:
            self.dialog.objects = [self._made().root]

    def _look_again(self, road: Road) -> None:
        reading = self._reading
        if reading is not None:
            self._look = None
            self.work.ask(lambda _: (reading.look(road), road))

    def _answered(self) -> None:
        """On the thread that reads."""
        if self._document is not None:
            self._document.add_next_tick_callback(self.arrive)

    def arrive(self) -> None:
        """Show what has been read, if it still is what was asked for."""
        answer = self.work.take()
        if answer is None or self._reading is None:
            return
        found, refusal = answer
        if refusal:
            self._reject(self._reading.name, refusal)
        else:
            self._show(*found)

    def _show(self, look: Look, road: Road) -> None:
        self._look = look
        self._made().show(look, road)
        if look.refusal and look.found is None:
            self._say(f"Not used: {look.refusal}.")
            self._refuse(look.refusal)

    def use(self) -> None:
        """What is in the dialog becomes the road."""
        look, reading, dialog = self._look, self._reading, self._asked
        if reading is None or dialog is None or look is None or not look.usable:
            return
        assert look.found is not None
        road, file = dialog.road(), str(reading.path)
        self._used.pop(file, None)
        self._used[file] = _InUse(look.name, f"{look.name}: {look.found.sentence()}")
        while len(self._used) > _KEPT:
            oldest = next(iter(self._used))
            del self._used[oldest]
            Path(oldest).unlink(missing_ok=True)
        self._drop()
        dialog.close()
        self.show(file)
        self._take({**{f"road.{name}": getattr(road, name) for name in SETTINGS},
                    "road.file": file})  # fmt: skip

    def cancel(self) -> None:
        """The road stays as it was."""
        self._drop()
        if self._asked is not None:
            self._asked.close()

    def _drop(self) -> None:
        """Let go of a file that is looked at; from the disk, too, if it is not in use."""
        self.work.drop()
        reading, self._reading, self._look = self._reading, None, None
        if reading is not None and str(reading.path) not in self._used:
            reading.path.unlink(missing_ok=True)
