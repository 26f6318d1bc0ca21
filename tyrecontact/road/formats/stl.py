"""Triangulated scans (`.stl`, binary or text): the upper surface on a grid. No unit in the file."""

from __future__ import annotations

import gzip
import io
from array import array
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road import scan
from tyrecontact.road.formats.raw import Asked, Raw
from tyrecontact.road.gridding import largest_square

#: a file with more bytes than this, unpacked, is refused
MAX_BYTES = 200_000_000
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read(path: Path, asked: Asked) -> Raw:
    """The largest square in the outline, on a grid of the given pitch or as fine as the facets."""
    content = _content(path)
    triangles, kind = _triangles(content, path)
    made = largest_square(triangles, asked.step, scan.MAX_HEIGHTS)
    return Raw(made.heights, kind, spacing=made.step, resampled=True, done=made.done)


def _content(path: Path) -> bytes:
    packed = path.suffix.lower() == ".gz"
    with gzip.open(path) if packed else path.open("rb") as file:
        content = file.read(MAX_BYTES + 1)
    if len(content) > MAX_BYTES:
        raise InputError(f"{path.name} must have at most {MAX_BYTES / 1e6:.0f} MB, got more")
    return content


def _triangles(content: bytes, path: Path) -> tuple[np.ndarray, str]:
    """Corners, shape (n, 3, 3). Binary files may begin with "solid" too: their length tells."""
    count = int.from_bytes(content[80:84], "little")
    if len(content) == 84 + count * _TRIANGLE.itemsize and count:
        return np.frombuffer(content, _TRIANGLE, count, 84)["corners"], "STL, binary"
    if not content.lstrip()[:5].lower() == b"solid":
        raise InputError(
            f"{path.name} must be an STL file, got {len(content)} bytes for {count} triangles"
        )
    corners = array("d")  # lists of so many numbers would take ten times the room
    for line in io.BytesIO(content):
        if line.lstrip().startswith(b"vertex"):
            corners.extend(map(float, line.split()[1:4]))
    if not corners or len(corners) % 9 or b"endsolid" not in content[-400:]:
        raise InputError(
            f"{path.name} must hold whole triangles up to its 'endsolid', got "
            f"{len(corners)} coordinates"
        )
    return np.array(corners).reshape(-1, 3, 3), "STL, text"
