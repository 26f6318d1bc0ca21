"""Settings that cannot go together are refused before anything is computed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tyrecontact.assembly.process import loading_path
from tyrecontact.assembly.tread import tread_layers, tread_thickness
from tyrecontact.errors import InputError
from tyrecontact.loading import Path
from tyrecontact.parts.process import Numerics
from tyrecontact.parts.tread import Tread
from tyrecontact.scenario import Scenario
from tyrecontact.tread.materials import Layer
from tyrecontact.tread.tabulated import Tabulated

#: memory of the thesis' kernel [s]: so much may outlast a run, since its fastest runs are shorter
_USUAL_MEMORY = 5e-3
#: laws whose elements unload as punches of frozen area
PUNCH_LAWS = ("receding-contact", "hysteresis")


def require_consistent(scenario: Scenario) -> None:
    """Refuse settings that cannot go together, before anything is computed.

    Raises
    ------
    InputError : one sentence that names the settings.
    """
    half = scenario.road.elements**2 // 2
    if scenario.springs.exchange_count > half:
        count = scenario.springs.exchange_count
        raise InputError(
            f"springs.exchange_count must be at most half the elements, {half}, got {count}"
        )
    if scenario.adhesion.law in PUNCH_LAWS and scenario.springs.reading == "secant":
        raise InputError(
            f"springs.reading must be tangent for the adhesion law {scenario.adhesion.law}, got "
            "secant: a punch of frozen area would push back more than it was pressed with"
        )
    layers = tread_layers(scenario.tread)
    _require_kernel(scenario.numerics, layers)
    if scenario.loading.drive != "force" and scenario.loading.profile != "table":
        _require_thickness(scenario.tread, scenario.loading.max_indentation)
    if scenario.numerics.kernel != "static":
        _require_lags(scenario, layers)


def require_shallow(path: Path, scenario: Scenario) -> None:
    """Refuse a rigid drive that presses the road through the tread.

    Raises
    ------
    InputError : that, in one sentence.
    """
    deepest, thickness = float(path.drive.max()), tread_thickness(scenario.tread)
    if scenario.loading.drive == "rigid" and not deepest < thickness:
        raise InputError(
            f"loading.table must stay below tread.thickness, {thickness:g} m, got {deepest:g} m"
        )


def _require_kernel(numerics: Numerics, layers: Sequence[Layer]) -> None:
    """The kernel can be had for the material, and at the finer time step."""
    tabulated = any(isinstance(layer.modulus, Tabulated) for layer in layers)
    if numerics.kernel == "passive" and tabulated:
        raise InputError(
            "numerics.kernel must be band-limited, passive-mobility or static for a tabulated "
            "modulus, got passive: a table is not causal and has no continuation to complex s"
        )
    interpolated = numerics.kernel == "band-limited" and numerics.refinement == "interpolated"
    if interpolated and numerics.time_resolution_factor not in (1, 2, 4):
        raise InputError(
            "numerics.time_resolution_factor must be 1, 2 or 4 for the band-limited kernel, "
            f"interpolated, got {numerics.time_resolution_factor}"
        )


def _require_thickness(tread: Tread, indentation: float) -> None:
    """The road stays above the bottom of the tread."""
    thickness = tread_thickness(tread)
    if indentation >= thickness:
        what = "the thickness of tread.layers" if tread.layers else "tread.thickness"
        raise InputError(
            f"loading.max_indentation must be less than {what}, {thickness:g} m, "
            f"got {indentation:g} m"
        )


def _require_lags(scenario: Scenario, layers: Sequence[Layer]) -> None:
    """The kernel's memory holds the ringing of the tread, and little that no run can reach."""
    numerics = scenario.numerics
    rate, lags = numerics.sampling_frequency, numerics.lags
    needed = _shear_transits(layers)
    if lags / rate < needed:
        raise InputError(
            f"numerics.lags must cover the ringing of the tread, {needed * 1e3:.3g} ms or "
            f"{np.ceil(needed * rate):.0f} samples, got {lags}"
        )
    duration = float(loading_path(scenario.loading).time[-1])
    most = max(np.ceil(max(duration, needed, _USUAL_MEMORY) * rate), 2)  # fewer are none
    if lags > most:
        raise InputError(
            f"numerics.lags must be at most {most:.0f}, the steps of the loading at the sampling "
            f"frequency or 5 ms, got {lags}"
        )


def _shear_transits(layers: Sequence[Layer]) -> float:
    """Time in which a shear wave crosses the tread four times [s]: shorter kernels are unstable."""
    zero = np.zeros(())
    return float(
        sum(
            4 * layer.thickness / np.sqrt(np.real(layer.shear_modulus(zero)) / layer.density)
            for layer in layers
        )
    )
