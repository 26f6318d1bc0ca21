"""Read measured roads. Nothing is guessed: what a file does not carry is asked for, and said."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.road.formats import arrays, instruments, points, stl, text, x3p, xyz
from tyrecontact.road.formats.raw import NO_DATA, Asked, Raw
from tyrecontact.road.scan import UNITS, NotCarriedError, Scan

__all__ = [
    "ENDINGS", "UNITS", "Loaded", "NotCarriedError", "Scan", "ending", "load", "read",
    "require_known",
]  # fmt: skip

_Reader = Callable[[Path, Asked], Raw]
_TEXT = (".txt", ".csv", ".dat", ".asc", ".tsv")
_READERS: dict[str, _Reader] = {
    ".npy": arrays.read_npy,
    ".npz": arrays.read_npz,
    **dict.fromkeys(_TEXT, text.read),
    ".xyz": xyz.read,
    ".stl": stl.read,
    **dict.fromkeys([f"{ending}.gz" for ending in _TEXT], text.read),
    ".xyz.gz": xyz.read,
    ".stl.gz": stl.read,
    ".x3p": x3p.read,
    **dict.fromkeys((".las", ".laz"), points.read),
}
#: endings of the files that are read here; `instruments.ENDINGS` come with the extra [scans]
ENDINGS = tuple(_READERS)
#: formats that carry neither pitch nor unit: no need to open one to ask for them
_BARE = (".npy", ".npz")
#: a given pitch that differs from the file's by less is the file's, rounded
_SAME = 2e-3
#: signs of another library's message that are passed on
_LONG = 160


def ending(name: str | Path) -> str:
    """Ending of a file's name in small letters; ".dat.gz" where it is packed."""
    path = Path(name)
    last = path.suffix.lower()
    return Path(path.stem).suffix.lower() + last if last == ".gz" else last


def require_known(name: str | Path) -> str:
    """The ending of a file that can be read.

    Raises
    ------
    InputError : another ending; it lists those read here, and the nearest of an instrument's.
    """
    found = ending(name)
    if found not in _READERS and found not in instruments.ENDINGS:
        near = get_close_matches(found, instruments.ENDINGS, n=1, cutoff=0.5)
        raise unknown_name("kind of road file", found, (*ENDINGS, *near))
    return found


def read(path: str | Path, pitch: float | None = None, unit: str | None = None) -> Scan:
    """Read a map of heights, rows along y, or a profile along x.

    Parameters
    ----------
    path : a file with one of `ENDINGS`: numpy, text (matrix; ESRI grid; lines of named columns),
        x y z columns, STL, ISO 5436-2, LAS; or, with the extra [scans], an instrument's format.
    pitch : distance of neighbouring heights [m]; needed where the file does not carry it. For
        triangles and clouds of points: of the grid they are put on.
    unit : of the heights in the file, "m", "mm" or "um"; needed where the file does not carry it.

    A pitch or unit that is given although the file carries another overrides it (files do carry
    wrong ones); `Scan.done` then says so.

    Returns
    -------
    Scan with heights in m, NaN where missing (also those of -9999).

    Raises
    ------
    NotCarriedError : pitch or unit is missing.
    InputError : a file that is absent, damaged, hostile, too large, or no road.
    """
    return load(path, pitch, unit).scan(pitch, unit)


@dataclass(frozen=True)
class Loaded:
    """A file whose numbers were read: what is given about them may change, it is not read again.

    Attributes
    ----------
    path : of the file. raw : its numbers and facts. asked : what was given when it was read.
    """

    path: Path
    raw: Raw
    asked: Asked

    def scan(self, pitch: float | None = None, unit: str | None = None) -> Scan:
        """The scan with what is given now; see `read`."""
        _require_usable(pitch, unit)
        _require_given(self.raw, self.path, pitch, unit)
        raw, asked = self.raw, Asked(pitch, unit)
        if raw.resampled and asked.step != self.asked.step:  # triangles, on another grid
            raw = _raw(self.path, asked)
        return _scan(raw, self.path, pitch, unit)


