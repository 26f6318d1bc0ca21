"""What is read off a run, on runs whose answer is known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact import Results
from tyrecontact.thesis import measures

Made = Callable[..., Results]
EXACT = 1e-12  # rounding


def test_loading_rate_is_the_slope_after_the_beginning(made: Made) -> None:
    time = np.linspace(0, 10e-3, 201)
    force = np.where(time < 2e-3, 0.0, 3e4 * (time - 2e-3))  # 30 N/ms after 2 ms of nothing
    run = made(time=time, contact_force=force)
    assert measures.loading_rate(run) == pytest.approx(3e4, rel=EXACT)


def test_unloading_rate_counts_from_the_end_of_the_hold(made: Made) -> None:
    time = np.arange(9) * 1e-3
    depth = np.array([0, 1, 2, 2, 2, 1.5, 1, 0.5, 0.0]) * 1e-5
    force = np.array([0, 5, 10, 9, 8, 4, 0, -3, 0.0])
    run = made(time=time, indentation=depth, contact_force=force)
    assert measures.unloading_rate(run) == pytest.approx(8 / 2e-3, rel=EXACT)
    never = made(time=time, indentation=depth, contact_force=force + 100)
    assert np.isnan(measures.unloading_rate(never))


def test_adherence_needs_a_separation(made: Made) -> None:
    force = np.array([0, 10, -4, 0.0])
    assert measures.adherence(made(contact_force=force, contacts=[0, 3, 2, 0])) == 4
    assert np.isnan(measures.adherence(made(contact_force=force, contacts=[0, 3, 2, 1])))


def test_failing_and_sound_depth(made: Made) -> None:
    depth = np.linspace(0, 1e-4, 101)
    still = made(indentation=depth, contact_force=1e6 * depth)
    assert measures.failing_depth(still) == measures.sound_depth(still, still) == np.inf
    converged = np.ones(101, np.int8)
    converged[60:] = 0
    failing = made(indentation=depth, contact_force=1e6 * depth, converged=converged)
    assert measures.failing_depth(failing) == pytest.approx(60e-6, rel=EXACT)
    assert measures.force_before_failure(failing) == pytest.approx(59, rel=EXACT)
    force = np.where(depth > 39.5e-6, 2e6 * depth, 1e6 * depth)  # converges, and is wrong
    wrong = made(indentation=depth, contact_force=force, converged=converged)
    assert measures.sound_depth(wrong, still) == pytest.approx(40e-6, rel=EXACT)
    turns, ratio = measures.wildness(failing, still)
    assert (turns, ratio) == (0, pytest.approx(1, rel=EXACT))
    assert measures.wildness(still, still) == (0, 0.0)


def test_excess_is_a_share_and_nan_where_nothing_is_known(made: Made) -> None:
    depth = np.linspace(0, 1e-4, 11)
    still = made(indentation=depth, contact_force=1e6 * depth)
    stiffer = made(indentation=depth, contact_force=1.05e6 * depth)
    found = measures.excess(stiffer, still, np.array([5e-5, 2e-4]))
    assert found[0] == pytest.approx(0.05, rel=1e-9)  # rounding of a difference
    assert np.isnan(found[1])


def test_the_largest_event_is_a_share_of_those_that_held(made: Made) -> None:
    # the last three always go together and do not count: fewer than a tenth
    run = made(contacts=[0, 40, 40, 30, 3, 0], releases=[0, 0, 0, 10, 27, 3])
    assert measures.largest_event(run) == pytest.approx(27 / 30, rel=EXACT)


def test_stiffness_of_a_parabola(made: Made) -> None:
    depth = np.linspace(0, 1e-4, 2001)
    run = made(indentation=depth, contact_force=1e10 * depth**2)
    at, force, stiffness = measures.stiffness_curve(run)
    assert at[-1] == pytest.approx(1e-4, rel=EXACT)
    np.testing.assert_allclose(force, 1e10 * at**2, atol=1e-4 * force.max())  # interpolation
    np.testing.assert_allclose(stiffness[1:-1], 2e10 * at[1:-1], rtol=1e-3, atol=2e3)  # as above


def test_spread_and_difference(made: Made) -> None:
    assert measures.spread(np.array([9.0, 10, 11])) == pytest.approx(0.2, rel=EXACT)
    assert np.isnan(measures.spread(np.array([1.0, np.nan])))
    one, two = made(contact_force=[0, 10.0, 20.0]), made(contact_force=[0, 11.0, 20.0])
    assert measures.mean_difference(one, two) == pytest.approx(1 / 60, rel=EXACT)
