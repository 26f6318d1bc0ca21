"""Instruments' formats through SurfaceTopography: axes, sizes, units, and what is refused."""

from __future__ import annotations

import subprocess
import sys
import warnings
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scans
from tyrecontact.road.formats import instruments


@pytest.fixture(scope="module")
def library() -> Any:
    """SurfaceTopography, whose import warns of what it can do without."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip("SurfaceTopography")


def test_endings_are_those_that_the_library_reads(library: Any) -> None:
    from SurfaceTopography.IO import readers

    known = {f".{end}" for reader in readers for end in reader._file_extensions}
    assert set(instruments.ENDINGS) <= known
    # what is not offered is read here: with pitch and unit asked for, and hostile files refused
    assert known - set(instruments.ENDINGS) <= set(scans.ENDINGS)


def test_axes_sizes_and_units_are_taken_over(library: Any, tmp_path: Path) -> None:
    """Its arrays are [x, y] and its sizes number times pitch; here rows are y."""
    heights = np.random.default_rng(1).standard_normal((6, 4))  # 6 along x, 4 along y
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        made = library.Topography(heights, (30.0, 20.0), unit="µm", periodic=False)
        made.to_netcdf(str(tmp_path / "a.nc"))
    found = scans.read(tmp_path / "a.nc")
    np.testing.assert_allclose(found.heights, heights.T * 1e-6, rtol=1e-12)  # a product
    assert found.pitch == pytest.approx(5e-6)
    assert (found.pitch_origin, found.unit_origin) == ("file", "file")
    assert found.kind == "nc, read by SurfaceTopography"


def test_a_wrong_unit_in_a_file_can_be_set_right_and_is_told(library: Any, tmp_path: Path) -> None:
    """Libraries are known to be out by 1e3 (.tmd) and 1e6 (.nms)."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        made = library.Topography(np.eye(5), (5.0, 5.0), unit="m", periodic=False)
        made.to_netcdf(str(tmp_path / "a.nc"))
    found = scans.read(tmp_path / "a.nc", pitch=1e-6, unit="um")
    assert found.heights.max() == pytest.approx(1e-6)
    assert found.pitch == 1e-6
    assert any("unit um as given, against m in the file" in clause for clause in found.done)


def test_a_picture_without_facts_asks_for_them(library: Any, tmp_path: Path) -> None:
    tifffile = pytest.importorskip("tifffile")
    tifffile.imwrite(tmp_path / "a.tif", np.random.default_rng(1).random((8, 8), np.float32))
    with pytest.raises(InputError) as caught:
        scans.read(tmp_path / "a.tif", 1e-5, "um")
    assert "\n" not in str(caught.value)


def test_a_damaged_file_is_refused_in_one_sentence(library: Any, tmp_path: Path) -> None:
    for name in ("a.sur", "a.sdf", "a.tmd", "a.nms", "a.plu", "a.mat", "a.xlsx", "a.gwy"):
        for content in (b"", b"rubbish" * 100):
            (tmp_path / name).write_bytes(content)
            with pytest.raises(InputError) as caught:
                scans.read(tmp_path / name)
            assert name in str(caught.value)
            assert "\n" not in str(caught.value)


def test_without_the_extra_it_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.sur").write_bytes(b"x")
    monkeypatch.setitem(sys.modules, "SurfaceTopography.IO", None)
    with pytest.raises(InputError, match=r"pip install tyrecontact\[scans\]"):
        scans.read(tmp_path / "a.sur")


def test_too_large_a_file_is_refused(tmp_path: Path) -> None:
    with (tmp_path / "a.sur").open("wb") as file:
        file.truncate(2_000_000_000)
    with pytest.raises(InputError, match="at most 1000 MB, unpacked too, got 2000 MB"):
        scans.read(tmp_path / "a.sur")


def test_an_archive_that_unpacks_to_too_much_is_refused_before(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with zipfile.ZipFile(tmp_path / "a.plux", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("index.xml", bytes(5_000_000))
    monkeypatch.setattr(instruments, "MAX_BYTES", 1_000_000)
    with pytest.raises(InputError, match="at most 1 MB, unpacked too, got 5 MB"):
        scans.read(tmp_path / "a.plux")


def test_the_library_is_not_imported_until_it_is_needed() -> None:
    code = "import sys, tyrecontact.road.scans; assert 'SurfaceTopography' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
