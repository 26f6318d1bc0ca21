"""A visitor's name of a file stays what it is as far as it can, and leads nowhere else."""

from __future__ import annotations

from pathlib import PurePosixPath, PureWindowsPath

import pytest

from app.file_names import harmless


@pytest.mark.parametrize(
    ("name", "kept"),
    [
        ("A12 outer lane.npy", "A12 outer lane.npy"), ("../../etc/road.npy", "road.npy"),
        ("C:\\scans\\road.NPY", "road.NPY"), ("<b>&.npy", "_b__.npy"), (".npy", "road.npy"),
        ("...", "road.npy"), ("", "road.npy"), ("ü" * 300 + ".npy", "ü" * 56 + ".npy"),
        ("a\0b.npy", "a_b.npy"), ("road.npy ", "road.npy"), ("table.txt", "road.npy"),
    ],
)  # fmt: skip
def test_a_name_is_kept_as_far_as_it_can_be(name: str, kept: str) -> None:
    found = harmless(name, ".npy", "road")
    assert found == kept
    assert PurePosixPath(found).name == PureWindowsPath(found).name == found
