r"""The largest eigenvalue of A = -K^1/2 P K^1/2 followed from step to step, P the kernel's power.

    x -> K_new^1/2 K_old^-1/2 x

is a good guess of an eigenvector after the springs have changed a little. A is put into the space
of the three leading ones, of a random wave, and of what they lack (A x - lambda x), divided by the
diagonal of lambda - A (Davidson's method): springs that are stiff and draw nothing would otherwise
need many products.

The second and third vector are there for modes that overtake the one that led so far, and so is
the random wave: it lies where springs have stiffened, and adds up over the steps.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tyrecontact.contact.lattice import Compliance

#: vectors that are followed
_KEPT = 3
#: half-waves a side, from none on, that a random wave is made of
_WAVES = 4
_MOST_ROUNDS = 8
#: error of the eigenvalue, and length of the residual, that are accepted, per 1 + lambda
_ACCURACY, _RESIDUAL = 5e-4, 3e-2
#: added to the diagonal of lambda - A, which must not be nil
_SHIFT = 0.02


@dataclass(frozen=True)
class Followed:
    """Leading eigenvectors, found for a K.

    Attributes
    ----------
    power : P.  root : K^1/2, shape (elements,).
    vectors : x, shape (vectors, elements), orthonormal.
    value : the largest eigenvalue [-].
    """

    power: Compliance
    root: np.ndarray
    vectors: np.ndarray
    value: float

    def on(self, root: np.ndarray, random: np.random.Generator) -> Followed | None:
        """The same of another K^1/2; None where it is not found to the accuracy asked for."""
        scale = np.divide(root, self.root, out=np.zeros_like(root), where=self.root > 0)
        # a mode that overtakes does so where springs have stiffened
        grown = np.maximum(root - self.root, 0.0)
        wave = (grown if grown.any() else root) * random_wave(self.power.shape, random)
        basis = _orthonormal(np.vstack([self.vectors * scale, wave]))
        images = self._images(root, basis)
        for round_ in range(_MOST_ROUNDS):
            values, mix = np.linalg.eigh(basis @ images.T)
            values, mix = values[::-1], mix.T[::-1][:_KEPT]  # largest first
            vectors = mix @ basis
            lacking = mix @ images - values[: len(mix), None] * vectors
            diagonal = max(values[0], 0.0) + _SHIFT + root**2 * abs(self.power.self_compliance)
            wanted = _wanted(values, lacking)
            wanted[1:] |= round_ == 0  # the first round looks after the others, too
            if not wanted.any():
                return Followed(self.power, root, vectors, float(values[0]))
            directions = (lacking / diagonal)[wanted]
            more = _orthonormal(directions, basis)
            basis, images = np.vstack([basis, more]), np.vstack([images, self._images(root, more)])
        return None

    def _images(self, root: np.ndarray, vectors: np.ndarray) -> np.ndarray:
        return np.array([-root * self.power.displacement(root * x) for x in vectors])


def _wanted(values: np.ndarray, lacking: np.ndarray) -> np.ndarray:
    """Which Ritz vectors, the leading one first, have still to be made better.

    The first, until its value is as close to an eigenvalue as is asked for; others as long as
    they may turn out to be above it.
    """
    scale = 1 + max(float(values[0]), 0.0)
    length = np.linalg.norm(lacking, axis=1)
    gap = -np.diff(values, append=values[-1])[: length.size]  # to what is below
    error = length * np.minimum(1.0, length / np.maximum(gap, 1e-300))
    wanted = values[: length.size] + error > values[0] + _ACCURACY * scale
    wanted[0] = error[0] > _ACCURACY * scale or length[0] > _RESIDUAL * scale
    return wanted


def _orthonormal(rows: np.ndarray, basis: np.ndarray | None = None) -> np.ndarray:
    """Rows made orthonormal to each other and to those of a basis."""
    if basis is None:
        return np.linalg.qr(rows.T)[0].T
    for _ in range(2):  # the second time for rows that were all but in the basis
        rows = np.linalg.qr((rows - (rows @ basis.T) @ basis).T)[0].T
    return rows


def random_wave(shape: tuple[int, int], random: np.random.Generator) -> np.ndarray:
    """A random sum of products of cosines on a lattice (ny, nx), shape (ny nx,)."""
    rows, columns = _cosines(shape[0]), _cosines(shape[1])
    mix = random.standard_normal((rows.shape[1], columns.shape[1]))
    return (rows @ mix @ columns.T).ravel()


@lru_cache(maxsize=4)
def _cosines(count: int) -> np.ndarray:
    """Cosines of 0, 1, .. half-waves on a row of elements, shape (elements, waves)."""
    phase = np.outer(np.arange(count) + 0.5, np.arange(min(count, _WAVES)))
    return np.cos(np.pi * phase / count)
