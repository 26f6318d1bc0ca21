"""Point clouds: their triangles, and files of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scans
from tyrecontact.road.formats import points


def cloud(count: int = 4000, side: float = 0.02) -> np.ndarray:
    """Points of the plane z = 0.1 x - 0.2 y [m] far from the origin, as surveys have them."""
    flat = np.random.default_rng(1).uniform(0, side, (count, 2))
    return np.column_stack([flat + np.array([500.0, 600.0]), 0.1 * flat[:, 0] - 0.2 * flat[:, 1]])


def test_triangles_do_not_bridge_gaps() -> None:
    places = cloud()
    x = places[:, 0] - 500.0
    triangles = points.triangulated(places[(x < 5e-3) | (x > 15e-3)])
    width = np.ptp(triangles[..., 0], axis=1)
    assert width.max() < 5e-3  # a bridge would be 10 mm wide


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_a_cloud_becomes_a_map(tmp_path: Path, suffix: str) -> None:
    laspy = pytest.importorskip("laspy")
    if suffix == ".laz":
        pytest.importorskip("lazrs")
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales, header.offsets = [1e-6] * 3, [500.0, 600.0, 0.0]
    made = laspy.LasData(header)
    made.x, made.y, made.z = cloud().T
    path = tmp_path / f"a{suffix}"
    made.write(str(path))
    with pytest.raises(scans.NotCarriedError, match="unit must be given"):
        scans.read(path)
    found = scans.read(path, unit="m")
    assert found.pitch == pytest.approx(0.02 / np.sqrt(4000), rel=0.15)  # median, not mean, cell
    assert min(found.extent) > 0.018
    y, x = np.indices(found.heights.shape) * found.pitch
    plane = 0.1 * x - 0.2 * y
    np.testing.assert_allclose(  # coordinates are stored to 1 um
        found.heights - found.heights[0, 0], plane, atol=3e-6
    )
    finer = scans.read(path, pitch=1e-4, unit="m")
    assert finer.pitch == pytest.approx(1e-4)
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(InputError, match=f"a{suffix}"):
        scans.read(path, unit="m")


def test_too_many_points_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    laspy = pytest.importorskip("laspy")
    made = laspy.LasData(laspy.LasHeader(point_format=0, version="1.2"))
    made.x, made.y, made.z = cloud(100).T
    made.write(str(tmp_path / "a.las"))
    monkeypatch.setattr(points, "MAX_POINTS", 50)
    with pytest.raises(InputError, match="must hold 3 to 50 points, got 100"):
        scans.read(tmp_path / "a.las", unit="m")


def test_without_the_extra_it_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "laspy", None)
    with pytest.raises(InputError, match=r"pip install tyrecontact\[laz\]"):
        scans.read(tmp_path / "a.laz", unit="m")
