"""A small text file that a visitor brings."""

from __future__ import annotations

from pathlib import Path

import pytest

from app import text_file
from app.text_file import TextFile


@pytest.fixture
def taken() -> list[str]:
    return []


@pytest.fixture
def refused() -> list[str]:
    return []


def _bring(file: TextFile, content: bytes, name: str) -> None:
    file.root.param.update(filename=name, value=content)


def test_a_file_is_kept_under_a_name_of_the_servers_and_removed_at_the_end(
    taken: list[str], refused: list[str]
) -> None:
    file = TextFile("Loading table", taken.append, refused.append)
    _bring(file, b"0 0\n1 1e-4\n", "../../my table.csv")
    assert Path(taken[0]).read_bytes() == b"0 0\n1 1e-4\n"
    assert Path(taken[0]).name == "table.txt"
    assert file.name == "../../my table.csv"
    file.close()
    assert not Path(taken[0]).exists()
    assert file.name == ""


def test_another_file_takes_the_place_of_the_first(taken: list[str], refused: list[str]) -> None:
    file = TextFile("Loading table", taken.append, refused.append)
    _bring(file, b"first", "a.txt")
    _bring(file, b"second", "b.txt")
    assert not Path(taken[0]).exists()
    assert Path(taken[1]).read_bytes() == b"second"
    file.close()


def test_a_file_that_is_too_large_is_refused_in_a_sentence(
    taken: list[str], refused: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(text_file, "MAX_BYTES", 10)
    _bring(TextFile("Loading table", taken.append, refused.append), b"x" * 11, "a.txt")
    assert taken == []
    assert refused == ["Loading table must have at most 0 MB, got 0 MB"]
