"""Text files of heights, plain or gzip-ed: matrix, ESRI grid, or lines of named columns."""

from __future__ import annotations

import gzip
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import IO

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road import scan
from tyrecontact.road.formats.columns import Header, from_columns
from tyrecontact.road.formats.raw import NO_DATA, Asked, Raw, require_size

#: a text with more bytes than this, unpacked, is refused
MAX_TEXT_BYTES = 512_000_000
#: lines in which a header must end
_HEAD = 200
_ESRI = ("ncols", "nrows", "cellsize")


def read(path: Path, _: Asked) -> Raw:
    """A matrix of numbers, an ESRI ASCII grid, or a profilometer's lines of named columns.

    Numbers stand between white space, commas or semicolons; # begins a comment.
    """
    with opened(path) as lines:
        head = list(islice(data_lines(lines), _HEAD))
    if not head:
        raise InputError(f"road file must hold numbers, got {path.name}, which is empty")
    header = _header(head)
    keys = {line.split()[0].lower(): line.split()[-1] for line in header.lines}
    if all(key in keys for key in _ESRI):
        return _esri(path, header, keys)
    if header.lines:
        return from_columns(numbers(path, header), header, path)
    heights = numbers(path, header)
    if heights.shape[1] in (2, 3) and heights.shape[0] > 100:
        raise InputError(
            f"columns must be named in a first line such as 'distance (mm) height (mm)', got "
            f"{path.name} with {heights.shape[1]} columns of {heights.shape[0]} numbers without "
            "names (x y z columns of a map belong in a file .xyz)"
        )
    if 1 in heights.shape:
        return Raw(heights.ravel(), "text, one column")
    return Raw(heights, "text matrix")


@contextmanager
def opened(path: Path) -> Iterator[Iterator[str]]:
    """The lines of a text, unpacked if its name ends in .gz; refused when they grow too long."""
    size = path.stat().st_size
    if size > MAX_TEXT_BYTES:
        raise InputError(
            f"{path.name} must have at most {MAX_TEXT_BYTES / 1e6:.0f} MB, got {size / 1e6:.0f} MB"
        )
    packed = path.suffix.lower() == ".gz"
    opener = gzip.open if packed else open
    # old instruments write µ in other encodings; such a mark in a number is refused as no number
    with opener(path, "rt", encoding="utf-8-sig", errors="replace") as file:
        yield _limited(file, path) if packed else iter(file)


def _limited(file: IO[str], path: Path) -> Iterator[str]:
    """Lines of a packed text; a bomb is refused after what may be unpacked at most."""
    left = MAX_TEXT_BYTES
    while line := file.readline(min(left, 1_000_000) + 1):
        left -= len(line)
        if left < 0 or len(line) > 1_000_000:
            raise InputError(
                f"{path.name} must have at most {MAX_TEXT_BYTES / 1e6:.0f} MB unpacked and lines "
                "of at most 1 MB, got more"
            )
        yield line


def data_lines(lines: Iterable[str]) -> Iterator[str]:
    """Lines without their comments, those that are then empty left out."""
    return filter(None, (line.partition("#")[0].strip() for line in lines))


def delimiter_of(line: str) -> str | None:
    """What stands between the numbers of a line; None: white space."""
    return next((mark for mark in ";," if mark in line), None)


def numbers(path: Path, header: Header) -> np.ndarray:
    """All numbers after the header [-], shape (lines, columns)."""
    with opened(path) as lines:
        values = np.loadtxt(
            islice(data_lines(lines), header.skipped, None),
            delimiter=header.delimiter,
            ndmin=2,
            max_rows=scan.MAX_HEIGHTS // header.columns + 1,
        )
    require_size(values.size, path)
    return values


def _header(head: list[str]) -> Header:
    """What stands before the first line of numbers; nothing, if no such line comes."""
    for place, line in enumerate(head):
        delimiter = delimiter_of(line)
        fields = [field for field in line.split(delimiter) if field.strip()]
        if _numeric(fields):
            return Header(tuple(head[:place]), delimiter, len(fields))
    return Header((), delimiter_of(head[0]), 1)


def _numeric(fields: list[str]) -> bool:
    try:
        return bool([float(field) for field in fields])
    except ValueError:
        return False


def _esri(path: Path, header: Header, keys: dict[str, str]) -> Raw:
    """ESRI ASCII grid: its first row is the northernmost, so rows are turned about."""
    columns, rows, cell = int(keys["ncols"]), int(keys["nrows"]), float(keys["cellsize"])
    require_size(columns * rows, path)
    values = numbers(path, header)
    if values.size != columns * rows:
        raise InputError(
            f"{path.name} must hold nrows x ncols = {rows * columns} heights, got {values.size}"
        )
    missing = float(keys.get("nodata_value", NO_DATA))
    heights = values.reshape(rows, columns)[::-1].copy()
    heights[heights == missing] = np.nan
    return Raw(heights, "ESRI grid", spacing=cell, done=(f"{missing:g} taken as missing",))
