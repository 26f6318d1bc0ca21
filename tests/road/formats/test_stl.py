"""Triangulated scans: binary and text, their upper surface, and damaged ones."""

from __future__ import annotations

import gzip
from pathlib import Path

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scans
from tyrecontact.road.formats import stl


def facets(count: int = 20, step: float = 0.2) -> np.ndarray:
    """Triangles of a tilted plane z = 0.1 x + 0.05 y, `count` squares a side, (n, 3, 3)."""
    x, y = np.meshgrid(np.arange(count + 1) * step, np.arange(count + 1) * step)
    nodes = np.stack([x, y, 0.1 * x + 0.05 * y], axis=-1)
    a, b, c, d = nodes[:-1, :-1], nodes[:-1, 1:], nodes[1:, 1:], nodes[1:, :-1]
    first, second = np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)
    return np.concatenate([first.reshape(-1, 3, 3), second.reshape(-1, 3, 3)])


def binary(triangles: np.ndarray, title: bytes = b"made") -> bytes:
    records = np.zeros(len(triangles), stl._TRIANGLE)
    records["corners"] = triangles
    return title.ljust(80) + len(triangles).to_bytes(4, "little") + records.tobytes()


def ascii_text(triangles: np.ndarray) -> bytes:
    lines = ["solid made"]
    for corners in triangles:
        lines += ["facet normal 0 0 1", "outer loop"]
        lines += ["vertex " + " ".join(f"{value:.9g}" for value in corner) for corner in corners]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid made", ""]).encode()


def refusal(path: Path, content: bytes) -> str:
    path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        scans.read(path, unit="mm")
    return str(caught.value)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.stl", binary(facets())),
        ("b.stl", binary(facets(), b"solid, but binary")),
        ("c.stl", ascii_text(facets())),
        ("d.stl.gz", gzip.compress(binary(facets()))),
        ("e.STL.GZ", gzip.compress(ascii_text(facets()))),
    ],
)
def test_every_kind_gives_the_plane_that_was_written(
    tmp_path: Path, name: str, content: bytes
) -> None:
    (tmp_path / name).write_bytes(content)
    found = scans.read(tmp_path / name, unit="mm")
    assert found.pitch == pytest.approx(0.2e-3, rel=1e-6)  # as fine as the facets
    assert found.heights.shape == (21, 21)
    y, x = np.indices(found.heights.shape) * 0.2e-3
    np.testing.assert_allclose(found.heights, 0.1 * x + 0.05 * y, atol=1e-9)  # single precision


def test_a_unit_is_asked_for_and_a_given_pitch_is_that_of_the_grid(tmp_path: Path) -> None:
    path = tmp_path / "a.stl"
    path.write_bytes(binary(facets()))
    with pytest.raises(scans.NotCarriedError, match="unit must be given"):
        scans.read(path)
    finer = scans.read(path, pitch=5e-5, unit="mm")
    assert (finer.pitch, finer.pitch_origin) == (pytest.approx(5e-5), "given")
    assert min(finer.heights.shape) >= 80


def test_damaged_files_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, whole, text = tmp_path / "a.stl", binary(facets()), ascii_text(facets())
    for content in (b"", whole[:50], whole[:84], whole[:-1], whole + b"x"):
        assert "a.stl must be an STL file" in refusal(path, content)
    assert "whole triangles up to its 'endsolid'" in refusal(path, text[: len(text) // 2])
    assert "whole triangles" in refusal(path, b"solid\nendsolid\n")
    walls = facets()[..., [0, 0, 2]]
    assert "seen from above" in refusal(path, binary(walls))
    monkeypatch.setattr(stl, "MAX_BYTES", 1000)
    assert "at most 0 MB" in refusal(path, whole)
