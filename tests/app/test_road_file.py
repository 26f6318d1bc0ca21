"""A road file is taken when it can be read, and refused in one sentence otherwise."""

from __future__ import annotations

import gzip
import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.road_file import RoadFile


class Taken:
    """Remembers what the control handed on."""

    def __init__(self) -> None:
        self.roads: list[tuple[str, float, str]] = []
        self.refusals: list[str] = []
        self.control = RoadFile(lambda *road: self.roads.append(road), self.refusals.append)

    def upload(self, name: str, content: bytes) -> None:
        self.control.file.filename = name
        self.control.file.value = content


@pytest.fixture
def taken() -> Iterator[Taken]:
    made = Taken()
    yield made
    made.control.close()


def _npy(heights: np.ndarray) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, heights)
    return buffer.getvalue()


def _road() -> np.ndarray:
    return np.random.default_rng(3).normal(0, 0.02, (200, 200))


def test_a_file_is_taken_once_pitch_and_unit_are_known(taken: Taken) -> None:
    taken.upload("my road.npy", _npy(_road()))
    assert "give its pitch" in taken.control.status.object
    taken.control.pitch.value = 100.0
    taken.control.unit.value = "mm"
    path, pitch, unit = taken.roads[-1]
    assert Path(path).exists()
    assert (pitch, unit) == (pytest.approx(1e-4), "mm")
    assert "20 x 20 mm" in taken.control.status.object
    assert "rms 19.9 µm" in taken.control.status.object


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("bad.npy", b"this is not numpy", "must hold a matrix of numbers"),
        ("words.txt", b"one two three\n", "must hold a matrix of numbers"),
        ("gap.npy", _npy(np.full((9, 9), np.nan)), "all 81 are missing"),
        ("photo.jpg", b"\xff\xd8\xff", "kind of road file"),
        ("cube.npy", _npy(np.zeros((3, 3, 3))), "2-D"),
    ],
)
def test_a_bad_file_is_refused_in_one_sentence_and_not_used(
    taken: Taken, name: str, content: bytes, says: str
) -> None:
    taken.control.pitch.value, taken.control.unit.value = 50.0, "mm"
    taken.upload(name, content)
    assert taken.roads[-1] == ("", 0.0, "")
    assert len(taken.refusals) == 1
    assert says in taken.refusals[0]
    assert "\n" not in taken.refusals[0]
    assert "/tmp" not in taken.refusals[0]
    assert taken.control.status.object.startswith("Not used")


def test_a_file_that_carries_pitch_and_unit_needs_neither(taken: Taken) -> None:
    lines = "distance (mm)\theight (mm)\n" + "".join(f"{n * 0.1:.1f}\t{n % 7}\n" for n in range(90))
    taken.upload("line.dat.gz", gzip.compress(lines.encode()))
    path, pitch, unit = taken.roads[-1]
    assert Path(path).name == "road.dat.gz"
    assert (pitch, unit) == (0.0, "")
    assert "pitch 100 µm (file), heights in mm (file)" in taken.control.status.object


def test_a_visitors_file_name_cannot_leave_the_sessions_folder(taken: Taken) -> None:
    taken.control.pitch.value, taken.control.unit.value = 50.0, "mm"
    taken.upload("../../../etc/evil.npy", _npy(_road()))
    assert Path(taken.roads[-1][0]).name == "road.npy"


def test_going_back_to_the_made_road_removes_the_file(taken: Taken) -> None:
    taken.control.pitch.value, taken.control.unit.value = 50.0, "mm"
    taken.upload("road.npy", _npy(_road()))
    path = Path(taken.roads[-1][0])
    assert path.exists()
    taken.control.forget()
    assert not path.parent.exists()
    assert taken.roads[-1] == ("", 0.0, "")
