"""A road file is confirmed before it is used, and a bad one is refused in one sentence."""

from __future__ import annotations

import gzip
import io
import time
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app import road_upload
from app.road_dialog import SETTINGS
from app.road_file import RoadFile
from app.road_reading import Reading
from tyrecontact import Scenario
from tyrecontact.assembly.road import road_patch
from tyrecontact.parts.road import Road


class Taken:
    """Remembers what the control handed on, and does what a visitor does."""

    def __init__(self) -> None:
        self.roads: list[dict[str, Any]] = []
        self.refusals: list[str] = []
        self.form = Road()
        self.control = RoadFile(self.take, self.refusals.append, lambda: self.form)

    def take(self, settings: dict[str, Any]) -> None:
        self.roads.append(settings)
        for path, value in settings.items():
            setattr(self.form, path.partition(".")[2], value)

    def upload(self, name: str, content: bytes) -> None:
        """As the browser does it."""
        upload, piece = self.control.upload, road_upload._PIECE
        pieces = -(-len(content) // piece)
        upload._handle_msg({"status": "initializing"})
        for number in range(pieces):
            part = content[number * piece : (number + 1) * piece]
            upload._handle_msg(
                {"status": "upload_event", "name": name, "data": part, "chunk": number + 1,
                 "total_chunks": pieces, "mime_type": ""}
            )  # fmt: skip
        upload._handle_msg({"status": "finished"})
        self.settle()

    def fill(self, **values: Any) -> None:
        for name, value in values.items():
            self.dialog.fields[name].value = value
        self.settle()

    def settle(self) -> None:
        for _ in range(3):  # an answer may ask once more, with a patch that fits
            assert self.control.work.join(60)
            self.control.arrive()

    @property
    def dialog(self) -> Any:
        assert self.control._asked is not None
        return self.control._asked

    @property
    def files(self) -> list[Path]:
        folder = self.control._folder
        return sorted(Path(folder.name).glob("*/*")) if folder else []


@pytest.fixture
def taken() -> Iterator[Taken]:
    made = Taken()
    yield made
    made.control.close()


def npy(heights: np.ndarray) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, heights, allow_pickle=True)
    return buffer.getvalue()


def road() -> np.ndarray:
    return np.random.default_rng(3).normal(0, 0.02, (300, 300))


def bring(taken: Taken, name: str = "my road.npy") -> None:
    taken.upload(name, npy(road()))
    taken.fill(pitch=100.0, height_unit="mm")


def test_nothing_is_used_before_it_is_confirmed(taken: Taken) -> None:
    taken.upload("my road.npy", npy(road()))
    assert "does not say the distance of its heights (pitch) and the unit" in (
        taken.dialog.message.object
    )
    assert taken.dialog.use_button.disabled
    taken.fill(pitch=100.0, height_unit="mm")
    assert "30.0 × 30.0 mm" in taken.dialog.facts.object
    assert "20.0 µm" in taken.dialog.facts.object
    assert "given by you" in taken.dialog.facts.object
    assert not taken.dialog.use_button.disabled
    assert not taken.roads
    taken.control.use()
    assert list(taken.roads[-1])[-1] == "road.file"
    assert taken.roads[-1]["road.pitch"] == pytest.approx(1e-4)
    assert taken.roads[-1]["road.height_unit"] == "mm"
    assert not taken.dialog.root.open
    assert "my road.npy: 30 x 30 mm" in taken.control.status.object


def test_what_is_used_makes_the_patch_that_the_dialog_promised(taken: Taken) -> None:
    bring(taken)
    taken.fill(size=10.0, centre_x=5.0, elements=10)
    taken.control.use()
    scenario = Scenario()
    for path, value in taken.roads[-1].items():
        scenario.set(path, value)
    patch = road_patch(scenario.road)
    assert patch.extent == pytest.approx((10e-3, 10e-3))
    expected = road()[100:200, 150:250] * 1e-3
    assert np.corrcoef(patch.heights.ravel(), expected.ravel())[0, 1] > 0.999


def test_pitch_and_unit_of_one_file_are_not_those_of_the_next(taken: Taken) -> None:
    bring(taken)
    taken.control.use()
    taken.upload("other.npy", npy(road()))
    assert taken.dialog.use_button.disabled
    assert taken.dialog.fields["pitch"].value == 0
    assert taken.dialog.fields["height_unit"].value == ""
    assert taken.dialog.fields["pitch"].error_state


def test_cancel_leaves_the_road_in_use_and_nothing_on_disk(taken: Taken) -> None:
    bring(taken)
    taken.control.use()
    taken.upload("other.npy", npy(road()))
    taken.control.cancel()
    assert [file.name for file in taken.files] == ["my road.npy"]
    assert len(taken.roads) == 1
    assert "my road.npy" in taken.control.status.object


