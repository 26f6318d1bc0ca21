"""What the dialog on a road file asks the library, off the page's loop; knows no screen."""

from __future__ import annotations

import logging
from dataclasses import dataclass, replace
from pathlib import Path

from tyrecontact.assembly import road as assembly
from tyrecontact.errors import InputError
from tyrecontact.parts.road import Road
from tyrecontact.road import scans
from tyrecontact.road.overview import Overview, overview
from tyrecontact.road.scan import NotCarriedError, Scan
from tyrecontact.road.understood import Understood, understood

#: a square that is offered where the usual one does not fit is a whole number of these [m]
_STEP = 0.5e-3


@dataclass(frozen=True)
class Look:
    """What is known of a file with the settings of a moment.

    Attributes
    ----------
    name : of the file. refusal : why it cannot be used so, one sentence, or "".
    missing : what must be given, of "pitch" and "unit".
    found, view : what was understood, and what to draw; None where it could not be read.
    fits : side of the largest square in it, on its middle [m]; 0 where unknown.
    """

    name: str
    refusal: str = ""
    missing: tuple[str, ...] = ()
    found: Understood | None = None
    view: Overview | None = None
    fits: float = 0.0

    @property
    def usable(self) -> bool:
        """Whether a road can be made of it."""
        return self.found is not None and not self.refusal


class Reading:
    """One road file, read once, looked at with one setting after the other.

    Parameters
    ----------
    path : where it is. name : what its owner calls it.
    """

    def __init__(self, path: Path, name: str) -> None:
        self.path, self.name = path, name
        self._loaded: scans.Loaded | None = None
        self._key: tuple[object, ...] = ()
        self._prepared: Scan | None = None
        self._told: tuple[Understood, Overview] | None = None

    def look(self, road: Road) -> Look:
        """What the file gives with such settings; all that is wrong becomes a sentence in it."""
        try:
            prepared, found, view = self._understood(road)
        except NotCarriedError as error:
            return Look(self.name, missing=error.missing)
        except InputError as error:
            return Look(self.name, self._in_words(error))
        except MemoryError:
            return Look(self.name, f"{self.name} must fit into the server's memory")
        except Exception:  # the page waits for an answer, whatever happens
            logging.getLogger(__name__).exception("a road file could not be looked at")
            return Look(
                self.name, f"{self.name} could not be read: an error of ours, now in the log"
            )
        return Look(self.name, self._refusal(prepared, road), (), found, view, min(prepared.extent))

    def _understood(self, road: Road) -> tuple[Scan, Understood, Overview]:
        pitch, unit = road.pitch or None, road.height_unit or None
        key = (pitch, unit, road.trim_start, road.trim_end, road.height_direction, road.levelling)
        if key != self._key or self._prepared is None or self._told is None:
            self._key, self._prepared, self._told = (), None, None
            if self._loaded is None:
                self._loaded = scans.load(self.path, pitch, unit)
            scan = replace(self._loaded.scan(pitch, unit), name=self.name)
            self._prepared = prepared = assembly.prepared(scan, road)
            self._told = (
                understood(prepared), overview(assembly.with_ends(prepared, scan, road)),
            )  # fmt: skip
            self._key = key
        return self._prepared, *self._told

    def _refusal(self, prepared: Scan, road: Road) -> str:
        """Why no patch can be made of it, or ""."""
        try:
            assembly.patch_of(prepared, road)
        except InputError as error:
            return self._in_words(error)
        return ""

    def _in_words(self, error: InputError) -> str:
        return str(error).replace(self.path.name, self.name)


def square_that_fits(look: Look, size: float) -> float:
    """The side of a patch [m] to begin with: as wished, or the largest that the file has."""
    if not 0 < look.fits < size:
        return size
    return int(look.fits / _STEP + 1e-6) * _STEP or look.fits
