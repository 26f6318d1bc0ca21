"""From settings to the road: its patch and its roughness springs."""

from __future__ import annotations

from functools import lru_cache

from tyrecontact.parts.road import Road
from tyrecontact.road import heights, scans, springs, textures
from tyrecontact.road.heights import Patch
from tyrecontact.road.springs import Springs
from tyrecontact.scenario import Scenario

#: the same few roads are asked for again and again
_worn = lru_cache(maxsize=4)(textures.worn)


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
        polish=road.polish,
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
