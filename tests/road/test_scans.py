"""Files of measured roads: what is read, and what is refused in one sentence."""

from __future__ import annotations

import gc
import gzip
import io
import os
import pickle
import warnings
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scan, scans
from tyrecontact.road.formats import text

HEIGHTS = np.random.default_rng(1).standard_normal((5, 4)) * 10
PITCH = 1e-4
NOT_NUMBERS = "road file must hold a matrix of numbers, got "


def stored(path: Path, content: Any) -> Path:
    """A file of a text, of bytes, or of an array (in the archive's `heights` for .npz)."""
    if isinstance(content, bytes | str):
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
    elif path.suffix == ".npz":
        np.savez_compressed(path, allow_pickle=True, heights=content)
    else:
        np.save(path, content, allow_pickle=True)
    return path


def in_memory(save: Any, *arrays: np.ndarray, **named: np.ndarray) -> bytes:
    file = io.BytesIO()
    save(file, *arrays, **named)
    return file.getvalue()


def table(separator: str, before: str = "", end: str = "\n") -> str:
    rows = (separator.join(repr(float(value)) for value in row) for row in HEIGHTS)
    return before + end.join(rows) + end


def refusal(path: Path, pitch: float | None = PITCH, unit: str | None = "um") -> str:
    with pytest.raises(InputError) as caught:
        scans.read(path, pitch, unit)
    assert "\n" not in str(caught.value)
    return str(caught.value)


TEXTS = {
    "a.txt": table(" "), "b.txt": table("   ", before="  "), "c.dat": table("\t"),
    "d.tsv": table("\t", before="# x;y\n\n"), "e.csv": table(","), "h.asc": table(" ") + "# end\n",
    "f.csv": table(", ", before="# a comment\n"), "g.CSV": table(";", end="\r\n"),
}  # fmt: skip


@pytest.mark.parametrize("name", TEXTS)
def test_a_text_matrix_is_read_as_it_is(tmp_path: Path, name: str) -> None:
    patch = scans.read(stored(tmp_path / name, TEXTS[name]), PITCH, "m")
    np.testing.assert_array_equal(patch.heights, HEIGHTS)
    assert patch.pitch == PITCH


@pytest.mark.parametrize(("unit", "factor"), [("m", 1.0), ("mm", 1e-3), ("um", 1e-6)])
@pytest.mark.parametrize("kind", [">f8", np.float32, np.int16, np.uint8])
def test_any_real_numbers_become_metres(
    tmp_path: Path, unit: str, factor: float, kind: Any
) -> None:
    values = np.arange(12.0).reshape(3, 4)
    patch = scans.read(str(stored(tmp_path / "a.npy", values.astype(kind))), 2e-5, unit)
    assert (patch.heights.dtype, patch.pitch) == (float, 2e-5)
    np.testing.assert_array_equal(patch.heights, values * factor)


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_an_archive_gives_its_heights_or_its_only_array(tmp_path: Path, save: Any) -> None:
    for arrays in ({"mask": np.ones(3), "heights": HEIGHTS}, {"z": HEIGHTS}):
        path = stored(tmp_path / "a.npz", in_memory(save, **arrays))
        np.testing.assert_array_equal(scans.read(path, PITCH, "m").heights, HEIGHTS)


def test_an_archive_that_does_not_say_which_is_refused(tmp_path: Path) -> None:
    for arrays in ({}, {"y": HEIGHTS, "z": HEIGHTS}):
        path = stored(tmp_path / "a.npz", in_memory(np.savez, **arrays))
        assert "'heights' or a single array" in refusal(path)


def test_pitch_unit_and_kind_of_file_must_be_given_and_known(tmp_path: Path) -> None:
    path = stored(tmp_path / "a.npy", HEIGHTS)
    assert refusal(path, pitch=None).startswith("pitch must be given")
    assert refusal(path, unit=None).startswith("unit must be given as m, mm or um")
    for pitch in (0.0, -1e-4, np.nan, np.inf):
        message = f"pitch must be positive and finite, got {pitch} m"
        assert refusal(path, pitch=pitch) == message
    assert "must be one of m, mm, um, got 'umm' (did you mean 'um'?)" in refusal(path, unit="umm")
    assert refusal(path, unit="MM").endswith("must be one of m, mm, um, got 'MM'")
    for name in ("a", "a.pickle", "a.gz"):
        sentence = refusal(tmp_path / name)
        assert all(f"{ending}, " in sentence for ending in (".csv", ".npy", ".stl.gz", ".x3p"))
    assert "did you mean '.npy'?" in refusal(tmp_path / "a.ny")
    assert ".sur, " in (sentence := refusal(tmp_path / "a.surr"))
    assert "did you mean '.sur'?" in sentence


