"""The force law of free and bonded elements, and the release of bonds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tyrecontact.contact.adhesion import ReleaseForce
from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.interface import Mirrored
from tyrecontact.errors import InputError
from tyrecontact.road.springs import Springs

COUNT = 64
FREE, BONDED = np.zeros(COUNT, bool), np.ones(COUNT, bool)
PRESSED = np.linspace(1e-6, 3e-5, COUNT)


@pytest.mark.parametrize("bonded", [FREE, BONDED])
def test_compressed_elements_follow_their_springs(
    rough_springs: Springs, bonded: np.ndarray
) -> None:
    interface = Mirrored(rough_springs, bonded)
    force, stiffness = interface.force_and_stiffness(PRESSED)
    np.testing.assert_allclose(force, rough_springs.force(PRESSED), rtol=1e-12)
    np.testing.assert_allclose(stiffness, rough_springs.stiffness(PRESSED), rtol=1e-12)
    np.testing.assert_allclose(interface.energy(PRESSED), rough_springs.energy(PRESSED))


def test_free_elements_carry_no_tension(rough_springs: Springs) -> None:
    interface = Mirrored(rough_springs, FREE)
    force, stiffness = interface.force_and_stiffness(-PRESSED)
    for value in (force, stiffness, interface.energy(-PRESSED)):
        np.testing.assert_array_equal(value, 0)


def test_bonded_elements_pull_as_they_push(rough_springs: Springs) -> None:
    interface = Mirrored(rough_springs, BONDED)
    push, push_stiffness = interface.force_and_stiffness(PRESSED)
    pull, pull_stiffness = interface.force_and_stiffness(-PRESSED)
    assert np.all(push > 0)
    np.testing.assert_array_equal(pull, -push)
    np.testing.assert_array_equal(pull_stiffness, push_stiffness)
    np.testing.assert_array_equal(interface.energy(-PRESSED), interface.energy(PRESSED))


def test_each_element_is_judged_by_its_own_bond(rough_springs: Springs) -> None:
    bonded = np.arange(COUNT) % 2 == 0
    force, _ = Mirrored(rough_springs, bonded).force_and_stiffness(-PRESSED)
    np.testing.assert_array_equal(force < 0, bonded)


def bonds_where(bonded: np.ndarray) -> Bonds:
    return replace(Bonds.none(np.zeros(bonded.size)), bonded=bonded)


def test_a_bond_breaks_above_its_release_force_alone(rough_springs: Springs) -> None:
    force = np.array([-0.61, -0.60, -0.59, 0.0, 5.0, -7.0])
    bonded = np.array([True, True, True, True, True, False])
    outcome = Outcome(force * 1e-6, force, 1e-5)
    broken = ReleaseForce(0.6).broken(rough_springs, bonds_where(bonded), outcome)
    np.testing.assert_array_equal(broken, [True, False, False, False, False, False])


def test_compression_bonds_and_a_bond_outlives_it(rough_springs: Springs) -> None:
    compression = np.array([1e-6, -1e-6, -1e-6, 0.0])
    bonds = bonds_where(np.array([False, False, True, False]))
    outcome = Outcome(compression, compression * 1e6, 1e-5)
    after = ReleaseForce(0.6).after(rough_springs, bonds, outcome)
    np.testing.assert_array_equal(after.bonded, [True, False, True, False])
    np.testing.assert_array_equal(bonds.bonded, [False, False, True, False])  # not in place


def test_without_a_release_force_nothing_ever_bonds(rough_springs: Springs) -> None:
    outcome = Outcome(PRESSED, rough_springs.force(PRESSED), 1e-5)
    assert not ReleaseForce(0.0).after(rough_springs, bonds_where(FREE), outcome).bonded.any()


@pytest.mark.parametrize("release_force", [-0.1, np.nan])
def test_an_impossible_release_force_is_refused(release_force: float) -> None:
    with pytest.raises(InputError, match="release_force must not be negative"):
        ReleaseForce(release_force)
