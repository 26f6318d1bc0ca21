"""What elements remember: ages run while they touch, the largest compression while held."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tyrecontact.contact.bonds import Bonds, Outcome

#: pressed for the first time, bonded and pulled, bonded and pressed, apart, dented but free
COMPRESSION = np.array([2e-6, -1e-6, 1e-6, -3e-6, 1e-6])
FORCE = np.array([1.0, -0.5, 0.5, 0.0, 0.0])
BONDED = np.array([False, True, True, False, False])
BEFORE = Bonds(
    BONDED,
    age=np.array([0.0, 3.0, 3.0, 0.0, 0.0]),
    reach=np.array([0.0, 5e-6, 5e-6, 0.0, 5e-6]),
    fraction=np.array([0.0, 0.4, 0.6, 0.0, 0.0]),
    compression=np.array([-1e-6, 1e-6, 3e-6, -2e-6, 2e-6]),
)
OUTCOME = Outcome(COMPRESSION, FORCE, 0.5)


def test_a_step_ages_what_touches_and_forgets_what_is_apart() -> None:
    after = BEFORE.after(OUTCOME, BONDED | (COMPRESSION > 0) & (FORCE > 0))
    np.testing.assert_array_equal(after.bonded, [True, True, True, False, False])
    np.testing.assert_array_equal(after.age, [0.5, 3.5, 3.5, 0.0, 0.0])
    np.testing.assert_array_equal(after.reach, [2e-6, 5e-6, 5e-6, 0.0, 5e-6])
    np.testing.assert_array_equal(after.fraction, [0.0, 0.4, 0.6, 0.0, 0.0])
    assert after.compression is COMPRESSION


def test_an_unbonded_contact_ages_too() -> None:
    after = BEFORE.after(OUTCOME, np.zeros(5, bool))
    np.testing.assert_array_equal(after.age, [0.5, 0.0, 3.5, 0.0, 0.0])
    np.testing.assert_array_equal(after.fraction, 0)


def test_a_broken_bond_takes_age_and_fraction_but_leaves_the_dent() -> None:
    broken = np.array([False, True, False, False, False])
    left = BEFORE.without(broken)
    np.testing.assert_array_equal(left.bonded, [False, False, True, False, False])
    np.testing.assert_array_equal(left.age, [0, 0, 3, 0, 0])
    np.testing.assert_array_equal(left.fraction, [0, 0, 0.6, 0, 0])
    np.testing.assert_array_equal(left.reach, BEFORE.reach)
    np.testing.assert_array_equal(BEFORE.bonded, BONDED)  # not in place


def test_a_lesser_compression_does_not_lower_the_reach() -> None:
    once = replace(BEFORE, reach=np.full(5, 4e-6))
    after = once.after(OUTCOME, np.ones(5, bool))
    np.testing.assert_array_equal(after.reach, 4e-6)


def test_nothing_touches_at_first() -> None:
    none = Bonds.none(-np.arange(3) * 1e-6)
    assert not none.bonded.any()
    for memory in (none.age, none.reach, none.fraction):
        np.testing.assert_array_equal(memory, 0)
