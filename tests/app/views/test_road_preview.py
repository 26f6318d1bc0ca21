"""The preview shows the whole file, few heights of it, and the patch where it will be."""

from __future__ import annotations

import numpy as np
import pytest

from app.views.road_facts import banner, facts, line, table
from app.views.road_preview import RoadPreview
from tyrecontact.parts.road import Road
from tyrecontact.road.overview import overview
from tyrecontact.road.scan import Scan
from tyrecontact.road.understood import understood


def _map() -> Scan:
    heights = np.random.default_rng(1).normal(0, 1e-4, (500, 900))
    heights[:2, :6] = np.nan
    return Scan(
        heights, 1e-4, name="<b>.npy", unit="um", missing_share=0.1, done=("levelled: <a>",)
    )


def test_a_map_is_drawn_about_its_middle_with_the_patch_on_it() -> None:
    preview = RoadPreview()
    preview.show(overview(_map()), Road(size=10e-3, centre_x=5e-3, centre_y=-3e-3))
    drawn = preview.map
    assert drawn is not None
    assert drawn.image.data["x"] == [pytest.approx(-45)]
    assert drawn.image.data["dy"] == [pytest.approx(50)]
    assert max(drawn.image.data["height"][0].shape) <= 400
    assert drawn.patch.data == {"x": [5.0], "y": [-3.0], "side": [10.0]}
    assert preview.root.objects == [drawn.pane]
    preview.mark(Road(size=20e-3))
    assert drawn.patch.data["side"] == [20.0]


def test_a_profile_shows_what_is_trimmed_and_what_is_used() -> None:
    height = np.r_[np.full(100, 0.05), np.sin(np.arange(800) / 9) * 1e-3, np.full(100, 0.05)]
    preview = RoadPreview()
    road = Road(trim_start=10e-3, trim_end=10e-3, size=20e-3, centre_x=5e-3)
    preview.show(overview(Scan(height, 1e-4)), road)
    drawn = preview.line
    assert drawn is not None
    assert (drawn.start.left, drawn.start.right) == (0.0, pytest.approx(10.0))
    assert (drawn.end.left, drawn.end.right) == (pytest.approx(90.0), pytest.approx(100.0))
    assert (drawn.patch.left, drawn.patch.right) == (pytest.approx(45.0), pytest.approx(65.0))
    assert drawn.figure.y_range.end == pytest.approx(1160, rel=0.02)  # the plates are off scale
    preview.mark(Road(profile_use="isotropic", size=20e-3))
    assert (drawn.patch.left, drawn.patch.right) == (0.0, pytest.approx(100.0))
    assert not drawn.start.visible


def test_another_kind_of_file_takes_the_place_and_none_clears_it() -> None:
    preview = RoadPreview()
    preview.show(overview(_map()), Road())
    preview.show(overview(Scan(np.arange(50.0), 1e-3)), Road())
    assert preview.line is not None
    assert preview.root.objects == [preview.line.pane]
    preview.clear()
    assert not preview.root.objects
    preview.mark(Road())


def test_facts_have_units_and_origins_and_no_markup_of_the_visitor() -> None:
    found = understood(_map())
    told = dict(facts(found))
    assert told["Extent"].startswith("90.0 × 50.0 mm")
    assert told["Pitch"] == "100 µm, given by you"
    assert told["Unit of heights"] == "µm, given by you"
    assert told["Drop-outs"] == "10.0 % of the heights"
    assert "<a>" not in table(found)
    assert "&lt;a&gt;" in table(found)
    assert "&lt;b&gt;" in line("<b>")
    assert "&lt;b&gt;" in banner("error", "<b>")
