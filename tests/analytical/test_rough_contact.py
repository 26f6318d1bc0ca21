"""A rough patch on a thick tread at rest, against ContactMechanics' elastic half-space."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from scipy import special

from tyrecontact.contact import newton
from tyrecontact.contact.interface import Mirrored
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.road import textures
from tyrecontact.road.springs import linear
from tyrecontact.tread.kernels import static
from tyrecontact.tread.materials import Layer, NearlyConstantLoss

MODULUS, POISSON, SIZE, COUNT = 25e6, 0.45, 2e-3, 32
PLANE = MODULUS / (1 - POISSON**2)
THICKNESS = 0.75 * SIZE


@pytest.fixture(scope="module")
def tops() -> np.ndarray:
    """Heights [m] below the highest, (COUNT, COUNT); wavelengths from 4 elements up."""
    road = textures.self_affine(
        SIZE, SIZE / COUNT, 3e-6, roll_off_wavelength=1.5e-3, cut_off_wavelength=0.5e-3, seed=2
    )
    return road.heights - road.heights.max()


def pressed(tops: np.ndarray, indentation: float) -> np.ndarray:
    """Element forces [N] on the layer, springs 300 times stiffer than it under an element."""
    side = SIZE / COUNT
    layer = Layer(THICKNESS, 1300.0, NearlyConstantLoss(MODULUS, 0.0), POISSON)
    kernel = LatticeKernel(static([layer], (COUNT, COUNT), side))
    springs = linear(np.full(COUNT**2, 300 * PLANE * side), 1e-3, side / 2)
    target = indentation + tops.ravel()
    solution = newton.robust(
        kernel.now,
        Mirrored(springs, np.zeros(COUNT**2, bool)),
        target,
        np.minimum(target, 0.0),
        1e-6 * indentation,
        200,
    )
    assert solution.converged
    return solution.force.reshape(COUNT, COUNT)


def stiffening(force: np.ndarray) -> np.ndarray:
    """How much less the layer gives than a half-space [m], (COUNT, COUNT), by its base alone.

    (1 / pi E* h) int_0^inf (1 - L(u)) J0(u r / h) du, smooth in r, for each element's force.
    """
    u, du = (np.polynomial.legendre.leggauss(80)[i] * 12.0 for i in (0, 1))
    u, k0 = u + 12.0, 3 - 4 * POISSON
    decay = np.exp(-2 * u)
    rest = (4 * u**2 + 4 * u + 1 + k0**2) * decay + 2 * k0 * decay**2
    deficit = rest / (k0 * (1 + decay**2) + (4 * u**2 + 1 + k0**2) * decay)  # 1 - L
    offset = np.arange(COUNT) * SIZE / COUNT / THICKNESS
    distance = np.hypot(offset[:, None], offset)
    table = special.j0(distance[..., None] * u) @ (deficit * du) / (np.pi * PLANE * THICKNESS)
    row, column = (index.ravel() for index in np.indices((COUNT, COUNT)))
    matrix = table[abs(row[:, None] - row), abs(column[:, None] - column)]
    return (matrix @ force.ravel()).reshape(COUNT, COUNT)


def by_contact_mechanics(tops: np.ndarray) -> np.ndarray:
    """Element forces [N] of a rigid road on a half-space that would be at height 0 [m]."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it looks for mpi4py
        from ContactMechanics import FreeFFTElasticHalfSpace, make_system
        from SurfaceTopography import Topography

        substrate = FreeFFTElasticHalfSpace(tops.shape, PLANE, (SIZE, SIZE))
        surface = Topography(tops, (SIZE, SIZE))
        system = make_system(interaction="hardwall", surface=surface, substrate=substrate)
        found = system.minimize_proxy(offset=0.0, pentol=1e-10, maxiter=2000)
    assert found.success
    return np.abs(np.asarray(substrate.force))[: tops.shape[0], : tops.shape[1]]


@pytest.mark.parametrize("indentation", [4e-6, 8e-6])
def test_a_rough_patch_is_that_of_contact_mechanics(tops: np.ndarray, indentation: float) -> None:
    """Force against displacement, and which elements touch."""
    force = pressed(tops, indentation)
    expected = by_contact_mechanics(tops + indentation + stiffening(force))
    # the displacement is taken in an element's middle there, as its mean here, which is a sixth
    # less for its own force; shared among the elements that touch together, 1-2 % of the force
    assert force.sum() == pytest.approx(expected.sum(), rel=0.025)
    touching, others = force > 0, expected > 0
    assert np.mean(touching != others) < 0.02  # and a few at the rims of the spots
    assert np.corrcoef(force.ravel(), expected.ravel())[0, 1] > 0.997
