"""Curves of long runs: few points, the extremes, both ends; and little to send."""

from __future__ import annotations

import numpy as np
import pytest

from app.views import trace
from app.views.force import ForceView
from app.views.iterations import IterationsView
from app.views.style import Horizontal
from app.views.trace import POINTS, Trace, extremes
from tyrecontact.results import FIELDS, SCALARS, Record
from tyrecontact.steps import Step

LONG = 30_000


def columns(steps: int) -> dict[str, np.ndarray]:
    """A force that swings, with one peak and one trough of a single step each."""
    force = np.sin(np.arange(steps) / 3000)
    force[[steps // 3, steps // 2]] = 9, -9
    return {
        "time": np.arange(steps) * 1e-5,
        "indentation": np.arange(steps) * 1e-9,
        "contact_force": force,
    }


def followed(steps: int, frame: int) -> tuple[Trace, int]:
    """A trace fed frame by frame to the end, and the number of points it was sent."""
    found, rows, sent = Trace("force", "contact_force"), columns(steps), 0
    for high in [*range(frame, steps, frame), steps]:
        before = found.source.data
        size = len(before["force"])
        found.update(rows, np.arange(high), high == steps)
        after = found.source.data
        sent += len(after["force"]) - (size if after is before else 0)
    return found, sent


@pytest.mark.parametrize("frame", [1, 7, 61, 5003])
def test_a_long_curve_has_few_points_its_ends_and_its_extremes(frame: int) -> None:
    steps = 9_001 if frame == 1 else LONG
    found, _ = followed(steps, frame)
    force = np.asarray(found.source.data["force"])
    time = np.asarray(found.source.data["time_ms"])
    assert POINTS / 4 < force.size <= POINTS + 2
    assert (force.max(), force.min()) == (9, -9)
    assert (time[0], time[-1]) == (0, pytest.approx((steps - 1) * 1e-2))
    assert np.all(np.diff(time) > 0)
    np.testing.assert_allclose(found.source.data["indentation_um"], time / 10, rtol=1e-9)
    # two points a stretch; nowhere farther from point to point than two stretches
    stretch = np.ceil(2.2 * steps / POINTS)
    assert np.diff(time).max() < 2 * stretch * 1e-2


def test_what_is_no_number_hides_no_extreme() -> None:
    values = np.array([0, 1, np.nan, 9, -9, 2, 3, 4, np.nan, 5, -5])
    assert set(extremes(values, 8)) >= {3, 4, 9, 10}


@pytest.mark.parametrize("frame", [1, 7, 61])
def test_a_curve_of_few_steps_has_a_point_for_each(frame: int) -> None:
    found, sent = followed(POINTS, frame)
    np.testing.assert_array_equal(found.source.data["force"], columns(POINTS)["contact_force"])
    assert sent == POINTS


def test_what_is_sent_does_not_grow_with_the_steps(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(trace, "POINTS", 100)
    sent = [followed(steps, 10)[1] for steps in (1000, 2000, 4000, 8000, 16_000)]
    # a quarter of them in full, and then no more than there is room for
    assert max(sent) <= 1.5 * 100


def test_an_end_that_comes_twice_adds_nothing() -> None:
    found, _ = followed(LONG, 64)
    before = len(found.source.data["force"])
    found.update(columns(LONG), np.arange(LONG), True)
    assert len(found.source.data["force"]) == before
    found.clear()
    assert len(found.source.data["force"]) == 0
    found.update(columns(LONG), np.arange(3), False)
    assert len(found.source.data["force"]) == 3


@pytest.mark.parametrize(
    ("axis", "low", "high"), [("time_ms", 99.995, 111.005), ("indentation_um", 9.9995, 11.1005)]
)
def test_a_part_of_a_run_that_has_ended_is_shown_in_full(
    axis: str, low: float, high: float
) -> None:
    found, _ = followed(LONG, 64)
    before = np.asarray(found.source.data["force"])
    found.look(axis, low, high)
    place = np.asarray(found.source.data[axis])
    inside = (place >= low) & (place <= high)
    expected = columns(LONG)["contact_force"][10_000:11_101]
    np.testing.assert_array_equal(np.asarray(found.source.data["force"])[inside], expected)
    assert len(before) < place.size <= 2 * POINTS
    assert np.all(np.diff(place) > 0)
    found.look(axis, -1.0, 1e9)  # all of it: as much as there is room for
    force = np.asarray(found.source.data["force"])
    assert force.size <= 2 * POINTS
    assert (force.max(), force.min()) == (9, -9)


def test_a_run_under_way_is_not_looked_into() -> None:
    found = Trace("force", "contact_force")
    found.update(columns(LONG), np.arange(LONG), False)
    before = found.source.data
    found.look("time_ms", 0.0, 1.0)
    assert found.source.data is before


def test_nothing_is_drawn_of_no_rows() -> None:
    found = Trace("force", "contact_force")
    found.update(columns(10), np.arange(0), True)
    assert len(found.source.data["force"]) == 0


def test_extremes_of_stretches() -> None:
    values = np.array([0.0, 5, 1, 2, -3, 2, 7, 7])
    assert extremes(values, 3).tolist() == [0, 1, 3, 4, 6]
    assert extremes(values, 1).tolist() == list(range(8))
    assert extremes(values[:0], 4).tolist() == []


def test_both_plots_draw_a_long_run_lightly() -> None:
    """A record of many steps, most of them failed, with memory for the maps of a few."""
    record = Record(LONG, (2, 2), field_memory=1e4)
    numbers = dict.fromkeys(SCALARS, 0)
    maps = {name: np.zeros((2, 2), kind) for name, (*_, kind) in FIELDS.items()}
    force, iterations = ForceView(), IterationsView()
    iterations.reset(10)
    for index in range(LONG):
        numbers.update(contact_force=index % 997, iterations=index % 11, converged=index % 3 == 0)
        record.append(Step(index=index, time=index * 1e-5, **numbers, **maps))
        if index % 500 == 499:
            for view in (force, iterations):
                view.update(record, index - 499, index + 1, index == LONG - 1)
    assert np.max(force.source.data["force"]) == 996
    assert np.max(iterations.source.data["iterations"]) == 10
    assert force.root.y_range.end > 996
    for source in (force.source, force.failed, iterations.source, iterations.failed):
        assert POINTS / 4 < len(source.data["time_ms"]) <= POINTS + 2
    last = [source.data["time_ms"][-1] for source in (force.source, force.failed)]
    np.testing.assert_allclose(last, (LONG - 1) * 1e-2)
    for view in (force, iterations):
        view.show_against(Horizontal("time_ms", "Time [ms]", (99.995, 110.005)))
        view.look()
        shown = np.asarray(view.source.data["time_ms"])
        assert np.count_nonzero((shown > 99.995) & (shown < 110.005)) == 1001


def test_where_a_run_stands_still_its_last_step_is_drawn() -> None:
    found, rows = Trace("force", "contact_force"), columns(LONG)
    for high in range(64, 2001, 64):
        found.update(rows, np.arange(high), False)
    for high in range(2001, 2011):  # step by step
        found.update(rows, np.arange(high), False, still=True)
        assert found.source.data["time_ms"][-1] == pytest.approx((high - 1) * 1e-2)
    for high in range(2011, LONG, 64):
        found.update(rows, np.arange(high), False)
    found.update(rows, np.arange(LONG), True)
    time, force = (np.asarray(found.source.data[name]) for name in ("time_ms", "force"))
    assert np.all(np.diff(time) > 0)
    assert (force.max(), force.min()) == (9, -9)


def test_a_run_that_is_stopped_early_is_drawn_in_full() -> None:
    found, rows = Trace("force", "contact_force"), columns(LONG)
    for high in range(64, 1001, 64):
        found.update(rows, np.arange(high), False)
    assert len(found.source.data["force"]) < POINTS / 2
    found.update(rows, np.arange(1000), True)
    np.testing.assert_array_equal(found.source.data["force"], rows["contact_force"][:1000])


def test_steps_that_failed_early_in_a_long_run_are_all_drawn_in_the_end() -> None:
    found, rows = Trace("force", "contact_force"), columns(LONG)
    for high in range(60, LONG, 600):
        found.update(rows, np.arange(min(high, 420)), False)
    found.update(rows, np.arange(420), True)
    assert len(found.source.data["force"]) == 420


def test_what_was_looked_into_stays_when_the_end_is_drawn_again() -> None:
    found, rows = followed(LONG, 64)[0], columns(LONG)
    found.look("time_ms", 100.0, 110.0)
    looked = found.source.data
    found.update(rows, np.arange(LONG), True)
    assert found.source.data is looked
