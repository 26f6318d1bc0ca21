"""From settings to bodies: that each setting arrives where it belongs."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation, assembly
from tyrecontact.errors import InputError
from tyrecontact.parts.process import Loading
from tyrecontact.parts.road import Road
from tyrecontact.parts.tread import Tread
from tyrecontact.road import heights

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


def small(**numerics: object) -> Scenario:
    return Scenario(road=ROAD, numerics={"lags": 16, **numerics})


def test_a_made_road_has_the_size_and_the_pitch_asked_for() -> None:
    patch = assembly.road_patch(Road(**ROAD))
    assert patch.heights.shape == (120, 120)
    assert patch.pitch == pytest.approx(5e-5, rel=1e-12)  # a division
    assert heights.element_tops(patch, 6).shape == (6, 6)


def test_a_made_road_depends_on_its_seed_alone() -> None:
    first, again = (assembly.road_patch(Road(**ROAD)) for _ in range(2))
    np.testing.assert_array_equal(first.heights, again.heights)
    other = assembly.road_patch(Road(**ROAD, seed=2))
    assert np.abs(other.heights - first.heights).max() > 1e-6


@pytest.mark.parametrize(
    "change",
    [
        {"stone_size": 2e-3},
        {"valley_rms": 100e-6},
        {"valley_offset": 0.0},
        {"plateau_rms": 10e-6},
        {"plateau_wavelength": 4e-3},
        {"hurst": 0.6},
    ],
    ids=lambda change: next(iter(change)),
)
def test_every_setting_of_a_made_road_changes_it(change: dict[str, float]) -> None:
    first, other = assembly.road_patch(Road(**ROAD)), assembly.road_patch(Road(**ROAD, **change))
    assert np.abs(other.heights - first.heights).max() > 1e-6


def test_the_default_road_is_worn_with_tops_as_smooth_as_the_thesis_needs() -> None:
    patch = assembly.road_patch(Road())
    assert patch.skewness < 0
    assert 12e-6 < heights.element_tops(patch, 20).std() < 24e-6  # 15-20 um, and the seed's luck


def test_a_shared_road_cannot_be_written_to() -> None:
    patch = assembly.road_patch(Road(**ROAD))
    with pytest.raises(ValueError, match="read-only"):
        patch.heights[0, 0] = 0.0


def test_a_road_file_is_read_in_its_unit_and_cut_to_the_middle(tmp_path: Path) -> None:
    scan = np.random.default_rng(1).standard_normal((140, 160))
    np.save(tmp_path / "scan.npy", scan)
    file = {"file": str(tmp_path / "scan.npy"), "pitch": 5e-5, "height_unit": "um"}
    patch = assembly.road_patch(Road(**ROAD, **file))
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


def test_springs_follow_the_modulus_and_the_exchange() -> None:
    scenario = small()
    patch, depth = assembly.road_patch(scenario.road), np.full(36, 9e-6)
    force, _ = assembly.roughness_springs(patch, scenario).force_and_stiffness(depth)
    scenario.springs.youngs_modulus *= 2
    doubled, _ = assembly.roughness_springs(patch, scenario).force_and_stiffness(depth)
    np.testing.assert_allclose(doubled, 2 * force, rtol=1e-12)  # rounding
    scenario.springs.exchange_count = 10
    softer, _ = assembly.roughness_springs(patch, scenario).force_and_stiffness(depth)
    assert np.sum(softer != doubled) == 10
    assert softer.max() < doubled.max()


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        (
            {"springs.exchange_count": 19},
            "springs.exchange_count must be at most half .* 18, got 19",
        ),
        (
            {"numerics.kernel": "band-limited", "numerics.time_resolution_factor": 3},
            "numerics.time_resolution_factor must be 1, 2 or 4 for the band-limited .* got 3",
        ),
        (
            {"tread.thickness": 1e-4, "loading.max_indentation": 1e-4},
            "loading.max_indentation must be less than tread.thickness, 0.0001 m, got 0.0001 m",
        ),
        ({"numerics.lags": 25}, "numerics.lags must cover .* 0.499 ms or 26 samples, got 25"),
        ({"numerics.sampling_frequency": 1e6}, "numerics.lags must cover .* got 256"),
    ],
)
def test_settings_that_cannot_go_together_are_refused_before_the_run(
    changes: dict[str, object], sentence: str
) -> None:
    scenario = Scenario(road=ROAD)
    for path, value in changes.items():
        scenario.set(path, value)
    with pytest.raises(InputError, match=sentence):
        Simulation(scenario)


def test_the_thesis_tread_at_rest_is_its_dynamic_kernel_summed() -> None:
    for factor in (1, 2):
        settings = {"time_resolution_factor": factor, "lags": 32}
        moving = assembly.tread_kernel(small(kernel="band-limited", **settings))
        still = assembly.tread_kernel(small(kernel="static", statics="band-limited", **settings))
        assert (still.lags, still.time_step) == (1, np.inf)
        np.testing.assert_array_equal(still.values[0], moving.static_compliance)
    exact = assembly.tread_kernel(small(kernel="static", time_resolution_factor=2))
    assert exact.values[0, 0, 0] > still.values[0, 0, 0]  # interpolation takes some of it away


@pytest.mark.parametrize(("path", "value"), [("springs.exchange_count", 18), ("numerics.lags", 26)])
def test_settings_that_just_go_together_are_taken(path: str, value: int) -> None:
    scenario = Scenario(road=ROAD)
    scenario.set(path, value)
    assert Simulation(scenario).scenario.to_dict() == scenario.to_dict()


@pytest.mark.parametrize(
    ("kernel", "factor", "lags"),
    [("passive", 1, 16), ("passive", 3, 48), ("band-limited", 1, 16), ("band-limited", 4, 61)],
)
def test_a_kernel_covers_the_same_time_at_a_finer_step(kernel: str, factor: int, lags: int) -> None:
    found = assembly.tread_kernel(small(kernel=kernel, time_resolution_factor=factor))
    assert found.values.shape == (lags, 6, 6)
    assert found.time_step == pytest.approx(1 / 51200 / factor, rel=1e-12)  # a division
    assert found.spacing == pytest.approx(1e-3, rel=1e-12)


def test_a_static_kernel_has_one_lag_and_the_statics_of_the_passive_one() -> None:
    still = assembly.tread_kernel(small(kernel="static", time_resolution_factor=2))
    assert still.values.shape == (1, 6, 6)
    assert still.time_step == np.inf
    moving = assembly.tread_kernel(small()).static_compliance
    # rounding of sums over the contour
    np.testing.assert_allclose(moving, still.values[0], rtol=1e-6)


@pytest.mark.parametrize("factor", [3, 5, 16])
def test_a_band_limited_kernel_is_interpolated_to_factors_of_the_thesis_only(factor: int) -> None:
    with pytest.raises(InputError, match=f"must be 1, 2 or 4 to interpolate, got {factor}"):
        assembly.tread_kernel(small(kernel="band-limited", time_resolution_factor=factor))


def test_layers_carry_the_settings_from_the_top_down() -> None:
    top, base = assembly.tread_layers(Tread(static_modulus=1e7, base_thickness=2e-3, density=999))
    assert (top.thickness, top.density, top.poissons_ratio) == (10e-3, 999, 0.499)
    assert (base.thickness, base.density, base.poissons_ratio) == (2e-3, 2700, 0.33)
    assert top.modulus(np.array(0.0)) == 1e7
    assert base.modulus(np.array(0.0)) == 72e9
    slower = assembly.tread_layers(Tread(static_modulus=1e7, relaxation_time=1e-5))[0]
    assert abs(slower.modulus(1e4j)) > abs(top.modulus(1e4j))


@pytest.mark.parametrize(
    ("change", "duration", "end"),
    [
        ({"profile": "linear"}, 0.2e-3 / 0.03, 0.2e-3),
        ({"profile": "quadratic"}, np.sqrt(0.2e-3 / 4.5), 0.2e-3),
        ({"profile": "load-hold-unload"}, 0.2e-3 / 0.03 + 2e-3 + 0.4e-3 / 0.003, -0.2e-3),
    ],
)
def test_each_profile_takes_its_settings(
    change: dict[str, str], duration: float, end: float
) -> None:
    path = assembly.loading_path(Loading(**change))
    assert path.time[-1] == pytest.approx(duration, rel=1e-12)  # rounding of sums
    assert path.drive[-1] == end