@pytest.mark.parametrize("suffix", [".npy", ".npz", ".csv", ".txt"])
def test_a_file_that_cannot_be_opened_is_refused_by_name(tmp_path: Path, suffix: str) -> None:
    (tmp_path / f"folder{suffix}").mkdir()
    assert f"got missing{suffix}: " in refusal(tmp_path / f"missing{suffix}")
    assert f"got folder{suffix}: " in refusal(tmp_path / f"folder{suffix}")


NO_MAPS = [
    ("", "is empty"), (" \n\n", "is empty"), ("# only\n# comments\n", "is empty"),
    ("1 2\n1 2 3\n", "number of columns changed"), ("x y\n1 2\n", "got a"),
    ("1,5;2,5\n3,5;4,5\n", "'1,5'"), ("1 2\n3 1+2j\n", "'1+2j'"), (b"1 2\n3 \xb5\n", "'\ufffd'"),
    ("1\n", "at least 2 x 2"), ("nan inf\ninf nan\n", "where all 4 are missing"),
    (np.ones(1), "shape (1,)"), (np.ones((2, 2, 2)), "shape (2, 2, 2)"),
    (np.ones((2, 2), complex), "complex128"), (np.ones((2, 2), bool), "bool"),
    (np.array([["a", "b"], ["c", "d"]]), "<U1"), (np.ones((0, 3)), "at least 2 x 2"),
    (np.full((9, 9), np.nan), "where all 81 are missing"),
]  # fmt: skip


@pytest.mark.parametrize(("content", "part"), NO_MAPS, ids=range(len(NO_MAPS)))
def test_what_is_no_height_map_is_refused_with_the_reason(
    tmp_path: Path, content: Any, part: str
) -> None:
    suffixes = (".npy", ".npz") if isinstance(content, np.ndarray) else (".csv", ".txt")
    for suffix in suffixes:
        assert part in refusal(stored(tmp_path / f"a{suffix}", content))


@pytest.mark.parametrize("suffix", [".npy", ".npz"])
def test_a_file_that_is_cut_off_is_refused(tmp_path: Path, suffix: str) -> None:
    path = stored(tmp_path / f"a{suffix}", HEIGHTS)
    whole = path.read_bytes()
    for length in (0, 1, 7, 60, 130, len(whole) - 1):
        assert refusal(stored(path, whole[:length])).startswith(NOT_NUMBERS)


@pytest.mark.parametrize("suffix", [".npy", ".npz"])
def test_nothing_is_unpickled(tmp_path: Path, suffix: str) -> None:
    target = tmp_path / "sprung"
    trap = type("Trap", (), {"__reduce__": lambda _: (os.mkdir, (str(target),))})()
    for content in (np.array([[trap]], object), pickle.dumps(trap)):
        assert refusal(stored(tmp_path / f"a{suffix}", content)).startswith(NOT_NUMBERS)
    assert not target.exists()
    pickle.loads(pickle.dumps(trap))
    assert target.exists()  # the trap works


@pytest.mark.parametrize("suffix", [".npy", ".npz", ".csv"])
def test_too_large_a_map_is_refused_by_its_size(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str
) -> None:
    """An archive before it is unpacked: its 32 kB of zeros take some 200 bytes."""
    monkeypatch.setattr(scan, "MAX_HEIGHTS", 1000)
    content = np.zeros((64, 64)) if suffix != ".csv" else "1 2 3 4 5\n" * 201
    path = stored(tmp_path / f"a{suffix}", content)
    if suffix == ".npz":
        monkeypatch.setattr(np, "load", None)
    assert f"a{suffix} must hold at most 1000 heights, got " in refusal(path)
    monkeypatch.setattr(text, "MAX_TEXT_BYTES", 1000)
    monkeypatch.setattr(np, "loadtxt", None)  # a long text is not read either
    assert " at most " in refusal(path)


