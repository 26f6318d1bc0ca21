"""Settings that cannot go together are refused before anything is computed."""

from __future__ import annotations

import numpy as np

from tyrecontact.assembly.tread import tread_layers
from tyrecontact.errors import InputError
from tyrecontact.loading import Path
from tyrecontact.parts.tread import Tread
from tyrecontact.scenario import Scenario

#: laws whose elements unload as punches of frozen area
PUNCH_LAWS = ("receding-contact", "hysteresis")


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
    if scenario.adhesion.law in PUNCH_LAWS and scenario.springs.reading == "secant":
        raise InputError(
            f"springs.reading must be tangent for the adhesion law {scenario.adhesion.law}, got "
            "secant: a punch of frozen area would push back more than it was pressed with"
        )
    prescribed = loading_.drive != "force" and loading_.profile != "table"
    if prescribed and loading_.max_indentation >= tread.thickness:
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


def require_shallow(path: Path, scenario: Scenario) -> None:
    """Refuse a rigid drive that presses the road through the tread.

    Raises
    ------
    InputError : that, in one sentence.
    """
    deepest, thickness = float(path.drive.max()), scenario.tread.thickness
    if scenario.loading.drive == "rigid" and not deepest < thickness:
        raise InputError(
            f"loading.table must stay below tread.thickness, {thickness:g} m, got {deepest:g} m"
        )


def _shear_transits(tread: Tread) -> float:
    """Time in which a shear wave crosses the tread four times [s]: shorter kernels are unstable."""
    top = tread_layers(tread)[0]
    speed = np.sqrt(np.real(top.shear_modulus(np.zeros(()))) / top.density)
    return float(4 * top.thickness / speed)
