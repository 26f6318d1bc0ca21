"""A clock by hand: when steps are due, and how long the others will take."""

from __future__ import annotations

import pytest

from app.pace import Pace


def _follow(pace: Pace, now: float, steps: int, work: float) -> float:
    """Take steps as they are due, each of so much work [s]; the time at the end."""
    for _ in range(steps):
        now += pace.delay(now)
        pace.begin(now)
        now += work
        pace.end(now)
    return now


@pytest.fixture
def pace() -> Pace:
    """100 steps in 10 s: one every 0.1 s."""
    made = Pace(10.0)
    made.steps = 100
    return made


def test_steps_are_spread_over_the_duration(pace: Pace) -> None:
    assert _follow(pace, 5.0, 100, 0.01) == pytest.approx(5.0 + 99 * 0.1 + 0.01)


def test_no_duration_is_no_wait() -> None:
    assert _follow(Pace(), 5.0, 100, 0.01) == pytest.approx(6.0)


def test_a_pause_is_not_made_up(pace: Pace) -> None:
    now = _follow(pace, 0.0, 10, 0.01) + 1000.0
    pace.rest()
    assert pace.delay(now) == 0
    assert _follow(pace, now, 10, 0.01) - now == pytest.approx(9 * 0.1 + 0.01)


def test_one_long_step_is_followed_by_no_rush(pace: Pace) -> None:
    now = _follow(pace, 0.0, 1, 5.0)
    # one interval is caught up on
    assert _follow(pace, now, 10, 0.01) - now == pytest.approx(8 * 0.1 + 0.01)


@pytest.mark.parametrize("duration", [1.0, 1000.0])
def test_another_duration_holds_from_the_next_step_on(pace: Pace, duration: float) -> None:
    now = _follow(pace, 0.0, 10, 1e-3)
    pace.duration = duration
    after = _follow(pace, now, 10, 1e-3)
    assert after - now == pytest.approx(10 * duration / 100, rel=1e-9, abs=0.1)


def test_a_shorter_duration_is_no_jump(pace: Pace) -> None:
    pace.duration = 1000.0
    now = _follow(pace, 0.0, 10, 1e-3)
    pace.duration = 10.0
    assert _follow(pace, now + 50.0, 10, 1e-3) - (now + 50.0) >= 8 * 0.1


def test_the_time_left_is_none_at_first_and_follows_the_pace(pace: Pace) -> None:
    assert pace.time_left(0) is None
    now = _follow(pace, 0.0, 2, 0.01)
    assert pace.time_left(2) is None
    now = _follow(pace, now, 8, 0.01)
    assert pace.time_left(10) == pytest.approx(9.0)
    pace.duration = 0.0  # as fast as it can: what the solver takes
    assert pace.time_left(10) == pytest.approx(0.9)
    pace.duration = 100.0
    assert pace.time_left(10) == pytest.approx(90.0)


def test_the_time_left_is_that_of_the_last_seconds_and_does_not_jump() -> None:
    pace = Pace()
    pace.steps = 2000
    now = _follow(pace, 0.0, 1000, 0.01)
    assert pace.time_left(1000) == pytest.approx(10.0)
    now = _follow(pace, now, 1, 0.5)  # a hitch
    assert pace.time_left(1001) < 15.0
    _follow(pace, now, 500, 0.03)  # slower from now on
    assert pace.time_left(1501) == pytest.approx(499 * 0.03, rel=0.05)