def zipped(name: str, content: bytes, at: int = 0, byte: int = ord("P")) -> bytes:
    """A compressed archive of one file, one byte of it replaced."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(name, content)
    raw = file.getvalue()
    return raw[:at] + bytes([byte]) + raw[at + 1 :]


NPY = in_memory(np.save, HEIGHTS)
DIRECTORY = zipped("heights.npy", NPY).rindex(b"PK\1\2")
DAMAGED = {
    "stream.npz": zipped("heights.npy", NPY, 30 + len("heights.npy"), 0xFF),
    "encrypted.npz": zipped("heights.npy", NPY, DIRECTORY + 8, 1),
    "method.npz": zipped("heights.npy", NPY, DIRECTORY + 10, 99),
    "text.npz": zipped("read.me", b"1 2"),
    "header.npy": NPY.replace(b"{", b"\x84"),
}


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_file_is_refused_whatever_the_damage(tmp_path: Path, name: str) -> None:
    assert refusal(stored(tmp_path / name, DAMAGED[name])).startswith("road file must hold a ")


def test_an_archive_named_npy_is_refused_and_closed(tmp_path: Path) -> None:
    path = stored(tmp_path / "a.npy", in_memory(np.savez, HEIGHTS))
    gc.collect()  # what other tests have left open is not meant
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert refusal(path).startswith("road file must hold a ")
        gc.collect()
    assert not caught


def test_small_numbers_count(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(scan, "MAX_HEIGHTS", 1000)
    path = stored(tmp_path / "a.npz", np.zeros((64, 64), np.int8))
    assert "a.npz must hold at most 1000 heights, got 4096" in refusal(path)


@pytest.mark.parametrize(
    "content", ["1 2 # a, b\n3 4\n", " # a, b\n1 2\n3 4\n", "\ufeff1,2\n3,4\n"]
)
def test_comments_and_byte_order_marks_do_not_matter(tmp_path: Path, content: str) -> None:
    heights = scans.read(stored(tmp_path / "a.csv", content), PITCH, "m").heights
    assert heights.tolist() == [[1, 2], [3, 4]]


def test_pitch_and_unit_are_said_to_be_given(tmp_path: Path) -> None:
    found = scans.read(stored(tmp_path / "a.npy", HEIGHTS), PITCH, "mm")
    assert (found.pitch_origin, found.unit_origin, found.unit) == ("given", "given", "mm")
    assert (found.name, found.kind, found.done) == ("a.npy", "numpy array", ())
    assert found.extent == pytest.approx((5 * PITCH, 4 * PITCH))  # n times pitch, (y, x)


@pytest.mark.parametrize("suffix", [".npy", ".txt", ".csv.gz"])
def test_missing_heights_are_kept_as_missing_and_counted(tmp_path: Path, suffix: str) -> None:
    values = HEIGHTS.copy()
    values[1, 2], values[3, 0], values[4, 3] = np.nan, np.inf, -9999
    content: Any = values
    if suffix != ".npy":
        rows = "\n".join(" ".join(repr(float(value)) for value in row) for row in values)
        content = gzip.compress(rows.encode()) if suffix == ".csv.gz" else rows
    found = scans.read(stored(tmp_path / f"a{suffix}", content), PITCH, "mm")
    assert np.argwhere(~found.valid).tolist() == [[1, 2], [3, 0], [4, 3]]
    assert found.missing_share == pytest.approx(3 / 20)
    assert found.done == ("1 heights of -9999 taken as missing",)
    assert np.nanmax(np.abs(found.heights)) < 0.1  # no -9999 mm among them


def test_a_line_of_heights_is_a_profile(tmp_path: Path) -> None:
    for name, content in (("a.npy", HEIGHTS[:, 0]), ("a.txt", "1\n2\n3\n"), ("b.txt", "1 2 3\n")):
        found = scans.read(stored(tmp_path / name, content), PITCH, "m")
        assert found.is_profile
        assert found.extent == pytest.approx((len(found.heights) * PITCH,))


def test_an_ending_is_that_of_what_is_packed() -> None:
    assert scans.ending("a.b/Scan.DAT.gz") == ".dat.gz"
    assert scans.ending("scan.npy") == ".npy"
    assert scans.ending("scan") == ""
    assert all(scans.ending(f"road{ending}") == ending for ending in scans.ENDINGS)
