"""The lines along which elements unload: continuous, monotone, the slope of an energy."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact.interface import Hinged, Interface, Mirrored
from tyrecontact.road.springs import Springs

HINGE = np.linspace(0, 3e-5, 64)
FREE, BONDED = np.zeros(64, bool), np.ones(64, bool)
#: from deep in tension to beyond the hinge [m]
PLACES = np.linspace(-4e-5, 5e-5, 801)


def sampled(interface: Interface) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Force, stiffness and energy at all places, (places, elements)."""
    found = [interface.respond(np.full(64, place))[:2] for place in PLACES]
    energy = [interface.respond(np.full(64, place)).energy for place in PLACES]
    return np.array([f for f, _ in found]), np.array([k for _, k in found]), np.array(energy)


@pytest.mark.parametrize("bonded", [FREE, BONDED], ids=["free", "bonded"])
@pytest.mark.parametrize("kind", ["mirrored", "hinged"])
def test_force_is_the_monotone_slope_of_the_energy(
    rough_springs: Springs, bonded: np.ndarray, kind: str
) -> None:
    make = {"mirrored": Mirrored(rough_springs, bonded), "hinged": None}[kind]
    force, stiffness, energy = sampled(make or Hinged(rough_springs, bonded, HINGE))
    rises = np.diff(force, axis=0)
    scale = np.abs(force).max(axis=0)
    assert np.all(rises >= -1e-12 * scale)  # rounding
    mean = (force[1:] + force[:-1]) / 2 * np.diff(PLACES)[:, None]
    # the trapezoid's error: a step by the change of force in it
    assert np.all(np.abs(np.diff(energy, axis=0) - mean) <= rises * np.diff(PLACES)[:, None])
    # the stiffness is between the secants on both sides, but for corners: few places in 799
    secant = rises / np.diff(PLACES)[:, None]
    low, high = np.minimum(secant[1:], secant[:-1]), np.maximum(secant[1:], secant[:-1])
    inside = (stiffness[1:-1] >= low * (1 - 1e-6)) & (stiffness[1:-1] <= high * (1 + 1e-6))
    assert inside.mean() > 0.98


def test_a_hinged_element_unloads_as_the_punch_it_was(rough_springs: Springs) -> None:
    force, stiffness = Hinged(rough_springs, BONDED, HINGE).respond(HINGE - 1e-6)[:2]
    slope = rough_springs.punch_stiffness(HINGE)
    np.testing.assert_allclose(stiffness[1:], slope[1:], rtol=1e-12)  # rounding
    expected = rough_springs.force(HINGE) - slope * 1e-6
    np.testing.assert_allclose(force[1:], expected[1:], rtol=1e-12, atol=1e-12)


def test_a_free_hinged_element_carries_nothing_below_its_zero(rough_springs: Springs) -> None:
    free, held = Hinged(rough_springs, FREE, HINGE), Hinged(rough_springs, BONDED, HINGE)
    for share in (0.99, 0.5, -0.5):
        pull = held.respond(share * HINGE).force
        force, stiffness = free.respond(share * HINGE)[:2]
        np.testing.assert_array_equal(force, np.maximum(pull, 0))
        np.testing.assert_array_equal(stiffness[pull < 0], 0)
    # what a loop of loading and unloading leaves in the dent is not negative
    assert np.all(free.respond(np.zeros(64)).energy >= 0)


def test_beyond_the_hinge_an_element_loads_on(rough_springs: Springs) -> None:
    deeper = HINGE + 5e-6
    force, stiffness = Hinged(rough_springs, BONDED, HINGE).respond(deeper)[:2]
    # two ways to take derivatives of a polynomial
    np.testing.assert_allclose(force, rough_springs.force(deeper), rtol=1e-14)
    np.testing.assert_allclose(stiffness, rough_springs.stiffness(deeper), rtol=1e-13)
