"""Drive against time: end points, laws, corners, long holds, tables, lengths without sense."""

from __future__ import annotations

from pathlib import Path as FilePath

import numpy as np
import pytest

from tyrecontact import loading
from tyrecontact.errors import InputError
from tyrecontact.loading import MAX_STEPS, Path, Schedule

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


def held(hold_time: float, memory: float = 5e-3) -> Schedule:
    return cycle(hold_time).schedule(TIME_STEP, memory)


@pytest.mark.parametrize("hold_time", [0.11, 1.0, 960.0, 86400.0])
def test_a_long_hold_takes_few_steps_and_all_of_its_time(hold_time: float) -> None:
    schedule, short = held(hold_time), held(0.0)
    assert np.all(np.diff(schedule.time) > 0)
    # each leg takes whole steps
    longer = schedule.time[-1] - short.time[-1]
    assert longer == pytest.approx(hold_time, abs=TIME_STEP)
    added = len(schedule.time) - len(short.time)
    # two memories of 256 steps, and 12 steps a decade from then on
    decades = np.log10(hold_time / 1e-2)
    assert added == pytest.approx(512 + 12 * decades, abs=2)
    still = np.flatnonzero(schedule.at_rest)
    assert np.all(schedule.drive[still] == DEPTH)
    # the hold ends on its knot, and the unloading begins with a whole step
    assert schedule.time[still[-1] + 1] - schedule.time[still[-1]] == pytest.approx(TIME_STEP)
    assert schedule.drive[still[-1] + 1] < DEPTH


def test_a_hold_of_960_s_takes_fewer_than_1500_steps_beside_its_ramps() -> None:
    quick = loading.load_hold_unload(DEPTH, 0.03, 960.0, 0.03, 1e-4)
    schedule = quick.schedule(TIME_STEP, 5e-3)
    assert len(schedule.time) < 1500
    assert np.sum(schedule.at_rest) < 70


@pytest.mark.parametrize("memory", [5e-3, np.inf])
def test_short_holds_and_holds_that_are_stepped_have_no_steps_at_rest(memory: float) -> None:
    schedule = held(0.09, memory)
    assert not schedule.at_rest.any()
    np.testing.assert_allclose(np.diff(schedule.time), TIME_STEP, rtol=1e-9)  # rounding
    time, drive = cycle(0.09).sampled(TIME_STEP)
    np.testing.assert_array_equal(time, schedule.time)
    np.testing.assert_array_equal(drive, schedule.drive)


def test_before_and_after_a_long_hold_nothing_changes() -> None:
    schedule, short = held(10.0), held(0.0)
    down, up = 341, 5120
    np.testing.assert_array_equal(schedule.drive[: down + 1], short.drive[: down + 1])
    # an interpolation between other places: rounding
    np.testing.assert_allclose(schedule.drive[-up:], short.drive[-up:], rtol=1e-9, atol=1e-18)


def test_a_sinusoidal_loading_swings_once() -> None:
    time, depth = loading.sinusoidal(1e-4, -5e-5, 20e-3).sampled(TIME_STEP)
    expected = 2.5e-5 - 7.5e-5 * np.cos(2 * np.pi * time / 20e-3)
    np.testing.assert_allclose(depth, expected, atol=1e-18)  # rounding
    assert (depth[0], depth[-1], depth.max()) == (-5e-5, -5e-5, 1e-4)


def test_a_sinusoidal_force_may_begin_at_none() -> None:
    _, force = loading.sinusoidal(50.0, -20.0, 10e-3, first=0.0).sampled(TIME_STEP)
    assert (force[0], force[-1], force.max()) == (0.0, -20.0, 50.0)
    assert np.abs(np.diff(force)).max() < 70 * np.pi / 512  # no jump


def test_a_table_is_met_at_its_times() -> None:
    time = np.array([0.0, 1e-3, 1.5e-3, 4e-3])
    drive = np.array([0.0, 5e-5, 5e-5, -1e-5])
    found = loading.table(time, drive).sampled(1e-5)
    np.testing.assert_allclose(found[1], np.interp(found[0], time, drive), atol=1e-18)
    assert found[0][-1] == pytest.approx(4e-3)


def test_a_table_may_have_more_rows_than_steps() -> None:
    time = np.linspace(0, 1e-2, 100_001)
    found = loading.table(time, np.sin(np.pi * time / 1e-2) * DEPTH).sampled(TIME_STEP)
    assert len(found[0]) == 513
    # the row nearest a step may be half a row away: 5e-8 s at 0.06 m/s
    np.testing.assert_allclose(found[1], np.sin(np.pi * found[0] / 1e-2) * DEPTH, atol=1e-8)


