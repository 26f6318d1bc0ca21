"""Text files: matrices, ESRI grids and lines of named columns; plain and packed."""

from __future__ import annotations

import gzip
from pathlib import Path

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scan, scans
from tyrecontact.road.formats import text

ESRI = """ncols 3
nrows 2
xllcorner 1000.0
yllcorner 2000.0
cellsize 0.5
NODATA_value -32768
1 2 -32768
4 5 6
"""
PROFILE = "Road\tA 1\n\nDate\t1/2/2021\n***DATA***\nNo:\tDistance (mm)\tDepth (mm)\n"


def written(path: Path, content: str) -> Path:
    path.write_bytes(gzip.compress(content.encode()) if path.suffix == ".gz" else content.encode())
    return path


def lines(count: int = 40, end: str = "\n") -> str:
    """No, distance and height; heights 0, 1, 2, ... um and every tenth missing."""
    rows = (f"{n}\t{n * 0.0375:.3f}\t{'NaN' if n % 10 == 9 else n * 1e-3:}" for n in range(count))
    return end.join(rows) + end


def refusal(path: Path, pitch: float | None = 1e-3, unit: str | None = "mm") -> str:
    with pytest.raises(InputError) as caught:
        scans.read(path, pitch, unit)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_a_packed_matrix_is_read_like_a_plain_one(tmp_path: Path) -> None:
    content = "1,2,3\n4,5,6\n"
    plain = scans.read(written(tmp_path / "a.csv", content), 1e-3, "mm")
    packed = scans.read(written(tmp_path / "a.csv.gz", content), 1e-3, "mm")
    np.testing.assert_array_equal(packed.heights, plain.heights)


def test_an_esri_grid_has_its_pitch_its_missing_heights_and_its_north(tmp_path: Path) -> None:
    """Its first row is the northernmost: y grows with the row here. Its unit is asked for."""
    path = written(tmp_path / "a.asc", ESRI)
    assert "unit must be given" in refusal(path, None, None)
    found = scans.read(path, unit="mm")
    assert found.pitch == pytest.approx(0.5e-3)
    assert (found.pitch_origin, found.unit_origin) == ("file", "given")
    np.testing.assert_allclose(found.heights * 1e3, [[4, 5, 6], [1, 2, np.nan]])
    assert "-32768 taken as missing" in found.done


def test_an_esri_grid_without_all_its_heights_is_refused(tmp_path: Path) -> None:
    path = written(tmp_path / "a.asc", ESRI.replace("nrows 2", "nrows 3"))
    assert "must hold nrows x ncols = 9 heights, got 6" in refusal(path)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r\r\n"])
@pytest.mark.parametrize("name", ["a.dat", "a.txt.gz"])
def test_a_profilometers_lines_tell_pitch_and_unit(tmp_path: Path, name: str, end: str) -> None:
    content = PROFILE.replace("\n", end) + lines(end=end)
    found = scans.read(written(tmp_path / name, content))
    assert found.pitch == pytest.approx(37.5e-6, rel=1e-3)  # distances are rounded to 1 um
    assert (found.pitch_origin, found.unit, found.unit_origin) == ("file", "mm", "file")
    assert found.missing_share == 0.1
    np.testing.assert_allclose(found.heights[:9], np.arange(9) * 1e-6, atol=1e-18)  # rounding
    assert found.done == (
        "4 lines of header skipped",
        "column 3, 'Depth (mm)', read as height, positive up (if it counts down: height_direction)",
        "distances from column 2, 'Distance (mm)'",
        "not used: 'No:'",
    )


@pytest.mark.parametrize("encoding", ["utf-8", "cp1252"])
def test_micrometres_are_known_in_any_encoding(tmp_path: Path, encoding: str) -> None:
    content = "Position [mm];Height [µm]\n0.0;1\n0.5;2\n1.0;4\n"
    (tmp_path / "a.csv").write_bytes(content.encode(encoding))
    found = scans.read(tmp_path / "a.csv")
    assert (found.unit, found.pitch) == ("um", pytest.approx(0.5e-3))
    np.testing.assert_allclose(found.heights, [1e-6, 2e-6, 4e-6])


def test_what_the_user_gives_overrides_what_a_file_carries_and_is_said(tmp_path: Path) -> None:
    path = written(tmp_path / "a.dat", PROFILE + lines())
    same = scans.read(path, 37.5e-6, "mm")
    assert (same.pitch_origin, same.unit_origin) == ("file", "file")
    other = scans.read(path, 50e-6, "um")
    assert (other.pitch, other.unit) == (50e-6, "um")
    np.testing.assert_allclose(other.heights, same.heights * 1e-3)
    assert "unit um as given, against mm in the file" in other.done
    assert any("pitch 50 µm as given, against 37.4872 µm" in clause for clause in other.done)


@pytest.mark.parametrize(
    ("names", "sentence"),
    [
        ("No\tDistance (mm)\tWidth (mm)", "one column of heights"),
        ("Height (mm)\tDistance (mm)\tDepth (mm)", "one column of heights"),
        ("x (mm)\tDistance (mm)\tDepth (mm)", "one column of distances"),
        ("No\tTime (s)\tDepth (mm)", "pitch must be given"),
        ("No\tDistance (mm)\tDepth", "unit must be given"),
        ("No\tDistance\tDepth (mm)", "pitch must be given"),
    ],
)
def test_a_column_or_unit_that_is_not_named_is_asked_for(
    tmp_path: Path, names: str, sentence: str
) -> None:
    path = written(tmp_path / "a.dat", f"{names}\n{lines()}")
    assert sentence in refusal(path, None, None)


def test_many_columns_without_names_are_not_guessed_at(tmp_path: Path) -> None:
    path = written(tmp_path / "a.dat", lines(200))
    assert "columns must be named in a first line such as" in refusal(path)


def test_distances_that_are_not_regular_are_refused(tmp_path: Path) -> None:
    content = "distance (mm) height (mm)\n0 1\n1 1\n2 1\n5 1\n"
    assert "must grow in equal steps" in refusal(written(tmp_path / "a.txt", content), None, None)


def test_a_packed_bomb_is_refused_while_it_is_unpacked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(text, "MAX_TEXT_BYTES", 100_000)
    many = written(tmp_path / "a.txt.gz", "1 2\n" * 100_000)
    long = written(tmp_path / "b.txt.gz", "1 " * 1_000_000)
    assert many.stat().st_size < 1000
    for path in (many, long):
        assert "unpacked" in refusal(path)


def test_a_text_of_a_thousand_million_rows_is_refused_by_its_size(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    with path.open("wb") as file:
        file.truncate(2_000_000_000)  # a sparse file: it takes no room
    assert "must have at most 512 MB, got 2000 MB" in refusal(path)


def test_no_more_rows_are_kept_than_may_be(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A short text of many short rows: reading stops where the limit is passed."""
    monkeypatch.setattr(scan, "MAX_HEIGHTS", 1000)
    path = written(tmp_path / "a.txt", "1\n" * 50_000)
    assert "must hold at most 1000 heights, got 1001" in refusal(path)


@pytest.mark.parametrize("cut", [10, 30])
def test_a_packed_text_that_is_cut_off_is_refused(tmp_path: Path, cut: int) -> None:
    path = written(tmp_path / "a.txt.gz", PROFILE + lines())
    path.write_bytes(path.read_bytes()[:-cut])
    assert refusal(path).startswith("road file must hold a matrix of numbers, got a.txt.gz")
