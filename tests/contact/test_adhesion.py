"""The force law of free and bonded elements, and the release of bonds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tyrecontact.contact.adhesion import (
    Hysteresis,
    Multiplicative,
    ReleaseForce,
    constant_limit,
    table_limits,
)
from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.interface import Hinged, Mirrored
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
    force, stiffness = interface.respond(PRESSED)[:2]
    np.testing.assert_allclose(force, rough_springs.force(PRESSED), rtol=1e-12)
    np.testing.assert_allclose(stiffness, rough_springs.stiffness(PRESSED), rtol=1e-12)
    np.testing.assert_allclose(interface.respond(PRESSED).energy, rough_springs.energy(PRESSED))


def test_free_elements_carry_no_tension(rough_springs: Springs) -> None:
    interface = Mirrored(rough_springs, FREE)
    force, stiffness = interface.respond(-PRESSED)[:2]
    for value in (force, stiffness, interface.respond(-PRESSED).energy):
        np.testing.assert_array_equal(value, 0)


def test_bonded_elements_pull_as_they_push(rough_springs: Springs) -> None:
    interface = Mirrored(rough_springs, BONDED)
    push, push_stiffness = interface.respond(PRESSED)[:2]
    pull, pull_stiffness = interface.respond(-PRESSED)[:2]
    assert np.all(push > 0)
    np.testing.assert_array_equal(pull, -push)
    np.testing.assert_array_equal(pull_stiffness, push_stiffness)
    np.testing.assert_array_equal(
        interface.respond(-PRESSED).energy, interface.respond(PRESSED).energy
    )


def test_each_element_is_judged_by_its_own_bond(rough_springs: Springs) -> None:
    bonded = np.arange(COUNT) % 2 == 0
    force = Mirrored(rough_springs, bonded).respond(-PRESSED).force
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


def test_a_contact_that_was_hardly_pressed_is_not_drawn_out_without_end(
    rough_springs: Springs,
) -> None:
    """Its line is flat: it lets go where the mirrored spring would, at the latest."""
    law = Hysteresis(0.05)
    bonds = replace(bonds_where(BONDED), reach=np.full(COUNT, 1e-8))
    opening = np.full(COUNT, 1e-6)
    for _ in range(60):  # to where the mirrored spring bears 0.05 N
        opening = np.where(rough_springs.force(opening) < 0.05, opening * 1.1, opening)
    force = law.interface(rough_springs, bonds).respond(-opening).force
    assert np.all((force < 0) & (force > -0.05))
    assert law.broken(rough_springs, bonds, Outcome(-opening, force, 1e-5)).all()
    force = law.interface(rough_springs, bonds).respond(-0.8 * opening).force
    assert not law.broken(rough_springs, bonds, Outcome(-0.8 * opening, force, 1e-5)).any()


def test_hysteresis_breaks_above_its_release_force(rough_springs: Springs) -> None:
    law, bonds = Hysteresis(0.05), replace(bonds_where(BONDED), reach=np.full(COUNT, 2e-5))
    deep = Hinged(rough_springs, BONDED, bonds.reach)
    stiffness = rough_springs.punch_stiffness(bonds.reach)
    zero = bonds.reach - rough_springs.force(bonds.reach) / stiffness
    for share, breaks in ((0.99, False), (1.01, True)):
        place = zero - share * 0.05 / stiffness
        force = deep.respond(place).force
        found = law.broken(rough_springs, bonds, Outcome(place, force, 1e-5))
        np.testing.assert_array_equal(found, breaks)


def test_the_multiplicative_force_is_the_product_of_its_factors(rough_springs: Springs) -> None:
    law = Multiplicative(0.6, 0.5, 2e-8, 0.1, 1e-3, 4e-4, 0.3)
    bonds = replace(
        bonds_where(BONDED), reach=PRESSED, age=np.full(COUNT, 0.02), compression=-PRESSED
    )
    outcome = Outcome(-2 * PRESSED, -PRESSED, 0.01)
    area = np.pi * rough_springs.radius(PRESSED) ** 2
    rate = PRESSED / 0.01
    expected = 0.6 * (area / 2e-8) ** 0.5 * (1 + 0.1 * np.log(21)) * (1 + (rate / 4e-4) ** 0.3)
    np.testing.assert_allclose(law.limit(rough_springs, bonds, outcome), expected, rtol=1e-12)
    timeless = replace(law, reference_rate=np.inf, ageing=0.0, area_exponent=0.0)
    np.testing.assert_array_equal(timeless.limit(rough_springs, bonds, outcome), 0.6)
    barely = replace(outcome, force=-expected * (1 - 1e-9))
    assert not law.broken(rough_springs, bonds, barely).any()
    assert law.broken(rough_springs, bonds, replace(outcome, force=-expected * (1 + 1e-9))).all()


@pytest.mark.parametrize("step", [1e-7, 1e-6, 3e-6])
def test_the_table_of_the_thesis_lets_go_one_entry_early(
    rough_springs: Springs, step: float
) -> None:
    """At the last entry below the release force; the next is not below it."""
    limits = table_limits(rough_springs, 0.05, step)
    assert np.all(limits < 0.05)
    entries = np.arange(0, 2e-5, step)[:, None]
    table = rough_springs.force(np.repeat(entries, COUNT, axis=1))
    last = np.where(table < 0.05, table, 0.0).max(axis=0)
    np.testing.assert_allclose(limits, last, rtol=1e-9)  # rounding of the places


def test_finer_tables_tend_to_the_release_force(rough_springs: Springs) -> None:
    lowest = [table_limits(rough_springs, 0.05, step).min() for step in (1e-6, 1e-7, 1e-9)]
    assert lowest == sorted(lowest)
    assert lowest[-1] == pytest.approx(0.05, rel=1e-3)


def test_an_entry_of_the_table_without_force_bonds_nothing(rough_springs: Springs) -> None:
    limits = table_limits(rough_springs, 0.05, 1e-4)  # the release force lies in the first cell
    np.testing.assert_array_equal(limits, 0)
    outcome = Outcome(PRESSED, rough_springs.force(PRESSED), 1e-5)
    after = ReleaseForce(limits).after(rough_springs, bonds_where(FREE), outcome)
    assert not after.bonded.any()


def test_a_bond_that_nothing_changes_has_a_constant_limit() -> None:
    assert constant_limit(ReleaseForce(0.3), 7) == 0.3
    assert constant_limit(ReleaseForce(np.array([0.1, 0.2])), 1) == 0.2
    assert constant_limit(Hysteresis(0.4), 0) == 0.4
    growing = Multiplicative(0.3, 1.0, 1e-7, 0.1, 1e-3, np.inf, 1.0)
    assert constant_limit(growing, 0) is None
