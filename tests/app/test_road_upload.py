"""An upload is checked as it comes, and nothing is left of one that is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from app import road_upload
from app.limits import Limits
from app.road_upload import Upload


class Receiver:
    """An upload into a folder, and what it said."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.told: list[str] = []
        self.done: list[tuple[Path, str]] = []
        self.refused: list[str] = []
        self.upload = Upload(
            lambda _, ending: folder / f"road{ending}",
            self.told.append,
            lambda path, name: self.done.append((path, name)),
            lambda _, sentence: self.refused.append(sentence),
        )


@pytest.fixture
def receiver(tmp_path: Path) -> Receiver:
    return Receiver(tmp_path)


def test_pieces_become_the_file_and_nothing_stays_in_memory(receiver: Receiver) -> None:
    for number, piece in enumerate((b"one ", b"two ", b"three"), start=1):
        receiver.upload.receive("My Road.TXT", piece, number, 3)
    receiver.upload.finish()
    path, name = receiver.done[0]
    assert path.read_bytes() == b"one two three"
    assert (path.name, name) == ("road.txt", "My Road.TXT")
    assert receiver.told[0].startswith("Receiving My Road.TXT")
    assert receiver.upload.value is None


def test_one_that_is_too_large_is_refused_at_its_first_piece(receiver: Receiver) -> None:
    pieces = 200_000_000 // road_upload._PIECE + 2
    for number in (1, 2):
        receiver.upload.receive("huge.npy", b"x", number, pieces)
    receiver.upload.finish()
    assert len(receiver.refused) == 1
    assert "must have at most 200 MB" in receiver.refused[0]
    assert not list(receiver.folder.iterdir())


def test_one_that_says_too_little_is_stopped_by_what_comes(
    receiver: Receiver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(road_upload, "limits", lambda: Limits(upload=1e-3))
    receiver.upload.receive("sly.npy", bytes(1001), 1, 1)
    assert "must have at most" in receiver.refused[0]
    assert not list(receiver.folder.iterdir())


@pytest.mark.parametrize("numbers", [(2,), (1, 3)])
def test_pieces_out_of_order_are_refused(receiver: Receiver, numbers: tuple[int, ...]) -> None:
    for number in numbers:
        receiver.upload.receive("road.npy", b"x", number, 5)
    assert "pieces must come in order" in receiver.refused[0]
    assert not list(receiver.folder.iterdir())


def test_half_a_file_is_no_file(receiver: Receiver) -> None:
    receiver.upload.receive("road.npy", b"x", 1, 2)
    receiver.upload.finish()
    assert "must arrive whole, got 1 of 2 pieces" in receiver.refused[0]
    assert not receiver.done


def test_a_file_that_the_browser_cannot_read_is_said(receiver: Receiver) -> None:
    receiver.upload.receive("road.npy", b"x", 1, 2)
    receiver.upload._handle_msg({"status": "error", "error": "it was moved"})
    assert "could not send it: it was moved" in receiver.refused[0]
    assert not list(receiver.folder.iterdir())


def test_what_makes_no_sense_is_passed_over(receiver: Receiver) -> None:
    piece = {"status": "upload_event", "name": "a.npy", "chunk": 1, "total_chunks": 1}
    for nonsense in (None, [], {}, {"status": 1}, piece, {**piece, "data": 10**12}):
        receiver.upload._handle_msg(nonsense)
    assert not list(receiver.folder.iterdir())
    receiver.upload._handle_msg({**piece, "data": b"one"})
    receiver.upload.finish()
    assert receiver.done[0][0].read_bytes() == b"one"


@pytest.mark.parametrize("begun", [False, True])
def test_nothing_stays_on_disk_of_one_that_another_follows(tmp_path: Path, begun: bool) -> None:
    numbers = iter(range(9))
    upload = Upload(
        lambda _, ending: tmp_path / f"{next(numbers)}{ending}", print, lambda *_: None, print
    )
    for _ in range(3):
        if begun:
            upload._handle_msg({"status": "initializing"})
        upload.receive("road.npy", b"x", 1, 2)
    assert [path.name for path in tmp_path.iterdir()] == ["2.npy"]
    upload.receive("road.npy", b"y", 2, 2)
    upload.finish()
    upload.abandon()
    assert (tmp_path / "2.npy").read_bytes() == b"xy"
