"""What the dialog hears of a file: measured ones, and what is wrong with a choice."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.road_reading import Look, Reading, square_that_fits
from tyrecontact.parts.road import Road
from tyrecontact.road import scans


def test_a_measured_profile_is_usable_where_enough_was_measured(measured: Path) -> None:
    path = measured / "captif_slp_profiles" / "20211011_aylesbury_dec_station_0.dat.gz"
    reading = Reading(path, "chip seal.dat.gz")
    trims = {"trim_start": 0.11, "trim_end": 0.055}
    look = reading.look(Road(**trims))
    assert "Missing heights" in look.refusal.capitalize()
    assert "chip seal.dat.gz" in look.refusal
    assert look.found is not None
    assert look.found.mean_profile_depth == pytest.approx(3.28e-3, rel=0.02)
    assert reading.look(Road(**trims, fill_limit=0.3)).usable


def test_a_measured_rock_asks_for_its_unit_alone(measured: Path) -> None:
    reading = Reading(measured / "rock_fracture_stl" / "example_surface.stl.gz", "rock.stl.gz")
    assert reading.look(Road()).missing == ("unit",)
    look = reading.look(Road(height_unit="mm"))
    assert "must cover 20 x 20 mm" in look.refusal
    side = square_that_fits(look, 20e-3)
    assert side == pytest.approx(17e-3)
    assert reading.look(Road(height_unit="mm", pitch=1e-4, size=side)).usable


def test_a_file_is_read_once_for_many_looks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    np.save(tmp_path / "road.npy", np.random.default_rng(1).normal(0, 0.02, (300, 300)))
    reading = Reading(tmp_path / "road.npy", "mine.npy")
    given = {"pitch": 1e-4, "height_unit": "mm"}
    assert reading.look(Road(**given)).usable
    monkeypatch.setattr(scans, "load", lambda *_: pytest.fail("read again"))
    assert reading.look(Road(**given, centre_x=2e-3)).usable
    assert reading.look(Road(pitch=2e-4, height_unit="um")).usable
    assert "centre" in reading.look(Road(**given, centre_x=20e-3)).refusal


def test_an_error_of_ours_is_a_sentence_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scans, "load", lambda *_: 1 / 0)
    assert "could not be read" in Reading(tmp_path / "road.npy", "mine.npy").look(Road()).refusal


@pytest.mark.parametrize(("fits", "side"), [(0.0, 20), (30e-3, 20), (18.95e-3, 18.5), (4e-4, 0.4)])
def test_the_largest_square_is_offered_in_half_millimetres(fits: float, side: float) -> None:
    assert square_that_fits(Look("a", fits=fits), 20e-3) == pytest.approx(side * 1e-3)
