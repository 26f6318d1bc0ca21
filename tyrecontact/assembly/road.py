"""From settings to the road: its patch and its roughness springs."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.parts.road import Road
from tyrecontact.parts.road import Springs as SpringSettings
from tyrecontact.road import heights, isotropic, prepare, scans, springs, textures
from tyrecontact.road.heights import Patch
from tyrecontact.road.scan import Scan
from tyrecontact.road.springs import Springs
from tyrecontact.road.understood import Understood, understood
from tyrecontact.scenario import Scenario

#: the same few roads are asked for again and again
_worn, _self_affine, _clipped = (
    lru_cache(maxsize=4)(make) for make in (textures.worn, textures.self_affine, textures.clipped)
)


@lru_cache(maxsize=2)
def _isotropic(heights: bytes, pitch: float, size: float, seed: int) -> Patch:
    """An isotropic road, by the heights of its profile: a file may change under its name."""
    made = isotropic.from_profile(np.frombuffer(heights), pitch, size, seed)
    made.heights.flags.writeable = False  # it is shared
    return made


def road_patch(road: Road) -> Patch:
    """The patch of road that a scenario asks for, cut to its size.

    Raises
    ------
    InputError : a road file that cannot be used, or that is too small or too coarse.
    """
    if road.file:
        return patch_of(road_scan(road), road)
    return heights.centred(_made(road), road.elements, road.size)


def road_scan(road: Road) -> Scan:
    """The road file that a scenario asks for: read, trimmed, turned and levelled as it says.

    Raises
    ------
    InputError : no file, or one that cannot be used; pitch or unit that it does not carry.
    """
    if not road.file:
        raise InputError("road.file must name a file to be read, got ''")
    return prepared(
        scans.read(road.file, pitch=road.pitch or None, unit=road.height_unit or None), road
    )


def prepared(scan: Scan, road: Road) -> Scan:
    """A scan that was read, trimmed, turned and levelled as settings say; `InputError` if not."""
    scan = prepare.trimmed(scan, road.trim_start, road.trim_end)
    if road.height_direction == "down":
        scan = prepare.turned_over(scan)
    return prepare.levelled(scan) if road.levelling == "plane" else scan


def road_understood(road: Road) -> Understood:
    """What was understood of a scenario's road file, as it goes into the patch."""
    return understood(road_scan(road))


def with_ends(kept: Scan, scan: Scan, road: Road) -> Scan:
    """What was `prepared` of a scan, turned and levelled likewise, its trimmed ends on again."""
    if kept.heights.shape == scan.heights.shape:
        return kept
    heights = -scan.heights if road.height_direction == "down" else scan.heights
    first = round(road.trim_start / scan.pitch)
    line = heights[first : first + kept.heights.size] - kept.heights
    known = np.flatnonzero(np.isfinite(line))
    begin, end = known[0], known[-1]
    slope = (line[end] - line[begin]) / max(1, end - begin)
    place = np.arange(heights.size) - first - begin
    return scan.changed(heights - line[begin] - slope * place)


def patch_of(scan: Scan, road: Road) -> Patch:
    """The patch that settings ask for of a scan that is `prepared`: cut and filled.

    Raises
    ------
    InputError : a scan that is too small or too coarse, or of which too much is missing.
    """
    return heights.centred(_cut_and_filled(scan, road), road.elements, road.size)


def _cut_and_filled(scan: Scan, road: Road) -> Patch:
    if scan.is_profile and road.profile_use == "isotropic":
        whole = prepare.filled(scan, road.fill_limit)
        return _isotropic(whole.heights.tobytes(), whole.pitch, road.size, road.seed)
    part = prepare.filled(
        prepare.cut(scan, road.size, road.centre_x, road.centre_y), road.fill_limit
    )
    if not part.is_profile:
        return Patch(part.heights, part.pitch)
    # drawn out along y: the same line in each row
    return Patch(np.tile(part.heights, (part.heights.size, 1)), part.pitch)


def _made(road: Road) -> Patch:
    common = {"hurst": road.hurst, "seed": road.seed}
    if road.texture == "self-affine":
        made = _self_affine(
            road.size, road.pixel, road.valley_rms, roll_off_wavelength=road.stone_size, **common
        )
    elif road.texture == "clipped":
        made = _clipped(
            road.size,
            road.pixel,
            road.valley_rms,
            clip_height=road.clip_height,
            stone_size=road.stone_size,
            **common,
        )
    else:
        made = _worn(
            road.size,
            road.pixel,
            valley_rms=road.valley_rms,
            plateau_rms=road.plateau_rms,
            offset=road.valley_offset,
            stone_size=road.stone_size,
            plateau_wavelength=road.plateau_wavelength,
            polish=road.polish,
            **common,
        )
    made.heights.flags.writeable = False  # it is shared
    return made


def roughness_springs(patch: Patch, scenario: Scenario) -> Springs:
    """Springs of all elements of a patch: read, exchanged, then simplified."""
    return arranged_springs(original_springs(patch, scenario), scenario.springs)


def original_springs(patch: Patch, scenario: Scenario) -> Springs:
    """Springs of all elements of a patch, as read off its heights."""
    settings, elements = scenario.springs, scenario.road.elements
    blocks = heights.element_heights(patch, elements).reshape(elements**2, -1)
    return springs.from_heights(
        blocks,
        patch.pitch,
        settings.youngs_modulus,
        bonded=settings.punch == "no-slip",
        reading=settings.reading,
        smoothing=settings.smoothing,
    )


def arranged_springs(original: Springs, settings: SpringSettings) -> Springs:
    """Springs as read, exchanged, then simplified; the same object where neither is asked for."""
    exchanged = springs.exchange_stiffest(
        original,
        settings.exchange_count,
        settings.exchange_compression,
        settings.exchange_ranking,
    )
    return _simplified(exchanged, settings)


def _simplified(original: Springs, settings: SpringSettings) -> Springs:
    if settings.simplification == "mean":
        return springs.mean(original)
    if settings.simplification == "standard":
        return springs.standard(original, settings.standard_count)
    if settings.simplification == "linear":
        return springs.linearised(original, settings.linear_compression)
    return original
