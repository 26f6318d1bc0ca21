"""ISO 5436-2 (`.x3p`): a zip archive of `main.xml` and, often, of binary heights; all in metres.

Heights are stored x fastest. Missing ones are empty tags, NaN, or zeros in a file of bits, the
lowest bit first.
"""

from __future__ import annotations

import hashlib
import itertools
import zipfile
from pathlib import Path
from xml.etree import ElementTree
from xml.parsers import expat

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.formats.raw import Asked, Raw, require_size, require_square

#: kinds of numbers by their letter in the file (openGPS: all little-endian)
_TYPES = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}
#: a main.xml with more bytes than this is refused (heights as text are 25 bytes each)
MAX_XML_BYTES = 100_000_000
#: a main.xml with more elements than this is refused: each takes a hundred bytes of memory
MAX_ELEMENTS = 2_000_000


def read(path: Path, _: Asked) -> Raw:
    """A map (SUR) or a profile (PRF) with incremental axes.

    Raises
    ------
    InputError : another kind of record, sizes that do not match, hostile or damaged content.
    """
    with zipfile.ZipFile(path) as archive:
        raw = _member(archive, "main.xml", MAX_XML_BYTES, path)
        root = _parsed(raw, path)
        rows, columns = _shape(root, path)
        require_size(rows * columns, path)
        values = _linked(archive, root, rows * columns, path)
        checksum = _checksum(archive, raw, root)
    if values is None:
        values = _listed(root, rows * columns, path)
    scale, offset = (_number(root, f"Record1/Axes/CZ/{what}", default) for what, default in
                     (("Increment", 1.0), ("Offset", 0.0)))  # fmt: skip
    pitch = _increment(root, "CX", path)
    if rows > 1:
        require_square(pitch, _increment(root, "CY", path), path)
    heights = (values * scale + offset).reshape(rows, columns)
    return Raw(
        heights if rows > 1 else heights[0],
        "x3p (ISO 5436-2)",
        unit="m",
        scale=1.0,
        pitch=pitch,
        done=checksum,
    )


def _member(archive: zipfile.ZipFile, name: str, most: int, path: Path) -> bytes:
    """A file of the archive; its length is known before, and held to while, it is unpacked."""
    try:
        info = archive.getinfo(name.removeprefix("./"))
    except KeyError:
        raise InputError(f"{path.name} must hold {name}, which is not in it") from None
    with archive.open(info) as file:
        content = b"" if info.file_size > most else file.read(most + 1)
    if max(info.file_size, len(content)) > most:
        raise InputError(
            f"{name} in {path.name} must unpack to at most {most} bytes, got {info.file_size}"
        )
    return content


def _parsed(raw: bytes, path: Path) -> ElementTree.Element:
    """The tree of a document; one that declares entities or has no end is refused before."""
    count = itertools.count(1)

    def declared(*_: object) -> None:
        raise InputError(f"main.xml in {path.name} must have no DOCTYPE and no entities")

    def begun(*_: object) -> None:
        if next(count) > MAX_ELEMENTS:
            raise InputError(
                f"main.xml in {path.name} must have at most {MAX_ELEMENTS:g} elements, got more "
                "(larger maps are stored in binary)"
            )

    first = expat.ParserCreate()
    first.StartDoctypeDeclHandler = first.EntityDeclHandler = declared
    first.StartElementHandler = begun
    first.Parse(raw, True)
    return ElementTree.fromstring(raw)


def _text(root: ElementTree.Element, where: str) -> str | None:
    found = root.findtext(where)
    return found.strip() if found and found.strip() else None


def _number(root: ElementTree.Element, where: str, default: float) -> float:
    text = _text(root, where)
    return default if text is None else float(text)


def _increment(root: ElementTree.Element, axis: str, path: Path) -> float:
    """The step of an axis [m]."""
    kind = _text(root, f"Record1/Axes/{axis}/AxisType")
    step = _number(root, f"Record1/Axes/{axis}/Increment", 1.0)
    if kind != "I" or not 0 < step < np.inf:
        raise InputError(
            f"axis {axis} of {path.name} must be incremental ('I') with a positive increment, "
            f"got {kind!r} with {step} m"
        )
    return step


def _shape(root: ElementTree.Element, path: Path) -> tuple[int, int]:
    """Rows and columns; a profile has one row."""
    feature = _text(root, "Record1/FeatureType")
    listed = _text(root, "Record3/ListDimension")
    size = [_text(root, f"Record3/MatrixDimension/Size{axis}") for axis in "XYZ"]
    if feature == "PRF" and listed is not None:
        size = [listed, "1", "1"]
    if feature not in ("SUR", "PRF") or size[0] is None or int(size[2] or 1) != 1:
        raise InputError(
            f"{path.name} must hold a surface or a profile on a matrix of one layer, got feature "
            f"{feature!r} with sizes {size}"
        )
    rows, columns = int(size[1] or 1), int(size[0])
    if not min(rows, columns) > 0:
        raise InputError(f"{path.name} must have sizes above 0, got {columns} x {rows}")
    return rows, columns


def _linked(
    archive: zipfile.ZipFile, root: ElementTree.Element, count: int, path: Path
) -> np.ndarray | None:
    """Heights of the binary file, if there is one."""
    link = _text(root, "Record3/DataLink/PointDataLink")
    if link is None:
        return None
    letter = _text(root, "Record1/Axes/CZ/DataType") or "D"
    if letter not in _TYPES:
        raise InputError(f"heights of {path.name} must be of type I, L, F or D, got {letter!r}")
    kind = np.dtype(_TYPES[letter])
    content = _member(archive, link, count * kind.itemsize, path)
    if len(content) != count * kind.itemsize:
        raise InputError(
            f"{link} in {path.name} must have {count * kind.itemsize} bytes, got {len(content)}"
        )
    values = np.frombuffer(content, kind).astype(float)
    valid = _text(root, "Record3/DataLink/ValidPointsLink")
    if valid is not None:
        bits = np.frombuffer(_member(archive, valid, count // 8 + 1, path), np.uint8)
        if 8 * bits.size < count:
            raise InputError(f"{valid} in {path.name} must have {count} bits, got {8 * bits.size}")
        values[np.unpackbits(bits, bitorder="little")[:count] == 0] = np.nan
    return values


def _listed(root: ElementTree.Element, count: int, path: Path) -> np.ndarray:
    """Heights of the text; an empty tag is a missing one."""
    found = root.find("Record3/DataList")
    texts = [] if found is None else [(datum.text or "").strip() for datum in found]
    if len(texts) != count:
        raise InputError(f"{path.name} must hold {count} heights, got {len(texts)}")
    return np.array([float(text.rpartition(";")[2]) if text else np.nan for text in texts])


def _checksum(archive: zipfile.ZipFile, raw: bytes, root: ElementTree.Element) -> tuple[str, ...]:
    name = _text(root, "Record4/ChecksumFile")
    if name is None or name not in archive.namelist():
        return ()
    with archive.open(name) as file:
        stated = file.read(64).split()
    if stated and stated[0].decode("ascii", "replace").lower() == hashlib.md5(raw).hexdigest():
        return ("checksum of main.xml is right",)
    return ("checksum of main.xml is wrong: it was changed after it was written",)
