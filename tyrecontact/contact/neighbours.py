r"""A preconditioner from nearest neighbours for (1 + S g' S) y = S f (contact/linear.py).

Were S the same number s for all elements, the inverse would be 1 - S h S, where h has the waves
lambda' / (1 + s^2 lambda') of g'. Rubber that has had one time step to give way hardly knows of
more than its neighbours, and so it is with the inverse, even at rest. Hence h is cut to an element
and the eight around it, and s^2 taken as the mean over the contacts: conjugate gradients then take
about half as many products. It is positive definite: h is scaled where its waves could exceed
1 / s^2.
"""

from __future__ import annotations

import numpy as np

from tyrecontact.contact.transforms import near_values

#: mean values of s^2 g_00, which lies between 0 and 1, that are told apart
_LEVELS = 64
#: the largest s^2 times the largest wave of h stays below that
_LARGEST = 0.95
#: 1 + s^2 lambda' is no less in a tread that yields to every force
_LEAST = 0.01


class Neighbours:
    """h for every S.

    Parameters
    ----------
    waves : lambda' of g' [m/N], shape (ny + 1, nx + 1), of `kernel_waves`.
    own : g_00 [m/N].

    Attributes
    ----------
    stencils : h [m/N] by level of s^2 g_00: of the element itself, those beside it along the patch
        and across, those at its corners, and what S^2 must not exceed, inverted; shape (levels, 5).
    """

    def __init__(self, waves: np.ndarray, own: float) -> None:
        self._own = own
        square = (np.arange(_LEVELS) + 0.5)[:, None, None] / (_LEVELS * own)
        near = near_values(waves / np.maximum(1 + square * waves, _LEAST))
        centre, along, across, corner = near[:, 0, 0], near[:, 0, 1], near[:, 1, 0], near[:, 1, 1]
        # cosines being between -1 and 1, and the sum linear in either
        ends = [
            centre + 2 * (a * along + b * across) + 4 * a * b * corner
            for a, b in ((1, 1), (1, -1), (-1, 1), (-1, -1))
        ]
        largest = np.max(ends, axis=0) / _LARGEST
        self.stencils = np.stack([centre, along, across, corner, largest], axis=1)

    def stencil(self, scale: np.ndarray) -> np.ndarray:
        """h for S [(N/m)^1/2], shape (elements,): the first four numbers of `stencils` [m/N]."""
        square = scale * scale
        mean = square.sum() / max(np.count_nonzero(square), 1)
        level = min(int(mean * self._own * _LEVELS), _LEVELS - 1)
        stencil = self.stencils[level]
        excess = stencil[4] * square.max()
        return (stencil[:4] / max(excess, 1.0)).astype(scale.dtype)


def convolved(stencil: np.ndarray, field: np.ndarray) -> np.ndarray:
    """h * field, shape (ny, nx), zero beyond the patch."""
    padded = np.zeros((field.shape[0] + 2, field.shape[1] + 2), field.dtype)
    padded[1:-1, 1:-1] = field
    beside = padded[:, :-2] + padded[:, 2:]
    result: np.ndarray = stencil[0] * field
    result += stencil[1] * beside[1:-1]
    result += stencil[2] * (padded[:-2, 1:-1] + padded[2:, 1:-1])
    result += stencil[3] * (beside[:-2] + beside[2:])
    return result
