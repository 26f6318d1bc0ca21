"""All laws become the thesis' criterion in their limit, on linear springs of constant area."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tyrecontact.contact.adhesion import Hysteresis, Law, Multiplicative, ReleaseForce
from tyrecontact.contact.equilibrium import Bodies
from tyrecontact.contact.kinetics import BondKinetics, RecedingContact
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.road.springs import Springs, linear
from tyrecontact.tread.kernels import Kernel

COUNT, LIMIT, TIME_STEP = 16, 0.05, 1 / 51200
#: press in fine steps, pull in ones so coarse that a kinetic threshold falls between two
PATH = np.concatenate([np.linspace(0, 3e-5, 16), np.linspace(3e-5, -5e-5, 41)[1:]])
STIFFNESS = np.linspace(1e4, 4e4, COUNT)
AREA = 1e-8
#: a**2 k is the same for all, and so is the force of a receding contact
RADIUS = 1e-4 * np.sqrt(STIFFNESS[0] / STIFFNESS)


@pytest.fixture(scope="module")
def tops() -> np.ndarray:
    heights = np.random.default_rng(5).uniform(-1e-5, 0, COUNT)
    return heights - heights.max()


@pytest.fixture(scope="module")
def patch(tread: LatticeKernel) -> LatticeKernel:
    kernel = tread.kernel
    return LatticeKernel(Kernel(kernel.values[:, :4, :4], kernel.spacing, kernel.time_step))


def even() -> Springs:
    """All of one area."""
    return linear(STIFFNESS, 1e-4, np.sqrt(AREA / np.pi))


def multiplicative() -> Law:
    return Multiplicative(LIMIT, 0.0, 1e-7, 0.0, 1e-3, np.inf, 0.3)


def bonds() -> Law:
    """Sharp: the rate grows e times with 1/600 of the limit, at which it is 30 a step."""
    stress = LIMIT / 600 / AREA
    return BondKinetics(1e6, 30 / TIME_STEP * np.exp(-600.0), stress)


def receding() -> Law:
    """F = sqrt(4 pi a**2 k w) for k' = k / a, on a crack that nothing holds back."""
    work = LIMIT**2 / (4 * np.pi * RADIUS[0] ** 2 * STIFFNESS[0])
    return RecedingContact(work, 0.0, 1e-3, 1e6, 0.55)


@pytest.fixture(scope="module")
def thesis(patch: LatticeKernel, tops: np.ndarray, follow: Callable[..., Any]) -> Any:
    return follow(Bodies(patch, even(), ReleaseForce(LIMIT), tops), PATH)


@pytest.mark.parametrize(
    ("law", "springs"),
    [
        (multiplicative(), even()),
        (Hysteresis(LIMIT), even()),
        (bonds(), even()),
        (receding(), linear(STIFFNESS, 1e-4, RADIUS)),
    ],
    ids=["multiplicative", "hysteresis", "bonds", "receding contact"],
)
def test_the_limit_is_the_criterion_of_the_thesis(
    law: Law, springs: Springs, patch: LatticeKernel, tops: np.ndarray, thesis: Any,
    follow: Callable[..., Any],
) -> None:  # fmt: skip
    found = follow(Bodies(patch, springs, law, tops), PATH)
    np.testing.assert_array_equal(found.releases, thesis.releases)
    # what was asked for; bonds and lines are summed in another order
    largest = np.abs(thesis.total).max()
    np.testing.assert_allclose(found.total, thesis.total, rtol=1e-9, atol=1e-9 * largest)


def test_the_runs_compared_are_telling(thesis: Any) -> None:
    """Every bond breaks, in many steps, and none was within 2.5 % of its limit and stayed."""
    assert thesis.releases.sum() == COUNT
    assert np.sum(thesis.releases > 0) > 4
    assert thesis.total.min() < -2 * LIMIT
    assert not np.any(np.abs(thesis.force / -LIMIT - 1) < 0.025)


@pytest.mark.parametrize("excess", [-1e-6, 1e-6])
def test_a_punch_on_a_half_space_lets_go_at_griffiths_force(
    excess: float, stiff_layer: Callable[[int], LatticeKernel], follow: Callable[..., Any]
) -> None:
    """F = sqrt(8 pi E* w a**3) for k = 2 E* a (Maugis, 2000, section 4.2)."""
    modulus, radius, work = 4e6, 2e-4, 0.07
    springs = linear(np.full(2, 2 * modulus * radius), 1e-4, radius)
    law = RecedingContact(work, 0.0, 1e-3, 1e6, 0.55)
    force = np.sqrt(8 * np.pi * modulus * work * radius**3)
    pulled = force * (1 + excess) / (2 * modulus * radius)
    bodies = Bodies(stiff_layer(2), springs, law, np.zeros(2))
    run = follow(bodies, [1e-6, 0, -pulled])
    assert run.releases[-1] == (2 if excess > 0 else 0)
