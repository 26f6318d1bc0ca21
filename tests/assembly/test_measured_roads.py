"""From settings to measured roads: read, levelled, cut and filled as they say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact import assembly
from tyrecontact.assembly.road import prepared, with_ends
from tyrecontact.errors import InputError
from tyrecontact.parts.road import Road
from tyrecontact.road.scan import Scan

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


def test_a_road_file_is_read_in_its_unit_and_cut_to_the_middle(tmp_path: Path) -> None:
    scan = np.random.default_rng(1).standard_normal((140, 160))
    np.save(tmp_path / "scan.npy", scan)
    file = {"file": str(tmp_path / "scan.npy"), "pitch": 5e-5, "height_unit": "um"}
    patch = assembly.road_patch(Road(**ROAD, **file, levelling="none"))
    np.testing.assert_allclose(patch.heights, scan[10:130, 20:140] * 1e-6, rtol=1e-15)  # rounding


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"pitch": 0.0}, "pitch must be given"),
        ({"height_unit": ""}, "unit must be given"),
        ({"pitch": 1e-5}, "road must cover 6 x 6 mm, got 1.4 x 1.4 mm"),
        ({"pitch": 5e-4}, "pitch must give at least 4 heights a side of an element"),
        ({"file": "missing.npy"}, "road file must be readable, got missing.npy"),
    ],
)
def test_a_road_file_that_does_not_do_is_refused(
    tmp_path: Path, change: dict[str, object], sentence: str
) -> None:
    np.save(tmp_path / "scan.npy", np.zeros((140, 140)))
    file = {"file": str(tmp_path / "scan.npy"), "pitch": 5e-5, "height_unit": "um"}
    with pytest.raises(InputError, match=sentence):
        assembly.road_patch(Road(**{**ROAD, **file, **change}))


def packed_profile(path: Path, count: int = 4000) -> dict[str, object]:
    """A profile of 0.2 m in 50 um, in a file that carries pitch and unit."""
    heights = np.cumsum(np.random.default_rng(1).standard_normal(count)) * 1e-3
    rows = "".join(f"{n * 0.05:.2f},{height:.6f}\n" for n, height in enumerate(heights))
    path.write_text(f"distance (mm),height (mm)\n{rows}")
    return {"file": str(path)}


def test_a_profile_is_drawn_out_sideways_or_made_isotropic(tmp_path: Path) -> None:
    file = packed_profile(tmp_path / "line.csv")
    corrugated = assembly.road_patch(Road(**ROAD, **file))
    assert corrugated.heights.shape == (120, 120)
    assert np.ptp(corrugated.heights, axis=0).max() == 0
    assert np.ptp(corrugated.heights, axis=1).min() > 0
    first, again, other = (
        assembly.road_patch(Road(**ROAD, **file, profile_use="isotropic", seed=seed))
        for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(first.heights, again.heights)
    assert np.abs(first.heights - other.heights).max() > 1e-6
    slopes = [np.diff(first.heights, axis=axis).std() for axis in (0, 1)]
    assert slopes[0] == pytest.approx(slopes[1], rel=0.2)  # no direction is preferred


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"centre_x": 0.01}, "centre moved by x 10 mm"),
        ({"trim_start": 0.02, "trim_end": 0.01}, "trimmed by 20 mm at the start and 10 mm"),
        ({"height_direction": "down"}, "depths, positive down"),
    ],
)
def test_every_setting_of_a_measured_road_changes_it(
    tmp_path: Path, change: dict[str, object], sentence: str
) -> None:
    file = packed_profile(tmp_path / "line.csv")
    plain = assembly.road_patch(Road(**ROAD, **file))
    changed = Road(**ROAD, **file, **change)
    assert np.abs(assembly.road_patch(changed).heights - plain.heights).max() > 1e-6
    if "centre_x" not in change:  # the whole file is told of, and the patch is cut later
        assert any(sentence in clause for clause in assembly.road_understood(changed).done)


def test_a_measured_road_is_levelled_unless_told_otherwise(tmp_path: Path) -> None:
    y, x = np.indices((140, 140)) * 5e-5
    np.save(tmp_path / "tilted.npy", 0.02 * x + 0.01 * y)
    file = {"file": str(tmp_path / "tilted.npy"), "pitch": 5e-5, "height_unit": "m"}
    assert np.ptp(assembly.road_patch(Road(**ROAD, **file)).heights) < 1e-15  # rounding
    raw = assembly.road_patch(Road(**ROAD, **file, levelling="none"))
    assert np.ptp(raw.heights) == pytest.approx(0.03 * 6e-3, rel=0.02)


def test_missing_heights_are_filled_up_to_the_limit_in_the_patch_alone(tmp_path: Path) -> None:
    heights = np.random.default_rng(1).standard_normal((300, 300)) * 1e-5
    heights[:60] = np.nan  # a fifth, but not where the patch is
    heights[150, 140:160] = np.nan
    np.save(tmp_path / "holed.npy", heights)
    file = {"file": str(tmp_path / "holed.npy"), "pitch": 5e-5, "height_unit": "m"}
    assert np.isfinite(assembly.road_patch(Road(**ROAD, **file)).heights).all()
    with pytest.raises(InputError, match=r"missing heights must be at most 0\.1%"):
        assembly.road_patch(Road(**ROAD, **file, fill_limit=1e-3))
    with pytest.raises(InputError, match=r"missing heights must be at most 10\.0%"):
        assembly.road_patch(Road(**ROAD, **file, centre_y=-4e-3))
    assert assembly.road_understood(Road(**file)).missing_share == pytest.approx(18020 / 90000)


def test_no_file_cannot_be_understood() -> None:
    with pytest.raises(InputError, match=r"road\.file must name a file"):
        assembly.road_understood(Road())


@pytest.mark.parametrize("direction", ["up", "down"])
def test_trimmed_ends_are_shown_on_the_line_that_was_taken_off(direction: str) -> None:
    scan = Scan(np.r_[9.0, 9.0, np.arange(8) * 2.0 + [0, 1] * 4, -9.0], 1e-3)
    settings = Road(trim_start=2e-3, trim_end=1e-3, height_direction=direction)
    kept = prepared(scan, settings)
    shown = with_ends(kept, scan, settings)
    assert shown.heights[2:-1] == pytest.approx(kept.heights)
    sign = 1 if direction == "up" else -1
    line = sign * scan.heights - shown.heights
    assert np.diff(line, 2) == pytest.approx(0, abs=1e-12)
