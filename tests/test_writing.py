"""Files that are whole or absent."""

from __future__ import annotations

from pathlib import Path

import pytest

from tyrecontact.errors import InputError, TyreContactError
from tyrecontact.writing import require_folder, require_writable, write_whole


def test_a_file_that_cannot_be_written_leaves_the_older_one(tmp_path: Path) -> None:
    path = tmp_path / "a.txt"
    path.write_text("older")

    def fails(part: Path) -> None:
        part.write_text("half")
        raise OSError(28, "No space left")

    with pytest.raises(TyreContactError, match=r"--output could not be written, .*No space left"):
        write_whole(path, fails)
    assert [file.read_text() for file in tmp_path.iterdir()] == ["older"]


def test_what_can_be_written_is_left_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "run.nc"
    path.write_text("older")
    require_writable(path)
    require_folder(tmp_path / "new" / "folder")
    assert path.read_text() == "older"
    assert sorted(file.name for file in tmp_path.iterdir()) == ["new", "run.nc"]
    assert not list((tmp_path / "new" / "folder").iterdir())


def test_a_folder_is_no_file_and_a_file_no_folder(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"--output must name a file .*it is a folder"):
        require_writable(tmp_path)
    file = tmp_path / "file"
    file.write_text("")
    with pytest.raises(InputError, match=r"--output must name a folder that can be written"):
        require_folder(file)