def test_knots_of_a_table_are_moved_to_the_nearest_step() -> None:
    found = loading.table(np.array([0.0, 2.4, 5.1, 7.6]), np.array([0.0, 2.0, 5.0, 1.0]))
    time, drive = found.sampled(1.0)
    np.testing.assert_array_equal(time, np.arange(9))
    np.testing.assert_allclose(drive, [0, 1, 2, 3, 4, 5, 11 / 3, 7 / 3, 1], rtol=1e-12)


def test_a_hold_is_one_however_many_rows_it_has() -> None:
    """Ten minutes at ten rows a second: each row by itself would be followed step by step."""
    rows = np.concatenate([[0.0], np.arange(0.01, 600, 0.1), [600.02]])
    drive = np.concatenate([[0.0], np.full(rows.size - 2, DEPTH), [-DEPTH]])
    schedule = loading.table(rows, drive).schedule(TIME_STEP, 5e-3)
    assert len(schedule.time) < 8000
    assert schedule.at_rest.sum() > 20
    assert schedule.time[-1] == pytest.approx(600.02, abs=TIME_STEP)


def test_a_table_that_begins_late_waits() -> None:
    path = loading.table(np.array([1e-3, 2e-3]), np.array([0.0, 1e-5]))
    np.testing.assert_array_equal(path.time, [0, 1e-3, 2e-3])
    np.testing.assert_array_equal(path.drive, [0, 0, 1e-5])


@pytest.mark.parametrize(
    ("time", "drive", "reason"),
    [
        ([0, 1, 1], [0, 1, 2], "must increase in time, got 1 s and then 1 s in row 3"),
        ([0, 2, 1], [0, 1, 2], "must increase in time, got 2 s and then 1 s in row 3"),
        ([0, np.nan, 1], [0, 1, 2], "must hold finite numbers"),
        ([0, 1, np.inf], [0, 1, 2], "must hold finite numbers"),
        ([0, 1], [0, np.inf], "must hold finite numbers"),
        ([0, 1e308], [0, 1e-5], r"must hold times up to 1e\+09, got 1e\+308"),
        ([0, 1e-3], [0, 1e300], r"must hold values up to 1e\+06, got 1e\+300"),
        ([0], [0], "must have at least 2 rows, got 1"),
        ([-1, 1], [0, 1], "must begin at a time of 0 s or later, got -1 s"),
    ],
)
def test_a_table_that_is_none_is_refused(
    time: list[float], drive: list[float], reason: str
) -> None:
    with pytest.raises(InputError, match=f"^loading.table {reason}"):
        loading.table(np.array(time, float), np.array(drive, float))


@pytest.mark.parametrize(
    "text", ["0 0\n1e-3 5e-5\n", "# t d\n0, 0\n\n1e-3, 5e-5 # end\n", "\ufeff0;0\r\n1e-3;5e-5"]
)
def test_a_table_is_read_in_any_of_the_usual_spellings(text: str, tmp_path: FilePath) -> None:
    file = tmp_path / "table.txt"
    file.write_text(text, encoding="utf-8")
    path = loading.read_table(file)
    np.testing.assert_array_equal(path.time, [0, 1e-3])
    np.testing.assert_array_equal(path.drive, [0, 5e-5])


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"0\n1\n2\n",
        b"0 1\n1\n",
        b"t d\n0 1\n",
        b"0 1 2\n3 4 5\n",
        b"\xff\xfe\x00",
        b"0,5 0,7\n",
    ],
)
def test_a_file_that_is_no_table_is_refused(content: bytes, tmp_path: FilePath) -> None:
    file = tmp_path / "table.txt"
    file.write_bytes(content)
    with pytest.raises(InputError, match=r"must hold two columns of numbers, got table\.txt"):
        loading.read_table(file)


def test_a_table_that_cannot_be_read_is_refused(
    tmp_path: FilePath, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(InputError, match=r"must be readable, got none\.txt: No such file"):
        loading.read_table(tmp_path / "none.txt")
    for name in ("~nobody-has-this-name/table.txt", "nul\0.txt"):
        with pytest.raises(InputError, match="must be readable"):
            loading.read_table(name)
    with pytest.raises(InputError, match="must be a file, got null, which is none"):
        loading.read_table("/dev/null")
    with pytest.raises(InputError, match="must be a file"):
        loading.read_table(tmp_path)
    large = tmp_path / "large.txt"
    large.write_text("0 0\n1 1\n" * 10)
    monkeypatch.setattr(loading, "MAX_TABLE_BYTES", 20)
    with pytest.raises(InputError, match=r"must have at most 2e-05 MB, got 8e-05 MB"):
        loading.read_table(large)
