"""Viscoelastic moduli E(s), and the layers that are made of them.

A modulus is a callable of the complex Laplace frequency s [1/s], Re s >= 0, that gives the
complex Young's modulus E(s) [Pa]; with s = 2 pi i f it is the dynamic modulus at f.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from tyrecontact.errors import InputError

Modulus = Callable[[np.ndarray], np.ndarray]


def _require_positive(value: float, what: str, unit: str) -> None:
    if not 0 < value < np.inf:
        raise InputError(f"{what} must be positive and finite, got {value} {unit}")


def _require_exponent(value: float) -> None:
    if not 0 < value <= 1:
        raise InputError(f"exponent must lie in (0, 1], got {value}")


@dataclass(frozen=True)
class FractionalKelvinVoigt:
    """E(s) = E0 [1 + (s tau)^alpha], causal, with a power law of loss (physics, section 4).

    The defaults meet both loss factors of the thesis' Appendix B, 0.005 at 10 Hz and 0.55 at
    50 kHz, with E0 = 25 MPa.

    Attributes
    ----------
    static_modulus : E0 [Pa].
    relaxation_time : tau [s].
    exponent : alpha [-], 0 < alpha <= 1.
    """

    static_modulus: float = 25e6
    relaxation_time: float = 3.717e-6
    exponent: float = 0.6091

    def __post_init__(self) -> None:
        _require_positive(self.static_modulus, "static_modulus", "Pa")
        _require_positive(self.relaxation_time, "relaxation_time", "s")
        _require_exponent(self.exponent)

    def __call__(self, laplace_frequency: np.ndarray) -> np.ndarray:
        s = np.asarray(laplace_frequency, dtype=complex)
        return self.static_modulus * (1 + (s * self.relaxation_time) ** self.exponent)


@dataclass(frozen=True)
class FractionalZener:
    """E(s) = E0 + (Einf - E0) (s tau)^alpha / [1 + (s tau)^alpha]: causal, glassy at the end.

    No causal material that stiffens from E0 to Einf has a larger loss factor than this one at
    alpha = 1, (Einf - E0) / (2 sqrt(E0 Einf)).

    Attributes
    ----------
    static_modulus : E0 [Pa].
    glassy_modulus : Einf >= E0 [Pa].
    relaxation_time : tau [s].
    exponent : alpha [-], 0 < alpha <= 1.

    Source: R. L. Bagley and P. J. Torvik, AIAA J. 21 (1983) 741-748.
    """

    static_modulus: float = 25e6
    glassy_modulus: float = 50e6
    relaxation_time: float = 3.717e-6
    exponent: float = 0.6091

    def __post_init__(self) -> None:
        _require_positive(self.static_modulus, "static_modulus", "Pa")
        _require_positive(self.glassy_modulus, "glassy_modulus", "Pa")
        _require_positive(self.relaxation_time, "relaxation_time", "s")
        _require_exponent(self.exponent)
        if self.glassy_modulus < self.static_modulus:
            raise InputError(
                f"glassy_modulus must be at least static_modulus, {self.static_modulus:g} Pa, "
                f"got {self.glassy_modulus:g} Pa"
            )

    def __call__(self, laplace_frequency: np.ndarray) -> np.ndarray:
        s = np.asarray(laplace_frequency, dtype=complex)
        power = (s * self.relaxation_time) ** self.exponent
        rise = self.glassy_modulus - self.static_modulus
        return self.static_modulus + rise * power / (1 + power)


@dataclass(frozen=True)
class NearlyConstantLoss:
    """E(s) = E0 [1 + (2 eta / pi) ln(1 + s / s0)]: a nearly constant loss factor, causal.

    A loss factor that is the same at every frequency, E0 (1 + i eta), is not causal; this is
    the causal law that comes closest to it and is E0 at rest.

    Attributes
    ----------
    static_modulus : E0 [Pa].
    loss_factor : eta [-], 0 <= eta < 0.1 (the law is the first order in eta).
    corner_frequency : s0 / 2 pi [Hz], from ten times which on the loss factor is eta.
    """

    static_modulus: float
    loss_factor: float = 0.0
    corner_frequency: float = 1.0

    def __post_init__(self) -> None:
        _require_positive(self.static_modulus, "static_modulus", "Pa")
        if not 0 <= self.loss_factor < 0.1:
            raise InputError(f"loss_factor must lie in [0, 0.1), got {self.loss_factor}")
        _require_positive(self.corner_frequency, "corner_frequency", "Hz")

    def __call__(self, laplace_frequency: np.ndarray) -> np.ndarray:
        s = np.asarray(laplace_frequency, dtype=complex)
        slope = 2 * self.loss_factor / np.pi
        return self.static_modulus * (1 + slope * np.log1p(s / (2 * np.pi * self.corner_frequency)))


@dataclass(frozen=True)
class Layer:
    """One homogeneous, isotropic layer of the plate.

    Attributes
    ----------
    thickness : [m].
    density : [kg/m3].
    modulus : callable E(s) [Pa] of the complex Laplace frequency s [1/s].
    poissons_ratio : [-], between -1 and 0.5 (both excluded), the same at every frequency.

    Raises
    ------
    InputError : a thickness or density that is not positive, a Poisson's ratio out of bounds.
    """

    thickness: float
    density: float
    modulus: Modulus
    poissons_ratio: float

    def __post_init__(self) -> None:
        _require_positive(self.thickness, "thickness of a layer", "m")
        _require_positive(self.density, "density of a layer", "kg/m³")
        if not -1 < self.poissons_ratio < 0.5:
            raise InputError(f"poissons_ratio must lie in (-1, 0.5), got {self.poissons_ratio}")

    @property
    def wave_speed_ratio_squared(self) -> float:
        """(c_s / c_p)^2 = (1 - 2 nu) / (2 - 2 nu) [-]."""
        return (1 - 2 * self.poissons_ratio) / (2 - 2 * self.poissons_ratio)

    def shear_modulus(self, laplace_frequency: np.ndarray) -> np.ndarray:
        """Complex shear modulus mu(s) [Pa], shaped as `laplace_frequency` [1/s]."""
        return self.modulus(laplace_frequency) / (2 * (1 + self.poissons_ratio))
