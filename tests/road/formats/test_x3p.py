"""ISO 5436-2: binary and text heights, missing ones, metres; hostile archives and XML."""

from __future__ import annotations

import hashlib
import zipfile
from pathlib import Path

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scans
from tyrecontact.road.formats import x3p

HEIGHTS = np.random.default_rng(1).standard_normal((5, 7)) * 1e-5
LETTERS = {"D": "<f8", "F": "<f4", "L": "<i4", "I": "<i2"}


def main_xml(data: str, letter: str = "D", scaling: str = "", **change: str) -> str:
    parts = {"feature": "SUR", "axis": "I", "dx": "2.5e-5", "dy": "2.5e-5", "size": "7,5,1"}
    parts |= change
    nx, ny, nz = parts["size"].split(",")
    return f"""<?xml version="1.0" encoding="UTF-8"?>{change.get("doctype", "")}
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1>
<FeatureType>{parts["feature"]}</FeatureType><Axes>
<CX><AxisType>{parts["axis"]}</AxisType><Increment>{parts["dx"]}</Increment></CX>
<CY><AxisType>I</AxisType><Increment>{parts["dy"]}</Increment></CY>
<CZ><AxisType>A</AxisType><DataType>{letter}</DataType>{scaling}</CZ></Axes></Record1>
<Record3><MatrixDimension><SizeX>{nx}</SizeX><SizeY>{ny}</SizeY><SizeZ>{nz}</SizeZ>
</MatrixDimension>{data}</Record3>
<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4></p:ISO5436_2>"""


LINK = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>{}</DataLink>"
VALID = "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>"


def archive(path: Path, xml: str, **files: bytes) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("main.xml", xml)
        for name, content in files.items():
            made.writestr(f"bindata/{name}.bin", content)
    return path


def listed(values: np.ndarray) -> str:
    data = ("<Datum/>" if np.isnan(v) else f"<Datum>{float(v)!r}</Datum>" for v in values.ravel())
    return f"<DataList><!-- x fastest -->{''.join(data)}</DataList>"


