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
from tyrecontact.tread import kernels
from tyrecontact.tread.materials import (
    FractionalKelvinVoigt,
    FractionalZener,
    Layer,
    NearlyConstantLoss,
)
from tyrecontact.tread.tabulated import APPENDIX_B, Tabulated

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
        {"polish": 6.0},
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
    "change",
    [
        {"punch": "no-slip"},
        {"reading": "secant"},
        {"smoothing": "polynomial"},
        {"simplification": "mean"},
        {"simplification": "standard"},
        {"simplification": "linear"},
        {"exchange_count": 10},
    ],
    ids=lambda change: next(iter(change.values())),
)
def test_every_kind_of_spring_runs_to_the_end(quick: Scenario, change: dict[str, object]) -> None:
    plain = Simulation(quick)
    for name, value in change.items():
        quick.set(f"springs.{name}", value)
    simulation = Simulation(quick)
    delta = np.full(36, 9e-6)
    assert np.any(simulation.springs.force(delta) != plain.springs.force(delta))
    results = simulation.run()
    assert results.converged.all()
    assert len(results.contact_force) == len(simulation)
    assert np.all(np.diff(results.contact_force) > 0)


@pytest.mark.parametrize(
    ("first", "then"),
    [
        (
            {"simplification": "standard", "standard_count": 2},
            {"simplification": "standard", "standard_count": 5},
        ),
        (
            {"simplification": "linear", "linear_compression": 5e-6},
            {"simplification": "linear", "linear_compression": 2e-5},
        ),
        (
            {"exchange_count": 6, "exchange_compression": 1e-6},
            {"exchange_count": 6, "exchange_compression": 1e-4},
        ),
        (
            {"exchange_count": 6, "exchange_compression": 2e-6},
            {
                "exchange_count": 6,
                "exchange_compression": 2e-6,
                "exchange_ranking": "stiffness",
            },
        ),
    ],
)
def test_what_refines_a_kind_of_spring_matters(
    first: dict[str, object], then: dict[str, object]
) -> None:
    patch, delta = assembly.road_patch(Road(**ROAD)), np.full(36, 9e-6)
    force = [
        assembly.roughness_springs(patch, Scenario(road=ROAD, springs=springs)).force(delta)
        for springs in (first, then)
    ]
    assert np.any(force[0] != force[1])


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
        ({"numerics.lags": 25}, "numerics.lags must cover .* 0.503 ms or 26 samples, got 25"),
        ({"numerics.lags": 343}, "numerics.lags must be at most 342, the steps of the .*, got 343"),
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


@pytest.mark.parametrize(
    ("path", "value"),
    [("springs.exchange_count", 18), ("numerics.lags", 26), ("numerics.lags", 342)],
)
def test_settings_that_just_go_together_are_taken(path: str, value: int) -> None:
    scenario = Scenario(road=ROAD)
    scenario.set(path, value)
    assert Simulation(scenario).scenario.to_dict() == scenario.to_dict()


@pytest.mark.parametrize(
    ("kernel", "factor", "lags"),
    [("passive", 1, 16), ("passive", 3, 48), ("passive-mobility", 5, 80),
     ("band-limited", 1, 16), ("band-limited", 4, 61)],
)  # fmt: skip
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


@pytest.mark.parametrize("factor", [1, 2, 3])
def test_a_band_limited_kernel_is_recomputed_at_any_factor(factor: int) -> None:
    settings = {"kernel": "band-limited", "refinement": "recomputed"}
    found = assembly.tread_kernel(small(**settings, time_resolution_factor=factor))
    layers = assembly.tread_layers(Tread())
    anew = kernels.band_limited(layers, (6, 6), 1e-3, 1 / 51200 / factor, 16 * factor)
    np.testing.assert_array_equal(found.values, anew.values)
    Simulation(Scenario(road=ROAD, numerics={**settings, "time_resolution_factor": factor}))