def test_change_opens_the_dialog_on_the_file_and_values_in_use(taken: Taken) -> None:
    bring(taken)
    taken.fill(size=12.0)
    taken.control.use()
    taken.control.reopen()
    taken.settle()
    assert taken.dialog.root.open
    assert taken.dialog.fields["size"].value == pytest.approx(12.0)
    assert not taken.dialog.use_button.disabled
    taken.fill(levelling="none")
    taken.control.use()
    assert taken.roads[-1]["road.levelling"] == "none"
    assert taken.roads[-1]["road.file"] == taken.roads[0]["road.file"]
    taken.form.elements = 12  # changed on the form
    taken.control.reopen()
    taken.settle()
    assert taken.dialog.fields["elements"].value == 12


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("bad.npy", b"this is not numpy", "must hold a matrix of numbers"),
        ("words.txt", b"one two three\n", "must hold a matrix of numbers"),
        ("gap.npy", npy(np.full((9, 9), np.nan)), "all 81 are missing"),
        ("photo.jpg", b"\xff\xd8\xff", "kind of road file"),
        ("cube.npy", npy(np.zeros((3, 3, 3))), "2-D"),
        ("pickle.npy", npy(np.array([{}, ()], dtype=object)), "Python objects"),
        ("empty.npy", b"", "0 bytes"),
        ("no.x3p", b"PK\x03\x04", "must hold a matrix of numbers"),
        ("bomb.txt.gz", gzip.compress(b"1 " * 4_000_000), "lines of at most 1 MB"),
    ],
)
def test_a_bad_file_is_refused_in_one_sentence_and_the_road_in_use_stays(
    taken: Taken, name: str, content: bytes, says: str
) -> None:
    bring(taken)
    taken.control.use()
    taken.upload(name, content)
    if taken.dialog.fields["pitch"].error_state:
        taken.fill(pitch=50.0, height_unit="mm")
    assert len(taken.refusals) == 1
    assert says in taken.refusals[0]
    assert "\n" not in taken.refusals[0]
    assert "/tmp" not in taken.refusals[0]
    assert "road-" not in taken.refusals[0]
    assert taken.dialog.use_button.disabled
    taken.control.use()
    taken.control.cancel()
    assert len(taken.roads) == 1
    assert len(taken.files) == 1


def test_a_zip_bomb_is_refused_before_it_is_unpacked(taken: Taken) -> None:
    buffer = io.BytesIO()
    with (
        zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive,
        archive.open("heights.npy", "w", force_zip64=True) as member,
    ):
        for _ in range(600):
            member.write(bytes(1_000_000))
    taken.upload("bomb.npz", buffer.getvalue())
    taken.fill(pitch=50.0, height_unit="mm")
    assert "must hold at most" in taken.refusals[-1]


def test_a_visitors_file_name_is_shown_as_it_is_and_never_used_as_a_path(taken: Taken) -> None:
    name = "../../<img src=x onerror=alert(1)>.npy"
    bring(taken, name)
    taken.control.use()
    kept = Path(taken.roads[-1]["road.file"])
    assert kept.name == "_img src_x onerror_alert(1)_.npy"
    assert kept.is_relative_to(taken.control._folder.name)
    assert "<img" not in taken.control.status.object
    assert "&lt;img" in taken.control.status.object


def test_back_to_the_made_road_gives_every_default(taken: Taken) -> None:
    bring(taken)
    taken.control.use()
    taken.control.forget()
    assert taken.roads[-1]["road.file"] == ""
    assert all(taken.roads[-1][f"road.{name}"] == getattr(Road(), name) for name in SETTINGS)
    assert not taken.control.clear.visible


def test_a_file_is_there_for_undo_and_gone_with_the_session(taken: Taken) -> None:
    bring(taken)
    taken.control.use()
    file = taken.roads[-1]["road.file"]
    taken.control.forget()
    taken.control.show(file)
    assert "my road.npy" in taken.control.status.object
    assert Path(file).exists()
    taken.control.close()
    assert not Path(file).parent.exists()


def test_undo_to_a_file_that_is_no_longer_kept_says_so(taken: Taken) -> None:
    for number in range(4):
        bring(taken, f"{number}.npy")
        taken.control.use()
    taken.control.show(taken.roads[0]["road.file"])
    assert "no longer kept" in taken.control.status.object
    assert not taken.control.change.visible
    assert taken.control.clear.visible


def test_beside_a_file_that_is_refused_nothing_of_another_one_stands(taken: Taken) -> None:
    bring(taken)
    taken.control.use()
    taken.upload("photo.jpg", b"\xff\xd8\xff")
    assert taken.dialog.facts.object == ""
    assert not taken.dialog.preview.root.visible
    assert not any(field.visible for field in taken.dialog.fields.values())


def test_a_file_that_comes_while_another_is_read_supersedes_it(
    taken: Taken, monkeypatch: pytest.MonkeyPatch
) -> None:
    look = Reading.look
    monkeypatch.setattr(Reading, "look", lambda self, road: (time.sleep(0.2), look(self, road))[1])
    lines = "distance (mm)\theight (mm)\n" + "".join(
        f"{n * 0.1:.1f}\t{n % 7}\n" for n in range(300)
    )
    monkeypatch.setattr(taken, "settle", lambda: None)
    taken.upload("first.dat", lines.encode())
    taken.upload("second.dat", lines.replace("0.1", "0.2").encode())
    monkeypatch.undo()
    taken.settle()
    assert taken.dialog.root.title == "Your road: second.dat"
    taken.control.use()
    assert "second.dat" in taken.control.status.object
    assert len(taken.files) == 1
