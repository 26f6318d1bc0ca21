r"""The Newton step: (1 + g_0 K) Delta = f, in the symmetric form

    (1 + S g' S) y = S f,    Delta = f - g_0 S y,    S = [K / (1 + K g_00)]^1/2,

g_00 the compliance of an element under its own force, g' that between different ones. It is
positive definite, its diagonal is 1, and conjugate gradients need a few products.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg.blas import daxpy

from tyrecontact.contact.lattice import Compliance
from tyrecontact.contact.neighbours import convolved

#: of so few elements a product costs no more than its preconditioner
_FEW = 1024


def newton_step(
    compliance: Compliance, stiffness: np.ndarray, imbalance: np.ndarray, accuracy: float
) -> np.ndarray:
    """Delta [m] of (1 + g_0 K) Delta = f.

    Parameters
    ----------
    compliance : g_0.  stiffness : K [N/m].  imbalance : f [m], shape (elements,).
    accuracy : what may be left of the right-hand side of the symmetric form [-].
    """
    scale = np.sqrt(stiffness / (1 + stiffness * compliance.self_compliance))
    y = _conjugate_gradients(compliance, scale, scale * imbalance, accuracy)
    y *= scale
    return imbalance - compliance.displacement(y)


def _conjugate_gradients(
    compliance: Compliance, scale: np.ndarray, right: np.ndarray, accuracy: float
) -> np.ndarray:
    """y of (1 + S g' S) y = S f, preconditioned by nearest neighbours (contact/neighbours.py).

    scipy's `cg` spends three times as long on its operators as the products take at 20 x 20.
    """
    y, residual = np.zeros_like(right), right.copy()
    stencil, shape = compliance.neighbours.stencil(scale), compliance.shape
    goal, rho, direction = accuracy**2 * (right @ right), 1.0, np.zeros_like(right)
    for _ in range(right.size):
        if not residual @ residual > goal:
            break
        guess = residual
        if right.size > _FEW:
            near = convolved(stencil, (scale * residual).reshape(shape)).ravel()
            guess = residual - scale * near
        last, rho = rho, residual @ guess
        direction *= rho / last
        direction += guess
        image = compliance.from_others(scale * direction)
        image *= scale
        image += direction
        share = rho / (direction @ image)
        y = daxpy(direction, y, a=share)
        residual = daxpy(image, residual, a=-share)
    return y
