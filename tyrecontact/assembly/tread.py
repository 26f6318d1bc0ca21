"""From settings to the tread: its layers and its kernel."""

from __future__ import annotations

import numpy as np

from tyrecontact.parts.tread import Tread
from tyrecontact.scenario import Scenario
from tyrecontact.tread import cache, kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss


def tread_kernel(scenario: Scenario) -> Kernel:
    """The kernel that a scenario asks for, from the cache on disk where it is there.

    At a finer time resolution the passive kernel is recomputed with as many more lags; the
    band-limited one is interpolated, as in the thesis. That changes its sum over the lags, which
    is the thesis' kernel of the tread at rest (`numerics.statics`).
    """
    numerics, road = scenario.numerics, scenario.road
    layers, shape = tread_layers(scenario.tread), (road.elements, road.elements)
    spacing, time_step = road.size / road.elements, 1 / numerics.sampling_frequency
    factor = numerics.time_resolution_factor
    if numerics.kernel == "static" and numerics.statics == "exact":
        return cache.static(layers, shape, spacing)
    if numerics.kernel == "passive":
        return cache.passive(layers, shape, spacing, time_step / factor, numerics.lags * factor)
    coarse = cache.band_limited(layers, shape, spacing, time_step, numerics.lags)
    fine = kernels.interpolated(coarse, factor)
    if numerics.kernel == "static":
        return Kernel(fine.static_compliance[None], spacing, np.inf)
    return fine


def tread_layers(tread: Tread) -> list[Layer]:
    """The layers of a tread, from the top down."""
    rubber = FractionalKelvinVoigt(tread.static_modulus, tread.relaxation_time, tread.exponent)
    base = NearlyConstantLoss(tread.base_modulus, tread.base_loss_factor)
    return [
        Layer(tread.thickness, tread.density, rubber, tread.poissons_ratio),
        Layer(tread.base_thickness, tread.base_density, base, tread.base_poissons_ratio),
    ]
