"""Measured surfaces of others, read and used as roads; skipped where they are not at hand."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation, assembly
from tyrecontact.errors import InputError
from tyrecontact.parts.road import Road
from tyrecontact.road import prepare, scans, spectrum
from tyrecontact.road.understood import understood

PROFILE = "captif_slp_profiles/20211011_aylesbury_dec_station_0.dat.gz"
ROCK = "rock_fracture_stl/example_surface.stl.gz"
#: reference plates lie at both ends of the profile of 1914 mm
PLATES = {"trim_start": 0.110, "trim_end": 0.0544}


@pytest.fixture(scope="module")
def profile(measured: Path) -> Road:
    return Road(file=str(measured / PROFILE), **PLATES)


def require_library() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        pytest.importorskip("SurfaceTopography")


def run(road: Road, kernel: str = "static") -> np.ndarray:
    """Contact forces of a short run on a road."""
    scenario = Scenario(
        loading={"max_indentation": 1e-4, "rate": 0.1},
        numerics={"kernel": kernel, "lags": 32},
    )
    for name, value in road.param.values().items():
        if name != "name":
            scenario.set(f"road.{name}", value)
    results = Simulation(scenario).run()
    assert results.stop_reason == "completed"
    return results.contact_force


def test_the_profile_is_understood(profile: Road) -> None:
    """Odd line ends, a column "Depth" that counts up, drop-outs, plates at both ends."""
    found = assembly.road_understood(profile)
    assert (found.profile, found.unit, found.unit_origin, found.pitch_origin) == (
        True, "mm", "file", "file",
    )  # fmt: skip
    assert found.pitch == pytest.approx(37.5e-6, rel=1e-3)
    assert found.extent[0] == pytest.approx(1.75, rel=1e-3)
    assert found.missing_share == pytest.approx(0.0856, abs=1e-3)  # plates included
    # captif-slp has 3.28 mm; peaks of single points depend on how drop-outs are bridged
    assert found.mean_profile_depth == pytest.approx(3.28e-3, rel=0.02)
    assert found.depth_segment == 0.1
    told = " ".join(found.done)
    for part in ("11 lines of header", "'Depth (mm)', read as height", "trimmed by 110 mm"):
        assert part in told


def test_plates_left_on_the_profile_show(profile: Road) -> None:
    whole = Road(file=profile.file)
    assert assembly.road_understood(whole).span > 1.1 * assembly.road_understood(profile).span


def test_drop_outs_are_filled_and_limited(profile: Road) -> None:
    filled = prepare.filled(assembly.road_scan(profile), 0.1)
    assert "4.98% of the heights" in filled.done[-1]
    strict = Road(file=profile.file, **PLATES, fill_limit=0.01, profile_use="isotropic")
    with pytest.raises(InputError, match=r"at most 1\.0% .* got 5\.0%"):
        assembly.road_patch(strict)


def test_the_profile_runs_as_a_corrugated_road(profile: Road) -> None:
    with pytest.raises(InputError, match=r"got 13\.4% .*raise fill_limit, or move the centre"):
        assembly.road_patch(profile)  # in its middle
    road = Road(file=profile.file, **PLATES, centre_x=0.05)
    patch = assembly.road_patch(road)
    assert patch.extent == pytest.approx((20e-3, 20e-3))
    np.testing.assert_allclose(patch.heights - patch.heights[0], 0, atol=1e-16)  # rounding
    scan = assembly.road_scan(road)
    middle = len(scan.heights) // 2 + round(0.05 / scan.pitch)
    near = scan.heights[middle - 250 : middle + 250]
    # resampled from 37.5 to 37.04 um: steep flanks move, levels do not
    assert patch.heights.max() == pytest.approx(np.nanmax(near), abs=0.1e-3)
    assert run(road)[-1] > 0


def test_the_profile_runs_as_an_isotropic_road(profile: Road) -> None:
    road = Road(file=profile.file, **PLATES, profile_use="isotropic", size=10e-3, elements=10)
    patch = assembly.road_patch(road)
    scan = prepare.filled(assembly.road_scan(road), 0.1)
    frequency, wanted = spectrum.of_profile(scan.heights, scan.pitch, 20e-3)
    made = np.mean(
        [spectrum.of_profile(row, patch.pitch, 2.5e-3)[1] for row in patch.heights[::8]], 0
    )
    at = spectrum.of_profile(patch.heights[0], patch.pitch, 2.5e-3)[0]
    for low, high in ((400, 1000), (1000, 3000), (3000, 9000)):
        ours = made[(at >= low) & (at < high)].mean()
        theirs = wanted[(frequency >= low) & (frequency < high)].mean()
        # one crop of a few stones, and resampled linearly (lower at the short waves)
        assert 0.4 < ours / theirs < 2
    assert run(road)[-1] > 0


def test_the_rock_is_understood_and_runs(measured: Path) -> None:
    """SOURCES.md: rms 0.287 mm and rms gradient 0.20 in its largest (turned) square of 17.5 mm."""
    with pytest.raises(scans.NotCarriedError, match="unit must be given"):
        scans.read(measured / ROCK)
    road = Road(file=str(measured / ROCK), height_unit="mm", size=16e-3, elements=16)
    found = assembly.road_understood(road)
    assert min(found.extent) > 17e-3
    assert found.rms == pytest.approx(0.287e-3, rel=0.05)  # another part of the outline
    assert found.rms_slope == pytest.approx(0.20, rel=0.05)
    assert found.pitch == pytest.approx(0.21e-3, rel=0.15)
    assert run(road)[-1] > 0
    assert run(road, "passive")[-1] > 0


def test_the_rock_is_too_small_for_the_default_patch(measured: Path) -> None:
    road = Road(file=str(measured / ROCK), height_unit="mm")
    with pytest.raises(InputError, match="road must cover 20 x 20 mm, got 17"):
        assembly.road_patch(road)


def test_the_coin_has_its_size_and_runs(measured: Path) -> None:
    """The .tmd trap: one library reads its heights a thousand times too small."""
    require_library()
    road = Road(file=str(measured / "instrument_formats/tmd-1.tmd"), size=18e-3, elements=18)
    found = assembly.road_understood(road)
    assert found.extent == pytest.approx((18.957e-3, 18.957e-3), rel=1e-4)
    assert found.pitch == pytest.approx(63.2e-6, rel=1e-3)
    assert 0.2e-3 < found.span < 0.5e-3  # the relief of a coin, not 0.3 um nor 0.3 m
    assert not found.doubts
    assert run(road)[-1] > 0


def test_instrument_files_carry_their_facts(measured: Path) -> None:
    require_library()
    sur = scans.read(measured / "instrument_formats/sur-2.sur")
    assert sur.heights.shape == (484, 563)  # rows are y
    assert sur.extent == pytest.approx((1.6863e-3, 1.9615e-3), rel=1e-4)
    assert 0 < sur.missing_share < 1e-3
    sdf = scans.read(measured / "instrument_formats/sdf-1.sdf")
    assert (sdf.heights.shape, sdf.pitch) == ((4, 7), pytest.approx(1e-6))
    assert assembly.road_patch(
        Road(file=str(measured / "instrument_formats/sur-2.sur"), size=1.6e-3, elements=8)
    ).extent == pytest.approx((1.6e-3, 1.6e-3))


@pytest.mark.parametrize("name", ["sample1", "sample1_bin", "sample4"])
def test_iso_5436_samples_are_the_same_surface(measured: Path, name: str) -> None:
    """Increments are metres (of a sample 64 mm wide); text, binary and integers agree."""
    scan = scans.read(measured / f"x3p_opengps/ISO5436-{name}.x3p")
    assert scan.extent == pytest.approx((64.064e-3, 64.064e-3))
    assert (scan.pitch_origin, scan.unit_origin, scan.missing_share) == ("file", "file", 1 / 16)
    assert np.argwhere(~scan.valid).tolist() == [[1, 3]]  # x is the fastest: row 1, column 3
    assert scan.heights[0, 0] == pytest.approx(0.486219, abs=1e-3)  # integers: steps of 1 mm
    assert scan.heights[0, 3] == pytest.approx(-0.579793, abs=1e-3)
    assert "checksum of main.xml is right" in scan.done
    assert understood(scan).doubts  # a metre high over 64 mm


def test_an_iso_5436_sample_is_too_coarse_for_a_road(measured: Path) -> None:
    """Its 4 x 4 heights give one element's worth; a finer file of that kind runs below."""
    file = str(measured / "x3p_opengps/ISO5436-sample1_bin.x3p")
    with pytest.raises(InputError, match="at least 4 heights a side of an element"):
        assembly.road_patch(Road(file=file, elements=2))


def test_a_rock_in_an_iso_5436_file_is_the_same_road(measured: Path, tmp_path: Path) -> None:
    """Written by SurfaceTopography: the reader is not judged by its own idea of the format."""
    require_library()
    rock = scans.read(measured / ROCK, unit="mm")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from SurfaceTopography import Topography

        sizes = tuple(reversed(rock.extent))
        Topography(rock.heights.T, sizes, unit="m", periodic=False).to_x3p(str(tmp_path / "a.x3p"))
    found = scans.read(tmp_path / "a.x3p")
    np.testing.assert_allclose(found.heights, rock.heights, rtol=1e-12)  # a product
    assert found.pitch == pytest.approx(rock.pitch, rel=1e-12)
    assert run(Road(file=str(tmp_path / "a.x3p"), size=16e-3, elements=16))[-1] > 0
