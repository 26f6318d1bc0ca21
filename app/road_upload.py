"""An upload of any size: straight to disk in small pieces, checked as it comes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import IO, Any

import panel_material_ui as pmui

from tyrecontact.errors import InputError
from tyrecontact.road import scans

from .limits import limits

#: bytes a message: so few that the page answers between two
_PIECE = 2_000_000


class Upload(pmui.FileInput):
    """A button to choose a file with, or to drop one on; keeps nothing of it in memory.

    Parameters
    ----------
    place : gives an empty path for a file of such a name and ending.
    tell : called with a sentence on how far it is.
    done : called with the path and the visitor's name of a file that is there.
    refuse : called with the name and one sentence about a file that is not taken.
    """

    def __init__(
        self,
        place: Callable[[str, str], Path],
        tell: Callable[[str], None],
        done: Callable[[Path, str], None],
        refuse: Callable[[str, str], None],
        **settings: Any,
    ) -> None:
        super().__init__(chunk_size=_PIECE, **settings)
        self._place, self._tell, self._done, self._refuse = place, tell, done, refuse
        self._file: IO[bytes] | None = None
        self._path: Path | None = None
        self._name = ""
        self._pieces = self._number = self._size = 0
        self._refused = False

    def receive(self, name: str, piece: bytes, number: int, pieces: int) -> None:
        """A piece of a file, numbered from 1; those of a refused file are passed over."""
        if self._refused:
            return
        try:
            if number == 1:
                self._begin(name, pieces)
            self._append(piece, number)
        except (InputError, OSError) as error:
            self._drop(name, str(error))
            return
        share = f"{self._size / 1e6:.3g} of about {pieces * _PIECE / 1e6:.3g} MB"
        self._tell(f"Receiving {name}: {share} …" if pieces > 1 else f"Receiving {name} …")

    def finish(self) -> None:
        """All pieces of a file have been sent."""
        refused, path, name, pieces = self._refused, self._path, self._name, self._pieces
        whole = self._number == pieces
        self._close()
        if refused:
            return
        if path is None:
            self._drop("The file", "a road file must hold heights, got 0 bytes")
        elif not whole:
            self._drop(name, f"{name} must arrive whole, got {self._number} of {pieces} pieces")
        else:
            self._path = None
            self.abandon()
            self._done(path, name)

    def abandon(self) -> None:
        """Let go of a file that has not come to its end, from the disk, too."""
        self._close()
        if self._path is not None:
            self._path.unlink(missing_ok=True)
        self._path = None
        self._name, self._pieces, self._number, self._size = "", 0, 0, 0
        self._refused = False

    def _handle_msg(self, msg: Any) -> None:
        """What the browser sends: the protocol of pmui's own upload, which keeps all in memory.

        Anyone can make it send anything: what makes no sense is passed over.
        """
        match msg:
            case {"status": "initializing"}:
                self.abandon()
            case {
                "status": "upload_event",
                "name": str(name),
                "data": bytes() | bytearray() | memoryview() as piece,
                "chunk": int(number),
                "total_chunks": int(pieces),
            }:
                self.receive(name, bytes(piece), number, pieces)
            case {"status": "finished"}:
                self.finish()
                self._send_msg({"status": "finished"})
            case {"status": "error", "error": str(error)}:
                self._drop(self._name or "The file", f"the browser could not send it: {error}")

    def _begin(self, name: str, pieces: int) -> None:
        self.abandon()
        ending = scans.require_known(name)
        limits().check_upload((pieces - 1) * _PIECE + 1)
        self._name, self._pieces = name, pieces
        self._path = self._place(name, ending)
        self._file = self._path.open("wb")

    def _append(self, piece: bytes, number: int) -> None:
        if self._file is None or number != self._number + 1:
            raise InputError(f"pieces must come in order, got {number} after {self._number}")
        self._size += len(piece)
        limits().check_upload(self._size)
        self._file.write(piece)
        self._number = number

    def _drop(self, name: str, sentence: str) -> None:
        self._close()
        if self._path is not None:
            self._path.unlink(missing_ok=True)
        self._refused = True
        self._refuse(name, sentence)

    def _close(self) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None
