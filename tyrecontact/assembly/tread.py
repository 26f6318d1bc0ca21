"""From settings to the tread: its layers and its kernel."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.parts.tread import Tread
from tyrecontact.scenario import Scenario
from tyrecontact.tread import cache, kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import (
    FractionalKelvinVoigt,
    FractionalZener,
    Layer,
    Modulus,
    NearlyConstantLoss,
)
from tyrecontact.tread.tabulated import APPENDIX_B, read_table


def tread_kernel(scenario: Scenario) -> Kernel:
    """The kernel that a scenario asks for, from the cache on disk where it is there.

    At a finer time resolution a kernel is recomputed with as many more lags; the band-limited
    one is interpolated, as in the thesis, unless `numerics.refinement` says otherwise.
    The sum of the band-limited kernel over its lags, interpolation included, is the thesis' kernel
    of the tread at rest (`numerics.statics`).
    """
    numerics, road = scenario.numerics, scenario.road
    layers, shape = tread_layers(scenario.tread), (road.elements, road.elements)
    spacing, coarse_step = road.size / road.elements, 1 / numerics.sampling_frequency
    factor = numerics.time_resolution_factor
    time_step, lags = coarse_step / factor, numerics.lags * factor
    at_rest = numerics.kernel == "static"
    if at_rest and numerics.statics == "exact":
        return cache.static(layers, shape, spacing)
    if numerics.kernel == "passive":
        return cache.passive(layers, shape, spacing, time_step, lags, numerics.quadrature)
    if numerics.kernel == "passive-mobility":
        return cache.passive_mobility(layers, shape, spacing, time_step, lags)
    if numerics.refinement == "recomputed":
        moving = cache.band_limited(layers, shape, spacing, time_step, lags)
    else:
        coarse = cache.band_limited(layers, shape, spacing, coarse_step, numerics.lags)
        moving = kernels.interpolated(coarse, factor)
    return Kernel(moving.static_compliance[None], spacing, np.inf) if at_rest else moving


def tread_thickness(tread: Tread) -> float:
    """How deep a road could go [m]: `tread.thickness`, or that of all `tread.layers`."""
    if tread.layers:
        return float(sum(layer["thickness"] for layer in tread.layers))
    return float(tread.thickness)


def tread_layers(tread: Tread) -> list[Layer]:
    """The layers of a tread, from the top down.

    Raises
    ------
    InputError : moduli that cannot be, or a table of a modulus that cannot be used.
    """
    if tread.layers:
        return [_layer(number, table) for number, table in enumerate(tread.layers, start=1)]
    base = NearlyConstantLoss(tread.base_modulus, tread.base_loss_factor)
    return [
        Layer(tread.thickness, tread.density, _modulus(tread.param.values()), tread.poissons_ratio),
        Layer(tread.base_thickness, tread.base_density, base, tread.base_poissons_ratio),
    ]


def _layer(number: int, table: Mapping[str, Any]) -> Layer:
    """The layer that a table of `tread.layers` stands for."""
    try:
        return Layer(table["thickness"], table["density"], _modulus(table), table["poissons_ratio"])
    except InputError as error:
        raise InputError(f"layer {number} of tread.layers: {error}") from None


def _modulus(settings: Mapping[str, Any]) -> Modulus:
    """The modulus of a material, from the settings that it has."""
    material = settings["material"]
    if material == "tabulated":
        return read_table(settings["modulus_table"]) if settings["modulus_table"] else APPENDIX_B
    if material == "nearly-constant-loss":
        return NearlyConstantLoss(settings["youngs_modulus"], settings["loss_factor"])
    at_rest, time = settings["static_modulus"], settings["relaxation_time"]
    if material == "fractional-zener":
        return FractionalZener(at_rest, settings["glassy_modulus"], time, settings["exponent"])
    return FractionalKelvinVoigt(at_rest, time, settings["exponent"])