def refusal(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        scans.read(path)
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize("letter", LETTERS)
def test_binary_heights_of_every_type_are_metres(tmp_path: Path, letter: str) -> None:
    step = 1e-9 if letter in "LI" else 1.0
    offset = 2e-6 if letter in "LI" else 0.0
    stored = (HEIGHTS - offset) / step
    stored = (np.rint(stored) if letter in "LI" else stored).astype(LETTERS[letter])
    scaling = f"<Increment>{step}</Increment><Offset>{offset}</Offset>"
    xml = main_xml(LINK.format(""), letter, scaling if letter in "LI" else "")
    found = scans.read(archive(tmp_path / "a.x3p", xml, data=stored.tobytes()))
    # half a step of the integers; rounding of single precision
    np.testing.assert_allclose(found.heights, HEIGHTS, atol=0.51e-9 if step < 1 else 1e-11)
    assert (found.pitch, found.unit, found.pitch_origin, found.unit_origin) == (
        2.5e-5, "m", "file", "file",
    )  # fmt: skip
    assert found.extent == pytest.approx((5 * 2.5e-5, 7 * 2.5e-5))  # n times increment, (y, x)


def test_text_and_binary_heights_are_the_same_with_the_same_missing(tmp_path: Path) -> None:
    """Missing: an empty tag, NaN, or a zero bit (the lowest of a byte first)."""
    holed = HEIGHTS.copy()
    holed.ravel()[[3, 10, 34]] = np.nan
    text = scans.read(archive(tmp_path / "a.x3p", main_xml(listed(holed))))
    nan = scans.read(archive(tmp_path / "b.x3p", main_xml(LINK.format("")), data=holed.tobytes()))
    bits = np.packbits(~np.isnan(holed.ravel()), bitorder="little").tobytes()
    whole = np.nan_to_num(holed).tobytes()
    xml = main_xml(LINK.format(VALID))
    masked = scans.read(archive(tmp_path / "c.x3p", xml, data=whole, valid=bits))
    for found in (text, nan, masked):
        np.testing.assert_array_equal(found.heights, holed)
        assert found.missing_share == pytest.approx(3 / 35)


def test_a_profile_is_read(tmp_path: Path) -> None:
    for size, extra in (("7,1,1", ""), ("7,1,1", "<ListDimension>7</ListDimension>")):
        xml = main_xml(listed(HEIGHTS[0]) + extra, feature="PRF", size=size)
        found = scans.read(archive(tmp_path / "a.x3p", xml))
        np.testing.assert_array_equal(found.heights, HEIGHTS[0])


def test_a_checksum_is_looked_at_and_told(tmp_path: Path) -> None:
    xml = main_xml(listed(HEIGHTS))
    for digest, word in ((hashlib.md5(xml.encode()).hexdigest(), "right"), ("0" * 32, "wrong")):
        path = archive(tmp_path / "a.x3p", xml)
        with zipfile.ZipFile(path, "a") as made:
            made.writestr("md5checksum.hex", f"{digest} *main.xml\n")
        assert any(f"checksum of main.xml is {word}" in clause for clause in scans.read(path).done)


@pytest.mark.parametrize(
    ("xml", "sentence"),
    [
        (main_xml(listed(HEIGHTS), axis="A"), "must be incremental"),
        (main_xml(listed(HEIGHTS), dx="0"), "positive increment"),
        (main_xml(listed(HEIGHTS), dy="3e-5"), "equally spaced along x and y"),
        (main_xml(listed(HEIGHTS), feature="PCL"), "a surface or a profile"),
        (main_xml(listed(HEIGHTS), size="7,5,2"), "one layer"),
        (main_xml(listed(HEIGHTS), size="7,-5,1"), "sizes above 0"),
        (main_xml(listed(HEIGHTS), size="7,6,1"), "must hold 42 heights, got 35"),
        (main_xml(listed(HEIGHTS), size="90000,90000,1"), "at most 6.4e+07 heights"),
        (main_xml(LINK.format("")), "bindata/data.bin, which is not in it"),
        (main_xml(LINK.format(""), letter="X"), "type I, L, F or D"),
        ("<a>", "must hold a matrix of numbers"),
        ("", "must hold a matrix of numbers"),
    ],
)  # fmt: skip
def test_what_cannot_be_used_is_refused(tmp_path: Path, xml: str, sentence: str) -> None:
    assert sentence in refusal(archive(tmp_path / "a.x3p", xml))


def test_entities_are_not_expanded(tmp_path: Path) -> None:
    """A few lines that would expand to gigabytes, or read the machine's files."""
    laughs = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 10))
    for declared in (f'<!ENTITY a0 "ha">{laughs}', '<!ENTITY a9 SYSTEM "file:///etc/passwd">'):
        xml = main_xml("<DataList>&a9;</DataList>", doctype=f"<!DOCTYPE x [{declared}]>")
        assert "must have no DOCTYPE and no entities" in refusal(archive(tmp_path / "a.x3p", xml))


def test_bombs_are_refused_by_their_size_before_they_are_unpacked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(x3p, "MAX_XML_BYTES", 1_000_000)
    path = archive(tmp_path / "a.x3p", main_xml(" " * 5_000_000))
    assert path.stat().st_size < 10_000
    assert "main.xml in a.x3p must unpack to at most 1000000 bytes, got 500" in refusal(path)
    monkeypatch.setattr(x3p, "MAX_ELEMENTS", 1000)
    path = archive(tmp_path / "c.x3p", main_xml("<a/>" * 1000))
    assert "must have at most 1000 elements" in refusal(path)
    path = archive(tmp_path / "b.x3p", main_xml(LINK.format("")), data=bytes(5_000_000))
    assert "must unpack to at most 280 bytes, got 5000000" in refusal(path)


def test_an_archive_that_is_cut_off_or_short_is_refused(tmp_path: Path) -> None:
    path = archive(tmp_path / "a.x3p", main_xml(LINK.format("")), data=HEIGHTS.tobytes())
    whole = path.read_bytes()
    for length in (0, 10, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole[:length])
        assert "a.x3p" in refusal(path)
    short = archive(tmp_path / "b.x3p", main_xml(LINK.format("")), data=bytes(8))
    assert "must have 280 bytes, got 8" in refusal(short)
