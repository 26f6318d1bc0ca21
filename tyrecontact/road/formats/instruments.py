"""Instruments' own formats, read by SurfaceTopography (extra `[scans]`), imported when needed."""

from __future__ import annotations

import warnings
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.formats.raw import Asked, Raw, require_size, require_square

#: endings that SurfaceTopography 1.27 reads and that are not read here
ENDINGS = (
    ".001", ".002", ".003", ".004", ".005", ".al3d", ".apx", ".bcr", ".bcrf", ".cur", ".datx",
    ".ezd", ".frt", ".gwy", ".h5", ".hfm", ".hgt", ".ibw", ".jpk", ".lext", ".mat", ".mdt",
    ".mi", ".mnt", ".nc", ".nid", ".nms", ".oir", ".opd", ".opdx", ".os3d", ".plu", ".plux",
    ".poir", ".qep", ".sdf", ".spm", ".stp", ".sur", ".tif", ".tiff", ".tmd", ".tom", ".top",
    ".vk3", ".vk4", ".vk6", ".vk7", ".xlsx", ".zip", ".zmg", ".zon",
)  # fmt: skip
#: metres per unit, as SurfaceTopography writes them
_UNITS = {
    "m": 1.0, "mm": 1e-3, "µm": 1e-6, "μm": 1e-6, "um": 1e-6, "nm": 1e-9, "Å": 1e-10, "pm": 1e-12,
    "cm": 1e-2, "km": 1e3,
}  # fmt: skip
#: a file with more bytes than this is refused
MAX_BYTES = 1_000_000_000


def read(path: Path, _: Asked) -> Raw:
    """The file's first map or profile; pitch and unit where the file carries them.

    SurfaceTopography holds heights as [x, y] and sizes as number times pitch; here rows are y.
    """
    size = max(path.stat().st_size, _unpacked(path))
    if size > MAX_BYTES:
        raise InputError(
            f"{path.name} must have at most {MAX_BYTES / 1e6:.0f} MB, unpacked too, got "
            f"{size / 1e6:.0f} MB"
        )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a library's imports and of its readers
        found, kind, channels = _topography(path)
        values: np.ndarray = np.ma.filled(np.ma.asarray(found.heights(), float), np.nan)
    if found.dim == 2:
        values = np.ascontiguousarray(values.T)
    unit = found.unit if found.unit in _UNITS else None
    done = (f"the first of its {channels} channels is used",) if channels > 1 else ()
    return Raw(
        values,
        f"{kind}, read by SurfaceTopography",
        unit=unit,
        scale=_UNITS[unit] if unit else None,
        pitch=_spacing(found, path) * _UNITS[unit] if unit and found.physical_sizes else None,
        spacing=None if unit or not found.physical_sizes else _spacing(found, path),
        done=done,
    )


def _unpacked(path: Path) -> int:
    """Bytes that a file unpacks to, if it is a zip archive, as many of these formats are; or 0."""
    if not zipfile.is_zipfile(path):
        return 0
    with zipfile.ZipFile(path) as archive:
        return sum(entry.file_size for entry in archive.infolist())


def _topography(path: Path) -> tuple[Any, str, int]:
    """The first channel of the file, the format that it is in, the number of channels."""
    try:
        from SurfaceTopography.IO import readers
    except ImportError:
        raise InputError(
            f"{path.name} must be read with SurfaceTopography, got an installation without it: "
            "pip install tyrecontact[scans]"
        ) from None
    ending = path.suffix.lower().lstrip(".")
    fitting = [reader for reader in readers if ending in (reader._file_extensions or ())]
    for place, reader in enumerate(fitting):
        try:
            with reader(str(path)) as file:
                channel = file.default_channel
                require_size(float(np.prod(channel.nb_grid_pts)), path)
                return channel.topography(), reader.format(), len(file.channels)
        except InputError:
            raise
        except Exception:
            if place == len(fitting) - 1:
                raise
    raise InputError(f"{path.name} must be of a format that SurfaceTopography knows, got .{ending}")


def _spacing(found: Any, path: Path) -> float:
    """Distance of heights in the file's unit: the size is the number of heights times that."""
    if not found.is_uniform:
        raise InputError(f"heights of {path.name} must be equally spaced, got an uneven line")
    steps = [size / count for size, count in zip(
        found.physical_sizes, found.nb_grid_pts, strict=True)]  # fmt: skip
    require_square(steps[0], steps[-1], path)
    return float(steps[0])
