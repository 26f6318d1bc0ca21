"""Read height maps of measured roads. Nothing is guessed: pitch and unit are asked for."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.road.heights import Patch

#: metres per unit of height
UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6}
#: a map with more heights than this is refused before it is read
MAX_HEIGHTS = 64_000_000
#: a text matrix with more bytes than this is refused before it is read
MAX_TEXT_BYTES = 512_000_000

_TEXT = (".txt", ".csv", ".dat", ".asc", ".tsv")
#: endings of the files that can be read
ENDINGS = (".npy", ".npz", *_TEXT)


def read(path: str | Path, pitch: float | None = None, unit: str | None = None) -> Patch:
    """Read a 2-D height map, rows along y.

    Parameters
    ----------
    path : `.npy`, `.npz` (an array "heights", or a single array) or a text matrix (`.txt .csv
        .dat .asc .tsv`; white space, comma or semicolon between numbers, # for comments).
    pitch : distance of neighbouring heights [m]; these formats do not carry it.
    unit : of the heights in the file: "m", "mm" or "um"; these formats do not carry it.

    Returns
    -------
    Patch with heights in m.

    Raises
    ------
    InputError : a file that is absent, truncated, too large or not a height map; pitch or unit
        missing; heights that are not finite.
    """
    path = Path(path).expanduser()
    if pitch is None:
        raise InputError(f"pitch must be given: {path.name} does not carry the distance of heights")
    if unit is None:
        raise InputError(f"unit must be given as m, mm or um: {path.name} does not carry it")
    if unit not in UNITS:
        raise unknown_name("unit of heights", unit, UNITS)
    heights = _matrix(path)
    if heights.ndim != 2 or heights.dtype.kind not in "fiu":
        raise InputError(
            f"road file must hold a 2-D matrix of real numbers, got {path.name} with shape "
            f"{heights.shape} of {heights.dtype}"
        )
    return Patch(np.array(heights, float) * UNITS[unit], pitch)


def _matrix(path: Path) -> np.ndarray:
    """What the file holds; whatever goes wrong is an `InputError` of one sentence."""
    reader = {".npy": _read_npy, ".npz": _read_npz, **dict.fromkeys(_TEXT, _read_text)}
    ending = path.suffix.lower()
    if ending not in reader:
        raise unknown_name("kind of road file", ending, reader)
    try:
        return reader[ending](path)
    except InputError:
        raise
    except OSError as error:
        reason = error.strerror or str(error)
        raise InputError(f"road file must be readable, got {path.name}: {reason}") from None
    except Exception as error:  # whatever numpy and zipfile make of damaged bytes
        first_line = str(error).partition("\n")[0]
        raise InputError(
            f"road file must hold a matrix of numbers, got {path.name}: {first_line}"
        ) from None


def _read_npy(path: Path) -> np.ndarray:
    heights = np.lib.format.open_memmap(path, mode="r")  # sized before it is read; no pickles
    _require_size(heights.size, path)
    return heights


def _read_npz(path: Path) -> np.ndarray:
    with zipfile.ZipFile(path) as archive:
        unpacked = sum(entry.file_size for entry in archive.infolist())
        _require_size(unpacked // 8, path)
    with np.load(path, allow_pickle=False) as arrays:
        names = list(arrays)
        if "heights" not in names and len(names) != 1:
            raise InputError(
                f"{path.name} must hold an array 'heights' or a single array, got {names}"
            )
        heights = arrays["heights" if "heights" in names else names[0]]
    _require_size(heights.size, path)
    return heights


def _read_text(path: Path) -> np.ndarray:
    size = path.stat().st_size
    if size > MAX_TEXT_BYTES:
        raise InputError(
            f"{path.name} must have at most {MAX_TEXT_BYTES / 1e6:.0f} MB, got {size / 1e6:.0f} MB"
        )
    with path.open(encoding="utf-8-sig") as lines:
        data = (line.partition("#")[0].strip() for line in lines)
        sample = next(filter(None, data), "")
    if not sample:
        raise InputError(f"road file must hold numbers, got {path.name}, which is empty")
    delimiter = next((mark for mark in ";," if mark in sample), None)
    heights = np.loadtxt(path, delimiter=delimiter, ndmin=2, encoding="utf-8-sig")
    _require_size(heights.size, path)
    return heights


def _require_size(heights: int, path: Path) -> None:
    if heights > MAX_HEIGHTS:
        raise InputError(f"{path.name} must hold at most {MAX_HEIGHTS:g} heights, got {heights:g}")
