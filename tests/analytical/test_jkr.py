"""A receding contact whose area grows like a sphere's is that of Johnson, Kendall and Roberts.

With a = sqrt(R c) and k = 2 E* a the contact at compression d has

    F = 4 E* a^3 / (3 R) - sqrt(8 pi E* w a^3),    d = a^2 / R - sqrt(2 pi w a / E*)
"""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
import pytest

from tyrecontact.contact.equilibrium import Bodies, Solver, State, advance
from tyrecontact.contact.kinetics import RecedingContact
from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.machine import Machine, Moment
from tyrecontact.contact.newton import robust
from tyrecontact.road.spring_tables import Springs, graded, tabulated
from tyrecontact.tread.kernels import Kernel

RADIUS, MODULUS, WORK = 1e-3, 4e6, 0.07
DEPTH = 40e-6
LIFT = 1.5 * np.pi * WORK * RADIUS
#: radius of a fixed grip's last contact: dd/da = 0
LAST = (np.pi * WORK * RADIUS**2 / (8 * MODULUS)) ** (1 / 3)


def force(a: np.ndarray) -> np.ndarray:
    return 4 * MODULUS * a**3 / (3 * RADIUS) - np.sqrt(8 * np.pi * MODULUS * WORK * a**3)


def depth(a: np.ndarray) -> np.ndarray:
    return a**2 / RADIUS - np.sqrt(2 * np.pi * WORK * a / MODULUS)


@pytest.fixture(scope="module")
def bodies() -> Bodies:
    """Two spheres, an element each, on a layer that does not give."""
    radius = np.sqrt(RADIUS * graded(DEPTH))
    stiffness = np.tile(2 * MODULUS * radius, (2, 1))
    slope = np.full_like(radius, 2 * MODULUS)
    contact = np.tile(np.stack([radius, 2 * MODULUS * radius, slope], axis=-1), (2, 1, 1))
    springs: Springs = tabulated(DEPTH, stiffness, contact, tangent=True)
    rigid = LatticeKernel(Kernel(np.full((1, 1, 2), 1e-15), 1e-3, np.inf))
    law = RecedingContact(WORK, 0.0, 1e-3, 1e6, 0.55)
    return Bodies(rigid, springs, law, np.zeros(2))


def follow(bodies: Bodies, drives: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Compression [m] and force [N] of a sphere at each drive until it is free."""
    solver = Solver(robust, 1e-14, 100, extrapolates=False)
    state, found = State.at_rest(bodies), []
    for drive in drives:
        step = advance(bodies, solver, state, Moment(drive, 1e-3))
        assert step.solution.converged
        if step.releases:
            break
        found.append([step.solution.compression[0], step.solution.force[0]])
    compression, force = np.array(found).T
    return compression, force


@pytest.fixture(scope="module")
def gripped(bodies: Bodies) -> tuple[np.ndarray, np.ndarray]:
    """Pulled off at fixed grips; every place twice, so that the crack has come to rest."""
    coming = np.linspace(0, 10e-6, 5)
    going = np.concatenate([np.linspace(8e-6, -9e-7, 90), np.arange(-9e-7, -1.2e-6, -1e-9)[1:]])
    compression, force = follow(bodies, np.repeat(np.concatenate([coming, going]), 2))
    return compression[11::2], force[11::2]


def test_fixed_grips_follow_the_equilibrium(gripped: tuple[np.ndarray, np.ndarray]) -> None:
    compression, found = gripped
    a = np.geomspace(LAST, 1e-3, 20000)
    receding = compression < 10e-6 - 6e-6  # from where G = w at the largest area on
    expected = np.interp(compression, depth(a), force(a))
    # the table of 256 cells: between them F is of the fourth degree, a of the first
    np.testing.assert_allclose(found[receding], expected[receding], atol=2e-3 * LIFT)
    assert receding.sum() > 200


def test_fixed_grips_bear_three_halves_on_the_way_and_end_at_five_sixths(
    gripped: tuple[np.ndarray, np.ndarray],
) -> None:
    compression, found = gripped
    assert -found.min() == pytest.approx(LIFT, rel=2e-3)  # as above
    # the radius falls like a square root there, and a step is 1e-3 of the way: a few per cent
    assert -found[-1] == pytest.approx(5 / 9 * LIFT, rel=0.05)
    assert compression[-1] == pytest.approx(float(depth(np.array(LAST))), rel=0.01)


def test_a_fixed_load_lets_go_at_three_halves(bodies: Bodies) -> None:
    """A spring of a hundredth of the contacts' stiffness pulls with nearly the same force."""
    stiffness = 8.0
    soft = replace(bodies, machine=Machine(stiffness))
    total = LIFT * np.concatenate([[0, 1, 2, 1, 0, -1, -1.5], np.arange(-1.6, -2.2, -0.01)])
    _, found = follow(soft, np.repeat(total / stiffness, 8))
    # it creeps along the last steps, where the crack is at rest after many steps only
    assert -found[-1] == pytest.approx(LIFT, rel=0.02)
    assert -found.min() == pytest.approx(LIFT, rel=0.02)


def test_the_closed_form_is_that_of_the_library_adhesion() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it looks for mpi4py
        from Adhesion.ReferenceSolutions import JKR as jkr  # noqa: N811 - as its authors do

    a = np.geomspace(LAST, 1e-3, 7)
    # rounding
    np.testing.assert_allclose(force(a), jkr.force(a, None, RADIUS, MODULUS, WORK), rtol=1e-12)
    found = jkr.penetration(a, None, RADIUS, MODULUS, WORK)
    np.testing.assert_allclose(depth(a), found, rtol=1e-12)
