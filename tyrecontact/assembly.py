"""From settings to bodies: the road, its springs, the tread and the loading of a scenario."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from tyrecontact import loading
from tyrecontact.errors import InputError
from tyrecontact.road import heights, scans, springs, textures
from tyrecontact.road.heights import Patch
from tyrecontact.road.springs import Springs
from tyrecontact.scenario import Loading, Road, Scenario, Tread
from tyrecontact.tread import cache, kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

#: the same few roads are asked for again and again
_worn = lru_cache(maxsize=4)(textures.worn)


def require_consistent(scenario: Scenario) -> None:
    """Refuse settings that cannot go together, before anything is computed.

    Raises
    ------
    InputError : one sentence that names the settings.
    """
    numerics, tread, loading_ = scenario.numerics, scenario.tread, scenario.loading
    half = scenario.road.elements**2 // 2
    if scenario.springs.exchange_count > half:
        count = scenario.springs.exchange_count
        raise InputError(
            f"springs.exchange_count must be at most half the elements, {half}, got {count}"
        )
    if numerics.kernel == "band-limited" and numerics.time_resolution_factor not in (1, 2, 4):
        raise InputError(
            "numerics.time_resolution_factor must be 1, 2 or 4 for the band-limited kernel, "
            f"got {numerics.time_resolution_factor}"
        )
    if loading_.max_indentation >= tread.thickness:
        raise InputError(
            f"loading.max_indentation must be less than tread.thickness, {tread.thickness:g} m, "
            f"got {loading_.max_indentation:g} m"
        )
    memory, needed = numerics.lags / numerics.sampling_frequency, _shear_transits(tread)
    if numerics.kernel != "static" and memory < needed:
        raise InputError(
            f"numerics.lags must cover the ringing of the tread, {needed * 1e3:.3g} ms or "
            f"{needed * numerics.sampling_frequency:.0f} samples, got {numerics.lags}"
        )


def _shear_transits(tread: Tread) -> float:
    """Time in which a shear wave crosses the tread four times [s]: shorter kernels are unstable."""
    top = tread_layers(tread)[0]
    speed = np.sqrt(np.real(top.shear_modulus(np.zeros(()))) / top.density)
    return float(4 * top.thickness / speed)


def road_patch(road: Road) -> Patch:
    """The patch of road that a scenario asks for, cut to its size.

    Raises
    ------
    InputError : a road file that cannot be used, or that is too small or too coarse.
    """
    if road.file:
        found = scans.read(road.file, pitch=road.pitch or None, unit=road.height_unit or None)
        return heights.centred(found, road.elements, road.size)
    made = _worn(
        road.size,
        road.pixel,
        valley_rms=road.valley_rms,
        plateau_rms=road.plateau_rms,
        offset=road.valley_offset,
        stone_size=road.stone_size,
        plateau_wavelength=road.plateau_wavelength,
        hurst=road.hurst,
        seed=road.seed,
    )
    made.heights.flags.writeable = False  # it is shared
    return heights.centred(made, road.elements, road.size)


def roughness_springs(patch: Patch, scenario: Scenario) -> Springs:
    """Springs of all elements of a patch, after the exchange."""
    settings, elements = scenario.springs, scenario.road.elements
    blocks = heights.element_heights(patch, elements).reshape(elements**2, -1)
    original = springs.from_heights(blocks, patch.pitch, settings.youngs_modulus)
    return springs.exchange_stiffest(
        original, settings.exchange_count, settings.exchange_compression
    )


def tread_kernel(scenario: Scenario) -> Kernel:
    """The kernel that a scenario asks for, from the cache on disk where it is there.

    At a finer time resolution the passive kernel is recomputed with as many more lags; the
    band-limited one is interpolated, as in the thesis.
    """
    numerics, road = scenario.numerics, scenario.road
    layers, shape = tread_layers(scenario.tread), (road.elements, road.elements)
    spacing, time_step = road.size / road.elements, 1 / numerics.sampling_frequency
    factor = numerics.time_resolution_factor
    if numerics.kernel == "static":
        return cache.static(layers, shape, spacing)
    if numerics.kernel == "passive":
        return cache.passive(layers, shape, spacing, time_step / factor, numerics.lags * factor)
    coarse = cache.band_limited(layers, shape, spacing, time_step, numerics.lags)
    return kernels.interpolated(coarse, factor)


def tread_layers(tread: Tread) -> list[Layer]:
    """The layers of a tread, from the top down."""
    rubber = FractionalKelvinVoigt(tread.static_modulus, tread.relaxation_time, tread.exponent)
    base = NearlyConstantLoss(tread.base_modulus, tread.base_loss_factor)
    return [
        Layer(tread.thickness, tread.density, rubber, tread.poissons_ratio),
        Layer(tread.base_thickness, tread.base_density, base, tread.base_poissons_ratio),
    ]


def loading_path(settings: Loading) -> loading.Path:
    """The path of the road that the settings of the loading stand for."""
    if settings.profile == "linear":
        return loading.linear(settings.max_indentation, settings.rate)
    if settings.profile == "quadratic":
        return loading.quadratic(settings.max_indentation, settings.acceleration)
    return loading.load_hold_unload(
        settings.max_indentation,
        settings.rate,
        settings.hold_time,
        settings.unloading_rate,
        settings.retraction,
    )
