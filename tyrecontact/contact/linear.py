r"""The Newton step: (1 + g_0 K) Delta = f, in the symmetric form

    (1 + S g' S) y = S f,    Delta = f - g_0 S y,    S = [K / (1 + K g_00)]^1/2,

g_00 the compliance of an element under its own force, g' that between different ones. It is
positive definite, its diagonal is 1, and conjugate gradients need a few products.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import get_blas_funcs

from tyrecontact.contact.lattice import Compliance
from tyrecontact.contact.neighbours import convolved

#: a solve that is asked for no more may calculate in single precision
SINGLE = 1e-5
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
    unit = np.abs(imbalance).max()  # single precision knows no small numbers
    if not unit > 0:
        return imbalance.copy()
    scale = np.sqrt(stiffness / (1 + stiffness * compliance.self_compliance))
    kind = np.float32 if compliance.is_transformed_fast and accuracy >= SINGLE else float
    y = _conjugate_gradients(
        compliance, scale.astype(kind), (scale * imbalance / unit).astype(kind), accuracy
    )
    return imbalance - compliance.displacement(unit * scale * y)


def _conjugate_gradients(
    compliance: Compliance, scale: np.ndarray, right: np.ndarray, accuracy: float
) -> np.ndarray:
    """y of (1 + S g' S) y = S f, preconditioned by nearest neighbours (contact/neighbours.py).

    scipy's `cg` spends three times as long on its operators as the products take at 20 x 20.
    """
    add = get_blas_funcs("axpy", (right,))
    y, residual, direction = np.zeros_like(right), right.copy(), np.zeros_like(right)
    stencil, shape = compliance.products.neighbours.stencil(scale), compliance.shape
    goal, rho = accuracy**2 * (right @ right), 1.0
    for _ in range(right.size):
        if not residual @ residual > goal:
            break
        guess = residual
        if right.size > _FEW:
            near = convolved(stencil, (scale * residual).reshape(shape)).ravel()
            near *= scale
            guess = residual - near
        last, rho = rho, float(residual @ guess)
        direction *= rho / last
        direction += guess
        image = compliance.from_others(scale * direction)
        image *= scale
        image += direction
        share = rho / float(direction @ image)
        y = add(direction, y, a=share)
        residual = add(image, residual, a=-share)
    return y
