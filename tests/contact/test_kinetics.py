"""Bonds that form and break in time, and cracks that run: lifetimes, rates, speeds, limits."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import exp1

from tyrecontact.contact.adhesion import Hysteresis, Law
from tyrecontact.contact.bonds import Bonds, Outcome
from tyrecontact.contact.kinetics import BondKinetics, RecedingContact
from tyrecontact.errors import InputError
from tyrecontact.road.springs import Springs, linear

RADIUS, STIFFNESS = 1e-4, 1e5
AREA = np.pi * RADIUS**2
PUNCHES = linear(np.full(3, STIFFNESS), 1e-4, RADIUS)


def bonded(fraction: float = 1.0, age: float = 0.0, count: int = 3) -> Bonds:
    none = Bonds.none(np.full(count, -1e-6))
    return replace(
        none,
        bonded=np.ones(count, bool),
        fraction=np.full(count, fraction),
        age=np.full(count, age),
        reach=np.full(count, 1e-6),
    )


def pulled(tension: float, time_step: float) -> Outcome:
    force = np.full(3, -tension)
    return Outcome(force / STIFFNESS, force, time_step)


@pytest.mark.parametrize("pull", [0.5, 2.0, 8.0])
def test_a_bond_under_a_constant_pull_lives_as_long_as_bell_has_it(pull: float) -> None:
    """db/dt = -k b e^(x / b) with x = T / (A sigma) ends at t = E_1(x) / k."""
    rate, stress = 3.0, 1e5
    law, lifetime = BondKinetics(5.0, rate, stress), float(exp1(pull)) / rate
    outcome, bonds, time = pulled(pull * AREA * stress, lifetime / 2000), bonded(), 0.0
    while not law.broken(PUNCHES, bonds, outcome).any():
        bonds, time = law.after(PUNCHES, bonds, outcome), time + outcome.time_step
        assert time < 2 * lifetime
    # the exponent is that of the start of each step, which is late by about a step per e-folding
    assert time == pytest.approx(lifetime, rel=0.02)


@pytest.mark.parametrize("steps", [1, 3, 30])
def test_bonds_break_as_fast_in_one_long_step_as_in_many(steps: int) -> None:
    """E_1(x / b) = E_1(x) - k t, at three quarters of the lifetime."""
    rate, stress, pull = 3.0, 1e5, 2.0
    law, time = BondKinetics(5.0, rate, stress), 0.75 * float(exp1(pull)) / rate
    outcome, bonds = pulled(pull * AREA * stress, time / steps), bonded()
    for _ in range(steps):
        assert not law.broken(PUNCHES, bonds, outcome).any()
        bonds = law.after(PUNCHES, bonds, outcome)
    left = float(exp1(pull)) - rate * time
    # where less than 1 % break in a step its rate is taken as constant
    np.testing.assert_allclose(exp1(pull / bonds.fraction), left, rtol=0.02)


@pytest.mark.parametrize("steps", [1, 7, 100])
def test_bonds_in_compression_form_as_fast_in_one_step_as_in_many(steps: int) -> None:
    law = BondKinetics(10.0, 0.5, 1e5)
    outcome, bonds = Outcome(np.full(3, 1e-6), np.full(3, 0.1), 0.3 / steps), bonded(0.2)
    for _ in range(steps):
        bonds = law.after(PUNCHES, bonds, outcome)
    settled = 10 / 10.5
    expected = settled + (0.2 - settled) * np.exp(-10.5 * 0.3)
    np.testing.assert_allclose(bonds.fraction, expected, rtol=1e-12)  # the exact solution
    np.testing.assert_allclose(bonds.age, 0.3, rtol=1e-12)


def test_bonds_that_never_break_unloaded_hold_for_ever() -> None:
    law = BondKinetics(1.0, 0.0, 1e5)
    assert not law.broken(PUNCHES, bonded(), pulled(5.0, 1e6)).any()


def test_an_endless_pull_overflows_nothing() -> None:
    law = BondKinetics(1.0, 1e6, 1.0)
    assert law.broken(PUNCHES, bonded(1e-3), pulled(100.0, 1e3)).all()


@pytest.mark.parametrize(
    "law",
    [BondKinetics(0.0, 1.0, 1e5), RecedingContact(0.0, 0.1, 1e-3, 1e-7, 0.5), Hysteresis(0.0)],
    ids=["bonds", "receding contact", "hysteresis"],
)
def test_without_adhesion_nothing_bonds(law: Law, rough_springs: Springs) -> None:
    depth = np.linspace(1e-6, 2e-5, 64)
    bonds = Bonds.none(np.zeros(64))
    bonds = law.after(rough_springs, bonds, Outcome(depth, rough_springs.force(depth), 1e-5))
    assert not bonds.bonded.any()
    for place in (0.5 * depth, -depth):
        force = law.interface(rough_springs, bonds).respond(place).force
        assert np.all(force >= 0)
        assert not law.broken(rough_springs, bonds, Outcome(place, force, 1e-5)).any()


def test_receding_without_adhesion_is_the_spring_itself(rough_springs: Springs) -> None:
    law, depth = RecedingContact(0.0, 0.0, 1e-3, np.inf, 0.5), np.linspace(1e-6, 2e-5, 64)
    bonds = replace(Bonds.none(depth), reach=depth)
    force = law.interface(rough_springs, bonds).respond(depth / 2).force
    # two ways to take a derivative of a polynomial
    np.testing.assert_allclose(force, rough_springs.force(depth / 2), rtol=1e-14)


def crack(speed: float, exponent: float = 0.5) -> RecedingContact:
    return RecedingContact(0.05, 0.0, 1e-3, speed, exponent)


def cracked(
    springs: Springs, reach: float, depth: float, age: float = 1.0
) -> tuple[Bonds, Outcome]:
    count = springs.count
    bonds = replace(bonded(age=age, count=count), reach=springs.onset(np.full(count, reach)))
    compression = np.full(count, depth)
    force = crack(1.0).interface(springs, bonds).respond(compression).force
    return bonds, Outcome(compression, force, 1e-5)


def release_rate(springs: Springs, reach: np.ndarray, depth: float) -> np.ndarray:
    slope = springs.punch_stiffness_slope(reach)
    return slope * (depth - reach) ** 2 / (4 * np.pi * springs.radius(reach))


def test_a_slow_crack_runs_at_gent_and_schultz_speed(rough_springs: Springs) -> None:
    """-da/dt = v* (G / w - 1)^(1/n) over a step in which G hardly changes."""
    depth = 2e-5 - 3e-7
    bonds, outcome = cracked(rough_springs, 2e-5, depth)
    driven = release_rate(rough_springs, bonds.reach, depth) / 0.05
    assert 1.2 < np.median(driven) < 20
    after = crack(1e-6).after(rough_springs, bonds, outcome)
    shrunk = rough_springs.radius(bonds.reach) - rough_springs.radius(after.reach)
    excess = np.where(depth < bonds.reach, np.maximum(driven - 1, 0), 0)
    expected = 1e-6 * excess**2 * 1e-5
    # radii are found to the 40th halving of 2e-5 m
    np.testing.assert_allclose(shrunk, expected, rtol=1e-3, atol=1e-14)


def test_a_contact_that_is_not_driven_stays(rough_springs: Springs) -> None:
    bonds, outcome = cracked(rough_springs, 2e-5, 1.99e-5)
    pulled_back = bonds.reach > 1.99e-5  # the others are pressed on at constant area
    assert pulled_back.sum() > 40
    assert release_rate(rough_springs, bonds.reach, 1.99e-5)[pulled_back].max() < 0.05
    after = crack(1e6).after(rough_springs, bonds, outcome)
    np.testing.assert_array_equal(after.reach, bonds.reach)


@pytest.mark.parametrize("speed", [1e6, np.inf])
def test_a_fast_crack_comes_to_rest_where_g_is_w_or_the_contact_breaks(
    rough_springs: Springs, speed: float
) -> None:
    bonds, outcome = cracked(rough_springs, 2e-5, 1e-6)
    law = crack(speed)
    broken = law.broken(rough_springs, bonds, outcome)
    after = law.after(rough_springs, bonds, outcome)
    moved = ~broken & (after.reach < bonds.reach)
    assert moved.sum() > 10
    left = release_rate(rough_springs, after.reach, 1e-6)
    np.testing.assert_allclose(left[moved], 0.05, rtol=1e-4)  # 40 halvings
    assert np.all(after.reach[broken] == 0)
    # where it broke there is no radius at which it could have stayed
    tried = np.linspace(2e-5, 1e-7, 400)[:, None] * np.ones(64)
    assert np.all(release_rate(rough_springs, tried, 1e-6)[:, broken] > 0.049)


def test_age_makes_a_contact_tough() -> None:
    law = RecedingContact(0.05, 0.1, 1e-3, 1e6, 0.5)
    old = law.toughness(bonded(age=1e-3 * (np.e - 1)))
    np.testing.assert_allclose(old, 0.05 * 1.1, rtol=1e-12)  # rounding
    np.testing.assert_array_equal(law.toughness(bonded(age=0.0)), 0.05)


def test_impossible_numbers_are_refused() -> None:
    with pytest.raises(InputError, match="binding_rate must not be negative, got -1 1/s"):
        BondKinetics(-1, 1, 1)
    with pytest.raises(InputError, match="unbinding_rate must not be negative, got nan 1/s"):
        BondKinetics(1, np.nan, 1)
    with pytest.raises(InputError, match="work_of_adhesion must not be negative, got -1 J/m²"):
        RecedingContact(-1, 0, 1, 1, 1)
