"""Loading and unloading as curves: from runs made by hand, whose slopes are known."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.branches import Branch, branches

#: pressed to 100 in 50 steps, held for 10, and back to -20
DEPTH = np.concatenate([np.linspace(0, 100, 51), np.full(10, 100.0), np.linspace(98, -20, 60)])


def force(depth: np.ndarray) -> np.ndarray:
    return np.where(depth > 0, 2 * depth, 0.0)


def test_a_run_that_returns_has_two_branches_and_the_hold_is_on_neither() -> None:
    relaxing = force(DEPTH)
    relaxing[51:61] -= np.arange(10)
    up, down = branches(DEPTH, relaxing)
    assert (up.depth[0], up.depth[-1]) == (0, 100)
    assert up.force[-1] == 200
    assert (down.depth[-1], down.force[-1]) == (100, 191)
    assert np.all(np.diff(up.depth) > 0)
    assert np.all(np.diff(down.depth) > 0)
    assert down.depth[0] >= -2  # what comes after they have parted is told by nobody


def test_slopes_are_those_of_the_force() -> None:
    up, _ = branches(DEPTH, force(DEPTH))
    depth, pressed, stiffness = up.slope()
    np.testing.assert_allclose(stiffness, 2)
    np.testing.assert_allclose(pressed, 2 * depth)


@pytest.mark.parametrize("finer", [1, 7])
def test_a_slope_does_not_depend_on_the_steps(finer: int) -> None:
    depth = np.linspace(0, 1e-4, 200 * finer + 1)
    found, _, stiffness = branches(depth, 1e10 * depth**2)[0].slope()
    np.testing.assert_allclose(stiffness[1:-1], 2e10 * found[1:-1], rtol=1e-6)


def test_what_creeps_in_a_hold_is_not_loading() -> None:
    """A machine's spring goes on pressing while the force of the tread falls."""
    drive = np.concatenate([np.arange(0, 11.0), np.full(5, 10.0), np.arange(9.0, -1, -1)])
    depth = np.concatenate([np.arange(0, 11.0), 10 + np.arange(1, 6) / 10, np.arange(9.0, -1, -1)])
    pressed = np.concatenate([np.arange(0, 11.0), 10 - np.arange(1, 6), np.arange(4.5, -0.5, -0.5)])
    up, down = branches(depth, pressed, drive)
    assert up.depth[-1] == 10
    np.testing.assert_allclose(up.slope()[2], 1)
    assert down.depth[-1] == 10.5


def test_steps_that_do_not_press_deeper_are_left_out() -> None:
    depth = np.array([0.0, 1, 1, 2, 1.5, 3, 4])
    up, down = branches(depth, depth)
    assert up.depth.tolist() == [0, 1, 2, 3, 4]
    assert down.depth.size == 0
    assert all(part.size == 0 for part in down.slope())


def test_a_run_that_never_touches_has_none() -> None:
    up, down = branches(np.linspace(-5, -1, 9), np.zeros(9))
    assert up.depth.size == down.depth.size == 0
    assert np.isnan(up.at(np.array([0.0]))).all()
    assert branches(np.zeros(0), np.zeros(0))[0].depth.size == 0


def test_a_difference_is_told_where_both_are() -> None:
    run = Branch(np.array([0.0, 2, 4]), np.array([0.0, 6, 12]))
    still = Branch(np.array([1.0, 3, 5]), np.array([2.0, 6, 10]))
    depth, excess, due = run.less(still)
    assert depth.tolist() == [1, 3]
    assert excess.tolist() == [1, 3]
    assert due.tolist() == [2, 6]