def test_the_quadrature_arrives_at_the_passive_kernel() -> None:
    found = assembly.tread_kernel(small(quadrature="BDF1"))
    layers = assembly.tread_layers(Tread())
    first = kernels.passive(layers, (6, 6), 1e-3, 1 / 51200, 16, "BDF1")
    np.testing.assert_array_equal(found.values, first.values)
    assert np.abs(found.values - assembly.tread_kernel(small()).values).max() > 1e-7


def test_a_sampling_rate_too_slow_for_the_loading_is_told_of_the_loading() -> None:
    scenario = Scenario(road=ROAD, numerics={"sampling_frequency": 10.0, "lags": 2})
    with pytest.raises(InputError, match=r"loading must take 3 to .* steps"):
        Simulation(scenario)


def test_the_fastest_runs_of_the_thesis_may_keep_256_lags() -> None:
    """0.2 mm in 2 ms are 103 steps: lags that no step reaches cost time and change nothing."""
    scenario = Scenario(road=ROAD, loading={"rate": 0.1})
    assert len(Simulation(scenario)) == 103
    assert scenario.numerics.lags == 256


def test_layers_carry_the_settings_from_the_top_down() -> None:
    top, base = assembly.tread_layers(Tread(static_modulus=1e7, base_thickness=2e-3, density=999))
    assert (top.thickness, top.density, top.poissons_ratio) == (10e-3, 999, 0.499)
    assert (base.thickness, base.density, base.poissons_ratio) == (2e-3, 2700, 0.33)
    assert top.modulus(np.array(0.0)) == 1e7
    assert base.modulus(np.array(0.0)) == 72e9
    slower = assembly.tread_layers(Tread(static_modulus=1e7, relaxation_time=1e-5))[0]
    assert abs(slower.modulus(1e4j)) > abs(top.modulus(1e4j))


def test_the_material_is_chosen_by_name() -> None:
    zener = Tread(material="fractional-zener", glassy_modulus=6e7, exponent=0.5)
    found = assembly.tread_layers(zener)[0].modulus
    assert found == FractionalZener(25e6, 6e7, 3.717e-6, 0.5)
    assert assembly.tread_layers(Tread(material="tabulated"))[0].modulus is APPENDIX_B
    assert assembly.tread_layers(Tread())[0].modulus == FractionalKelvinVoigt()


def test_a_table_of_ones_own_is_read(tmp_path: Path) -> None:
    (tmp_path / "modulus.csv").write_text("# f, E', eta\n10, 1e7, 0.02\n1e4, 3e7, 0.4\n")
    tread = Tread(material="tabulated", modulus_table=str(tmp_path / "modulus.csv"))
    expected = Tabulated((10.0, 1e4), (1e7, 3e7), (0.02, 0.4))
    assert assembly.tread_layers(tread)[0].modulus == expected


LAYERS = [
    {"thickness": 2e-3, "density": 1200, "poissons_ratio": 0.49, "material": "fractional-zener",
     "static_modulus": 5e6, "glassy_modulus": 5e8, "exponent": 0.6, "relaxation_time": 1e-7},
    {"thickness": 6e-3, "density": 1100, "poissons_ratio": 0.48,
     "material": "fractional-kelvin-voigt", "static_modulus": 8e6, "exponent": 0.5,
     "relaxation_time": 1e-6},
    {"thickness": 1e-3, "density": 7800, "poissons_ratio": 0.3,
     "material": "nearly-constant-loss", "youngs_modulus": 2.1e11, "loss_factor": 1e-3},
]  # fmt: skip


