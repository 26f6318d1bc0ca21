r"""Surface compliance of a layered viscoelastic plate on a rigid base (physics, section 3).

A pressure p exp(i k x + s t) on the surface displaces it by C(k, s) p. In each layer the
displacement (i U, W), depth z counted from the layer's top, is a sum of P and S waves that
decay downwards (sign = +1, zeta = z) or upwards (sign = -1, zeta = thickness - z):

    P: (U, W) = (k, -sign gamma_p) exp(-gamma_p zeta),   gamma_p^2 = k^2 + s^2 / c_p^2
    S: (U, W) = (gamma_s, -sign k) exp(-gamma_s zeta),   gamma_s^2 = k^2 + s^2 / c_s^2

with stresses (shear T, normal N)

    P: (T, N) = mu (-sign 2 k gamma_p, gamma_s^2 + k^2) exp(-gamma_p zeta)
    S: (T, N) = mu (-sign (gamma_s^2 + k^2), 2 k gamma_s) exp(-gamma_s zeta)

P and S become one as s / (c k) -> 0. The basis used is therefore P and the divided difference
D = (P - S) / (gamma_s - gamma_p), written out so that nothing cancels: statics (s = 0) is then
no special case. Growing exponentials never appear, so nothing overflows.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.tread.materials import Layer


def surface_compliance(
    wavenumber: np.ndarray, laplace_frequency: np.ndarray, layers: Sequence[Layer]
) -> np.ndarray:
    """Normal displacement of the surface per unit pressure on it.

    Parameters
    ----------
    wavenumber : k >= 0 [rad/m]; any shape.
    laplace_frequency : s [1/s], complex with Re s >= 0; any shape that broadcasts with k.
    layers : from the top down; rigid below the last.

    Returns
    -------
    C(k, s) [m/Pa], complex, of the broadcast shape. For static loads of small k x thickness
    rounding grows as (k x thickness)^-3; k = s = 0 itself is exact (oedometer).

    Raises
    ------
    InputError : no layer, or a wavenumber that is negative or not finite.

    Source: physics.md section 3; P-SV theory as in Achenbach, Wave Propagation in Elastic
    Solids (1973), chapter 5; the recursion is that of the compliance matrix from the base up.
    """
    k, s = np.broadcast_arrays(
        np.asarray(wavenumber, float), np.asarray(laplace_frequency, complex)
    )
    if not layers:
        raise InputError("layers must hold at least one layer, got none")
    if not np.all((k >= 0) & np.isfinite(k)):
        raise InputError("wavenumber must be finite and not negative, in rad/m")
    at_rest = (k == 0) & (s == 0)
    thickness = sum(layer.thickness for layer in layers)
    k = np.where(at_rest, 1 / thickness, k)  # any regular value: replaced below
    below = np.zeros((2, 2, *k.shape), complex)  # (U, W) per (T, N) at the layer's bottom
    for layer in reversed(layers):
        below = _compliance_on_top(k, s, layer, below)
    return np.where(at_rest, _oedometer_compliance(layers), -below[1, 1])


def _compliance_on_top(k: np.ndarray, s: np.ndarray, layer: Layer, below: np.ndarray) -> np.ndarray:
    """Compliance matrix (2, 2, ...) on top of a layer, from that under it."""
    waves = _Waves(k, s, layer)
    near_u, near_t = waves.fields(0.0)
    far_u, far_t = waves.fields(layer.thickness)
    # of waves that go up W and T change sign
    flip = np.array([1.0, -1.0]).reshape(2, 1, *[1] * k.ndim)
    mismatch = _inverse(near_u * flip + _product(below, near_t * flip))
    reflection = _product(mismatch, _product(below, far_t) - far_u)
    displacement = near_u + _product(far_u * flip, reflection)
    stress = near_t - _product(far_t * flip, reflection)
    return _product(displacement, _inverse(stress))


def _product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Product of matrices (2, 2, ...): written out, several times faster than `@`."""
    return np.array([[row[0] * b[0, j] + row[1] * b[1, j] for j in (0, 1)] for row in a])


def _inverse(a: np.ndarray) -> np.ndarray:
    """Inverse of matrices (2, 2, ...)."""
    (p, q), (r, s) = a
    return np.array([[s, -q], [-r, p]]) / (p * s - q * r)


class _Waves:
    """The two basis waves, P and D, of one layer at all (k, s)."""

    def __init__(self, k: np.ndarray, s: np.ndarray, layer: Layer) -> None:
        ratio = layer.wave_speed_ratio_squared
        self.k, self.shear_modulus = k, layer.shear_modulus(s)
        slowness_squared = s**2 * layer.density / self.shear_modulus  # (s / c_s)^2
        self.p = np.sqrt(k**2 + ratio * slowness_squared)
        self.s = np.sqrt(k**2 + slowness_squared)
        both = self.p + self.s
        self.gap = (1 - ratio) * slowness_squared / both  # gamma_s - gamma_p
        self.p_part = ratio / (1 - ratio) * both / (self.p + k)  # (gamma_p - k) / gap
        self.s_part = 1 / (1 - ratio) * both / (self.s + k)  # (gamma_s - k) / gap

    def fields(self, zeta: float) -> tuple[np.ndarray, np.ndarray]:
        """Displacements [[P_U, D_U], [P_W, D_W]] and stresses [[P_T, D_T], [P_N, D_N]].

        Of the waves that go down (sign = +1).
        """
        k, p, s = self.k, self.p, self.s
        decay_p, decay_s = np.exp(-p * zeta), np.exp(-s * zeta)
        spread = self._divided_exponential(decay_p, decay_s, zeta)
        twist = s**2 + k**2
        displacement = [
            [k * decay_p, k * spread - self.s_part * decay_s],
            [-p * decay_p, -(p * spread + self.p_part * decay_s)],
        ]
        shear_part = 2 * k * self.p_part - (s + k) * self.s_part
        stress = [
            [-2 * k * p * decay_p, -(2 * k * p * spread + shear_part * decay_s)],
            [twist * decay_p, twist * spread + (s - k) * self.s_part * decay_s],
        ]
        return np.array(displacement), self.shear_modulus * np.array(stress)

    def _divided_exponential(
        self, decay_p: np.ndarray, decay_s: np.ndarray, zeta: float
    ) -> np.ndarray:
        """(exp(-gamma_p zeta) - exp(-gamma_s zeta)) / (gamma_s - gamma_p), also where they meet."""
        x = self.gap * zeta
        small = np.abs(x) < 0.5
        safe = np.where(small & (x != 0), x, 1.0)
        near = zeta * decay_s * np.where(x == 0, 1.0, np.expm1(safe) / safe)
        far = (decay_p - decay_s) / np.where(small, 1.0, self.gap)
        return np.where(small, near, far)


def _oedometer_compliance(layers: Sequence[Layer]) -> float:
    """Sum of h (1 + nu)(1 - 2 nu) / (E (1 - nu)) [m/Pa]: uniform static load, no side strain."""
    compliance = 0.0
    for layer in layers:
        nu, modulus = layer.poissons_ratio, float(np.real(layer.modulus(np.zeros(()))))
        compliance += layer.thickness * (1 + nu) * (1 - 2 * nu) / (modulus * (1 - nu))
    return compliance
