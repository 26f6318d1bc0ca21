"""Indentation against time: end points, laws, corners, and lengths that make no sense."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact import loading
from tyrecontact.errors import InputError
from tyrecontact.loading import MAX_STEPS, Path

DEPTH, TIME_STEP = 0.2e-3, 1 / 51200


def cycle(hold_time: float = 2e-3, unloading_rate: float = 0.003, retraction: float = 1e-4) -> Path:
    return loading.load_hold_unload(DEPTH, 0.03, hold_time, unloading_rate, retraction)


@pytest.mark.parametrize(
    ("rate", "duration"), [(0.01, 20e-3), (0.015, 13.3e-3), (0.03, 6.67e-3), (0.1, 2e-3)]
)
def test_the_rates_of_the_thesis_reach_the_depth_in_its_times(rate: float, duration: float) -> None:
    time, depth = loading.linear(DEPTH, rate).sampled(TIME_STEP)
    # the thesis gives three digits, and a path takes whole steps
    assert time[-1] == pytest.approx(duration, rel=4e-3, abs=TIME_STEP / 2)
    assert depth[-1] == DEPTH


@pytest.mark.parametrize("time_step", [TIME_STEP, TIME_STEP / 4, 1e-5, 1.23e-5])
@pytest.mark.parametrize("path", [loading.linear(DEPTH, 0.03), loading.quadratic(DEPTH, 9.0)])
def test_a_loading_rises_from_rest_to_its_exact_end(path: Path, time_step: float) -> None:
    time, depth = path.sampled(time_step)
    assert time[0] == depth[0] == 0
    np.testing.assert_allclose(np.diff(time), time_step, rtol=1e-9)  # rounding of long times
    assert np.all(np.diff(depth) > 0)
    assert depth[-1] == DEPTH
    assert abs(time[-1] - path.time[-1]) < 0.501 * time_step  # the nearest whole step


def test_a_linear_loading_has_its_rate() -> None:
    time, depth = loading.linear(DEPTH, 0.03).sampled(TIME_STEP)
    np.testing.assert_allclose(np.diff(depth), depth[1], rtol=1e-10)  # rounding of differences
    # half a step in 341 is given to the rate, so that the path takes whole steps
    np.testing.assert_allclose(depth, 0.03 * time, rtol=0.5 / 341)


@pytest.mark.parametrize("half_acceleration", [0.5, 1.13, 4.5, 50.0])
def test_a_quadratic_loading_is_c_t_squared(half_acceleration: float) -> None:
    time, depth = loading.quadratic(DEPTH, 2 * half_acceleration).sampled(TIME_STEP)
    np.testing.assert_allclose(depth, DEPTH * (time / time[-1]) ** 2, rtol=1e-12)  # rounding
    # half a step of the time, squared
    np.testing.assert_allclose(depth, half_acceleration * time**2, rtol=1.01 / (len(time) - 1))
    assert time[-1] == pytest.approx(np.sqrt(DEPTH / half_acceleration), abs=TIME_STEP / 2)


def test_a_cycle_has_its_corners() -> None:
    path = cycle()
    down, hold, up = DEPTH / 0.03, 2e-3, (DEPTH + 1e-4) / 0.003
    np.testing.assert_allclose(path.time, np.cumsum([0, down, hold, up]), rtol=1e-15)  # rounding
    np.testing.assert_array_equal(path.drive, [0, DEPTH, DEPTH, -1e-4])


def test_a_cycle_goes_down_stays_and_comes_up_at_its_rates() -> None:
    time, depth = cycle().sampled(TIME_STEP)
    held = np.flatnonzero(depth == DEPTH)
    down, up = depth[: held[0] + 1], depth[held[-1] :]
    assert (depth[0], depth[-1]) == (0, -1e-4)
    # each leg takes whole steps: half of one is given to its rate, or to the hold
    np.testing.assert_allclose(np.diff(down) / TIME_STEP, 0.03, rtol=0.5 / 341)
    np.testing.assert_allclose(np.diff(up) / TIME_STEP, -0.003, rtol=0.5 / 5120)
    assert time[held[-1]] - time[held[0]] == pytest.approx(2e-3, abs=TIME_STEP / 2)


def test_no_hold_time_turns_around_at_once() -> None:
    path = cycle(hold_time=0.0)
    assert np.all(np.diff(path.time) > 0)
    np.testing.assert_array_equal(path.drive, [0, DEPTH, -1e-4])
    _, depth = path.sampled(TIME_STEP)
    assert np.sum(depth == DEPTH) == 1
    assert depth.max() == DEPTH


def test_no_retraction_ends_at_first_contact() -> None:
    _, depth = cycle(retraction=0.0).sampled(TIME_STEP)
    assert depth[-1] == 0


def test_every_knot_of_a_path_is_met_by_a_step() -> None:
    path = Path(np.array([0.0, 2.4, 5.1, 5.2]), np.array([0.0, 2.0, 5.0, 1.0]))
    time, depth = path.sampled(1.0)
    np.testing.assert_array_equal(time, [0, 1, 2, 3, 4, 5, 6])
    np.testing.assert_allclose(depth, [0, 1, 2, 3, 4, 5, 1], rtol=1e-15)  # rounding


def test_a_whole_number_of_steps_gets_no_step_more() -> None:
    """0.3 / 0.1 is above 3 in floating point."""
    time, _ = Path(np.array([0.0, 0.3]), np.array([0.0, 1.0])).sampled(0.1)
    assert len(time) == 4


@pytest.mark.parametrize("steps", [0.5, 1, MAX_STEPS + 1, 1e9])
def test_too_few_or_too_many_steps_are_refused_with_their_number(steps: float) -> None:
    path = Path(np.array([0.0, steps]), np.array([0.0, 1.0]))
    with pytest.raises(InputError, match=rf"^loading must take 3 to {MAX_STEPS} steps, got \d+ "):
        path.sampled(1.0)


@pytest.mark.parametrize("intervals", [2, MAX_STEPS - 1])
def test_the_fewest_and_the_most_steps_are_taken(intervals: int) -> None:
    path = Path(np.array([0.0, intervals]), np.array([0.0, 1.0]))
    assert len(path.sampled(1.0)[0]) == intervals + 1


def test_the_number_refused_lies_outside_those_that_are_named() -> None:
    path = Path(np.array([0.0, MAX_STEPS]), np.array([0.0, 1.0]))
    with pytest.raises(InputError, match=f"got {MAX_STEPS + 1} "):
        path.sampled(1.0)