def test_any_number_of_layers_takes_the_place_of_the_two() -> None:
    assert assembly.tread_layers(Tread(layers=LAYERS)) == [
        Layer(2e-3, 1200, FractionalZener(5e6, 5e8, 1e-7, 0.6), 0.49),
        Layer(6e-3, 1100, FractionalKelvinVoigt(8e6, 1e-6, 0.5), 0.48),
        Layer(1e-3, 7800, NearlyConstantLoss(2.1e11, 1e-3), 0.3),
    ]
    layered = Scenario(road=ROAD, tread={"layers": LAYERS}, numerics={"lags": 32})
    kernel = assembly.tread_kernel(layered)
    two = assembly.tread_kernel(small(lags=32))
    # the top is five times as soft
    assert kernel.static_compliance[0, 0] > 3 * two.static_compliance[0, 0]


def test_the_two_layers_may_be_written_as_tables() -> None:
    tables = [
        {"thickness": 10e-3, "density": 1300.0, "poissons_ratio": 0.499,
         "material": "fractional-kelvin-voigt", "static_modulus": 25e6, "exponent": 0.6091,
         "relaxation_time": 3.717e-6},
        {"thickness": 3e-3, "density": 2700.0, "poissons_ratio": 0.33,
         "material": "nearly-constant-loss", "youngs_modulus": 72e9, "loss_factor": 5e-5},
    ]  # fmt: skip
    assert assembly.tread_layers(Tread(layers=tables)) == assembly.tread_layers(Tread())


@pytest.mark.parametrize(
    ("tread", "numerics", "sentence"),
    [
        ({"material": "tabulated"}, {}, "numerics.kernel must be band-limited, .* is not causal"),
        ({"layers": [{**LAYERS[2], "material": "tabulated"}]}, {}, "layer 1 of tread.layers: "),
        ({"material": "fractional-zener", "static_modulus": 6e7}, {}, "glassy_modulus must be at"),
        (
            {"layers": [LAYERS[2], {**LAYERS[0], "glassy_modulus": 1e6}]},
            {},
            "layer 2 of tread.layers: glassy_modulus must be at least static_modulus, 5e.06 Pa",
        ),
        (
            {"layers": [{**LAYERS[0], "thickness": 1e-4}]},
            {},
            "less than the thickness of tread.layers, 0.0001 m, got 0.0002 m",
        ),
        ({"material": "tabulated", "modulus_table": "none.txt"}, {}, "table must be readable"),
        ({"layers": LAYERS[1:]}, {"lags": 10}, "numerics.lags must cover the ringing"),
    ],
)
def test_treads_that_cannot_be_are_refused_before_the_run(
    tread: dict[str, object], numerics: dict[str, object], sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        Simulation(Scenario(road=ROAD, tread=tread, numerics=numerics))


@pytest.mark.parametrize("kernel", ["band-limited", "passive-mobility", "static"])
def test_kernels_on_the_imaginary_axis_take_a_table(kernel: str) -> None:
    scenario = Scenario(
        road=ROAD, tread={"material": "tabulated"}, numerics={"kernel": kernel, "lags": 32}
    )
    Simulation(scenario)
    stiff = assembly.tread_kernel(scenario).values[0, 0, 0]
    soft = assembly.tread_kernel(small(kernel=kernel, lags=32)).values[0, 0, 0]
    # 50 MPa where the default has 40; the same at rest
    assert stiff == pytest.approx(soft) if kernel == "static" else stiff < soft


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


def test_kinds_of_made_roads_differ_as_they_should() -> None:
    made = {
        kind: assembly.road_patch(Road(**ROAD, texture=kind, valley_rms=30e-6, clip_height=10e-6))
        for kind in ("self-affine", "worn", "clipped")
    }
    np.testing.assert_array_equal(
        made["clipped"].heights, np.minimum(made["self-affine"].heights, 10e-6)
    )
    assert np.mean(made["clipped"].heights == 10e-6) > 0.1  # flat tops
    assert made["clipped"].skewness < made["self-affine"].skewness
    assert not np.array_equal(made["worn"].heights, made["self-affine"].heights)


def test_no_file_cannot_be_understood() -> None:
    with pytest.raises(InputError, match=r"road\.file must name a file"):
        assembly.road_understood(Road())
