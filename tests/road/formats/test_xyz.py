"""Columns x y z: any order of lines, holes, and what is no regular grid."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road import scans

STEP = 0.0375


def columns(ny: int = 7, nx: int = 9) -> tuple[np.ndarray, np.ndarray]:
    """Lines x y z of a grid, and its heights."""
    heights = np.random.default_rng(1).standard_normal((ny, nx))
    row, column = np.indices(heights.shape)
    return np.column_stack([
        100 + column.ravel() * STEP, 5 + row.ravel() * STEP, heights.ravel()
    ]), heights  # fmt: skip


def written(path: Path, values: np.ndarray, delimiter: str = " ", digits: int = 6) -> Path:
    np.savetxt(path, values, delimiter=delimiter, fmt=f"%.{digits}f", header="x y z")
    return path


def refusal(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        scans.read(path, unit="mm")
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize(("name", "delimiter"), [("a.xyz", " "), ("b.xyz", ","), ("c.xyz.gz", ";")])
def test_lines_may_come_in_any_order(tmp_path: Path, name: str, delimiter: str) -> None:
    values, heights = columns()
    values = np.random.default_rng(2).permutation(values)
    found = scans.read(written(tmp_path / name, values, delimiter), unit="mm")
    np.testing.assert_allclose(found.heights, heights * 1e-3, atol=1e-9)  # six digits of a mm
    assert found.pitch == pytest.approx(STEP * 1e-3, rel=1e-6)
    assert (found.pitch_origin, found.unit_origin) == ("file", "given")


def test_coordinates_rounded_in_the_file_still_make_a_grid(tmp_path: Path) -> None:
    values, heights = columns(40, 60)
    found = scans.read(written(tmp_path / "a.xyz", values, digits=3), unit="mm")
    assert found.heights.shape == heights.shape
    assert found.pitch == pytest.approx(STEP * 1e-3, rel=1e-3)  # 0.0005 of 40 steps


def test_places_without_a_line_are_missing(tmp_path: Path) -> None:
    values, heights = columns()
    found = scans.read(written(tmp_path / "a.xyz", np.delete(values, [12, 30], axis=0)), unit="mm")
    assert found.missing_share == pytest.approx(2 / heights.size)
    assert np.flatnonzero(~found.valid).tolist() == [12, 30]


def test_a_given_pitch_tells_the_unit_of_x_and_y(tmp_path: Path) -> None:
    """x and y in mm, heights in um: the pitch is given then, and the difference told."""
    found = scans.read(written(tmp_path / "a.xyz", columns()[0]), pitch=STEP * 1e-3, unit="um")
    assert found.pitch == STEP * 1e-3
    assert any("pitch 37.5 µm as given, against 0.0375 µm" in clause for clause in found.done)


def test_what_is_no_regular_grid_is_refused(tmp_path: Path) -> None:
    values, _ = columns()
    jittered = values + np.random.default_rng(3).uniform(-0.3, 0.3, values.shape) * [STEP, 0, 0]
    stretched = values * [1, 2, 1]
    twice = np.concatenate([values, values[:1]])
    line = values[:9]
    for case, sentence in (
        (jittered, "must lie on one regular square grid"), (twice, "several heights at one place"),
        (stretched, "equally spaced along x and y"), (line, "with a single y"),
        (values[:, :2], "must hold columns x y z, got 2"),
        (values * [np.nan, 1, 1], "finite x and y"),
    ):  # fmt: skip
        assert sentence in refusal(written(tmp_path / "a.xyz", case))
    (tmp_path / "b.xyz").write_text("# nothing\n")
    assert "is empty" in refusal(tmp_path / "b.xyz")


def test_a_few_points_far_apart_do_not_make_a_huge_grid(tmp_path: Path) -> None:
    values = np.array([[0, 0, 1], [1e-3, 1e-3, 1], [2e-3, 2e-3, 1], [50, 50, 1.0]])
    assert "must hold at most 6.4e+07 heights" in refusal(written(tmp_path / "a.xyz", values))
