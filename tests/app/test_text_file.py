"""A small text file that a visitor brings."""

from __future__ import annotations

from pathlib import Path

import pytest

from app import text_file
from app.text_file import TextFile
from tyrecontact import loading
from tyrecontact.errors import InputError
from tyrecontact.tread import tabulated


@pytest.fixture
def taken() -> list[str]:
    return []


@pytest.fixture
def refused() -> list[str]:
    return []


def _bring(file: TextFile, content: bytes, name: str) -> None:
    assert file.root is not None
    file.input.param.update(filename=name, value=content)


def test_a_file_is_kept_in_a_folder_of_its_own_and_removed_at_the_end(
    taken: list[str], refused: list[str]
) -> None:
    file = TextFile("Loading table", taken.append, refused.append)
    _bring(file, b"0 0\n1 1e-4\n", "../../my table.csv")
    assert Path(taken[0]).read_bytes() == b"0 0\n1 1e-4\n"
    assert Path(taken[0]).name == "my table.csv"
    assert Path(taken[0]).parent.name == "1"
    file.show(taken[0])
    assert file.name == "../../my table.csv"
    file.close()
    assert not Path(taken[0]).exists()
    assert file.name == ""


def test_a_few_files_are_kept_for_undo(taken: list[str], refused: list[str]) -> None:
    file = TextFile("Loading table", taken.append, refused.append)
    for number in range(text_file.KEPT + 1):
        _bring(file, f"table {number}".encode(), f"{number}.txt")
    assert [Path(path).exists() for path in taken] == [False] + text_file.KEPT * [True]
    file.show(taken[2])
    assert file.name == "2.txt"
    assert "In use: 2.txt." in file.status.object
    assert file.clear.visible
    file.show(taken[0])  # by undo, further back than is kept
    assert "no longer kept" in file.status.object
    file.show("")
    assert "No file." in file.status.object
    assert not file.clear.visible
    file.close()
    assert not any(Path(path).exists() for path in taken)


def test_what_is_too_large_is_not_even_kept_in_memory(
    taken: list[str], refused: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(text_file, "MAX_BYTES", 10)
    file = TextFile("Loading table", taken.append, refused.append)
    assert file.root is not None
    control = file.input
    piece = {"status": "upload_event", "name": "a.txt", "total_chunks": 3, "mime_type": "text/csv"}
    control._handle_msg({"status": "initializing"})
    for number in (1, 2, 3):
        control._handle_msg({**piece, "chunk": number, "data": bytes(6)})
        assert sum(map(len, control._file_buffer.get("a.txt", {}).get("chunks", {}).values())) < 11
    control._handle_msg({"status": "finished"})
    assert (taken, len(refused)) == ([], 1)
    for nonsense in (None, [], {}, {"status": "x"}, {**piece, "chunk": 1, "data": 10**12}):
        control._handle_msg(nonsense)
    for number in (1, 2, 3):
        control._handle_msg({**piece, "chunk": number, "data": b"ab"})
    control._handle_msg({"status": "finished"})
    assert Path(taken[0]).read_bytes() == b"ababab"
    file.close()


def test_a_file_that_is_too_large_is_refused_in_a_sentence(
    taken: list[str], refused: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(text_file, "MAX_BYTES", 10)
    _bring(TextFile("Loading table", taken.append, refused.append), b"x" * 11, "a.txt")
    assert taken == []
    assert refused == ["Loading table must have at most 0 MB, got 0 MB"]


@pytest.mark.parametrize(
    ("name", "kept"),
    [
        ("..", "table.txt"), ("a/..\\..", "table.txt"), ("/etc/passwd", "passwd"),
        ("", "table.txt"), ("a b.txt. ", "a b.txt"),
        ("Prüf (2).csv", "Prüf (2).csv"), ("a\0b\n<c>.txt", "a_b__c_.txt"), ("ü" * 300, "ü" * 60),
    ],
)  # fmt: skip
def test_a_name_leads_nowhere_else(
    name: str, kept: str, taken: list[str], refused: list[str]
) -> None:
    file = TextFile("Loading table", taken.append, refused.append)
    _bring(file, b"0 0\n", name)
    assert Path(taken[0]).name == kept
    assert Path(taken[0]).is_file()
    assert len(Path(taken[0]).relative_to(file._folder.name).parts) == 2
    file.close()


def test_what_is_wrong_with_a_file_is_said_of_the_visitors_name(
    taken: list[str], refused: list[str]
) -> None:
    file = TextFile("A table", taken.append, refused.append)
    _bring(file, b"no numbers", "my table.csv")
    for read in (loading.read_table, tabulated.read_table):
        with pytest.raises(InputError, match=r"got my table\.csv") as caught:
            read(taken[0])
        assert file._folder.name not in str(caught.value)
    file.close()


def test_a_file_can_be_done_without(taken: list[str], refused: list[str]) -> None:
    file = TextFile("Loading table", taken.append, refused.append)
    _bring(file, b"0 0", "a.txt")
    file.show(taken[0])
    file.clear.param.trigger("clicks")
    assert taken[1:] == [""]
    file.show("")
    _bring(file, b"0 0", "a.txt")  # the same again
    assert len(taken) == 3
    file.close()