def load(path: str | Path, pitch: float | None = None, unit: str | None = None) -> Loaded:
    """Read the numbers of a file; the parameters and errors are those of `read`.

    A pitch or unit that is missing is an error here only where no file of the kind carries it.
    """
    path = Path(path).expanduser()
    _require_usable(pitch, unit)
    kind = require_known(path)
    if kind in _BARE:
        _require_given(Raw(np.empty(0), kind), path, pitch, unit)
    asked = Asked(pitch, unit)
    return Loaded(path, _raw(path, asked), asked)


def _require_usable(pitch: float | None, unit: str | None) -> None:
    if pitch is not None and not 0 < pitch < np.inf:
        raise InputError(f"pitch must be positive and finite, got {pitch} m")
    if unit is not None and unit not in UNITS:
        raise unknown_name("unit of heights", unit, UNITS)


def _raw(path: Path, asked: Asked) -> Raw:
    """What the file holds; whatever goes wrong is an `InputError` of one sentence."""
    try:
        return _READERS.get(ending(path), instruments.read)(path, asked)
    except InputError:
        raise
    except OSError as error:
        reason = error.strerror or str(error)
        raise InputError(f"road file must be readable, got {path.name}: {reason}") from None
    except (Exception, RecursionError) as error:  # whatever libraries make of damaged bytes
        first_line = "".join(str(error).strip().splitlines()[:1]) or type(error).__name__
        if len(first_line) > _LONG:  # some quote the file
            first_line = f"{first_line[:_LONG]}..."
        raise InputError(
            f"road file must hold a matrix of numbers, got {path.name}: {first_line}"
        ) from None


def _require_given(raw: Raw, path: Path, pitch: float | None, unit: str | None) -> None:
    no_pitch = pitch is None and raw.pitch is None and raw.spacing is None
    no_unit = unit is None and raw.unit is None
    if no_pitch:
        raise NotCarriedError(
            f"pitch must be given: {path.name} does not carry the distance of heights",
            ("pitch", "unit") if no_unit else ("pitch",),
        )
    if no_unit:
        raise NotCarriedError(
            f"unit must be given as m, mm or um: {path.name} does not carry it", ("unit",)
        )


def _scan(raw: Raw, path: Path, pitch: float | None, unit: str | None) -> Scan:
    """Numbers and facts of the file, with what was given, as a scan in metres."""
    name, scale, unit_origin, against_unit = _unit(raw, unit)
    step, pitch_origin, against_pitch = _pitch(raw, scale, pitch)
    heights = np.array(raw.heights, float)
    no_data = heights == NO_DATA
    taken = np.count_nonzero(no_data)
    heights[no_data | ~np.isfinite(heights)] = np.nan
    return Scan(
        heights * scale,
        step,
        name=path.name,
        kind=raw.kind,
        unit=name,
        pitch_origin=pitch_origin,
        unit_origin=unit_origin,
        missing_share=float(np.isnan(heights).mean()) if heights.size else 0.0,
        done=(
            *raw.done,
            *against_unit,
            *against_pitch,
            *([f"{taken} heights of {NO_DATA:g} taken as missing"] if taken else []),
        ),
    )


def _unit(raw: Raw, given: str | None) -> tuple[str, float, str, list[str]]:
    """Unit, metres per unit, its origin, and the clause that it stands against the file's."""
    if raw.unit is not None and raw.scale is not None and given in (None, raw.unit):
        return raw.unit, raw.scale, "file", []
    given = str(given)
    against = [f"unit {given} as given, against {raw.unit} in the file"] if raw.unit else []
    return given, UNITS[given], "given", against


def _pitch(raw: Raw, scale: float, given: float | None) -> tuple[float, str, list[str]]:
    """Pitch [m], its origin, and the clause that it stands against the file's."""
    carried = raw.pitch if raw.spacing is None else raw.spacing * scale
    if carried is None:
        return given or 0.0, "given", []
    if given is None or abs(given - carried) <= _SAME * carried:
        return carried, "given" if raw.resampled and given else "file", []
    clause = f"pitch {given * 1e6:.6g} µm as given, against {carried * 1e6:.6g} µm in the file"
    return given, "given", [clause]
