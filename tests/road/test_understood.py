"""What was understood of a file: figures of known surfaces, in numbers and words."""

from __future__ import annotations

import json

import numpy as np
import pytest

from tyrecontact.road.heights import Patch
from tyrecontact.road.scan import Scan
from tyrecontact.road.understood import understood

HEIGHTS = np.random.default_rng(1).standard_normal((40, 60)) * 1e-5


def test_figures_are_those_of_a_patch() -> None:
    patch, found = Patch(HEIGHTS, 1e-4), understood(Scan(HEIGHTS, 1e-4))
    assert found.rms == pytest.approx(patch.rms)
    assert found.rms_slope == pytest.approx(patch.rms_slope)
    assert found.skewness == pytest.approx(patch.skewness)
    assert found.span == pytest.approx(np.ptp(HEIGHTS))
    assert found.extent == patch.extent
    assert found.shape == HEIGHTS.shape


def test_missing_heights_do_not_count() -> None:
    holed = HEIGHTS.copy()
    holed[5:9, 5:9] = np.nan
    found = understood(Scan(holed, 1e-4, missing_share=16 / 2400))
    assert found.rms == pytest.approx(np.nanstd(holed))
    assert found.rms_slope == pytest.approx(Patch(HEIGHTS, 1e-4).rms_slope, rel=0.02)  # 1 % fewer
    assert "missing             0.67%" in found.lines()
    assert "0.7% missing" in found.sentence()


def test_a_steep_or_flat_surface_is_doubted() -> None:
    """Heights read a thousand times too high: the slopes of no road."""
    assert not understood(Scan(HEIGHTS, 1e-4)).doubts
    (doubt,) = understood(Scan(HEIGHTS * 1e3, 1e-4)).doubts
    assert "check pitch and unit" in doubt
    flat = understood(Scan(np.full((4, 4), 1e-3), 1e-4))
    assert flat.doubts == ("all heights are equal",)
    assert (flat.skewness, flat.rms) == (0.0, 0.0)


def test_words_tell_origin_unit_and_what_was_done() -> None:
    road = Scan(
        HEIGHTS[0],
        1e-4,
        name="a.dat",
        kind="text",
        unit="mm",
        unit_origin="file",
        done=("trimmed",),
    )
    found = understood(road)
    words = "\n".join(found.lines())
    for part in (
        "a.dat: profile (text)", "extent              6 mm, 60 heights",
        "pitch               100 µm (given)", "unit of heights     mm (file)",
        "over 6 mm, not the 100 mm of ISO 13473-1", "- trimmed",
    ):  # fmt: skip
        assert part in words
    assert "\n" not in found.sentence()
    assert json.loads(json.dumps(found.to_dict()))["unit_origin"] == "file"
