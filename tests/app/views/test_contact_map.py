"""The contact map without a browser: fed with a run, and what it would draw is read."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bokeh.events import Tap

from app.runner import Run
from app.views.contact_map import ContactMapView
from app.views.map_modes import MODES, STATES
from app.views.style import DESK, HALL
from tyrecontact import Scenario
from tyrecontact.contact.bonds import ElementState
from tyrecontact.errors import InputError


@pytest.fixture
def view(finished: Run) -> ContactMapView:
    """The map of a run of 6 x 6 elements of 1 mm, of whose force 2.5 N are expected."""
    made = ContactMapView()
    made.reset(6e-3, 6, 2.5)
    return made


def show_last(view: ContactMapView, run: Run) -> None:
    assert run.record is not None
    assert run.simulation is not None
    view.show(run.record, run.record.count - 1, run.simulation.kernel.spacing)


def pull(run: Run, row: int, column: int, force: float, step: int = -1) -> None:
    """Put an element in tension."""
    assert run.record is not None
    columns = run.record.columns
    columns["state"][step, row, column] = ElementState.TENSION
    columns["element_force"][step, row, column] = -force


def drawn(view: ContactMapView, name: str = "value") -> np.ndarray:
    return np.asarray(view.drawing.image.data[name][0])


def test_pressed_and_pulled_elements_are_coloured_and_the_pulled_ones_marked(
    finished: Run, view: ContactMapView
) -> None:
    pull(finished, 2, 4, 0.25)
    finished.record.columns["state"][-1, 5, 1] = ElementState.RELEASED
    show_last(view, finished)
    state, force = (finished.record.columns[name][-1] for name in ("state", "element_force"))
    known = np.isin(state, (ElementState.COMPRESSED, ElementState.TENSION))
    np.testing.assert_array_equal(np.isfinite(drawn(view)), known)
    np.testing.assert_allclose(drawn(view)[known], force[known], rtol=1e-6)
    assert view.drawing.image.data["side"] == [pytest.approx(6.0)]
    # row is y, column is x
    marks = view.drawing.marks.data
    np.testing.assert_allclose(marks["x"], [4.5, 1.5])
    np.testing.assert_allclose(marks["y"], [2.5, 5.5])
    assert marks["marker"] == ["inverted_triangle", "circle_x"]
    view.show_mode("age")
    assert view.drawing.marks.data["x"] == []


def test_a_small_pull_is_seen_beside_a_big_push(finished: Run, view: ContactMapView) -> None:
    show_last(view, finished)
    assert view.drawing.mapper.low == 0
    unsigned = view.drawing.mapper.palette
    pull(finished, 2, 4, 0.06)
    view.show(finished.record, 10, 1e-3)
    show_last(view, finished)
    assert view.drawing.mapper.low == -1
    assert view.drawing.mapper.palette != unsigned
    assert view.scale.low == pytest.approx(-0.1)  # 1.5 times that, as a short number: 0.09
    assert drawn(view, "shown")[2, 4] == pytest.approx(-0.6)
    labels = view.drawing.bar.major_label_overrides
    assert labels == {-1: "−0.1", -0.5: "−0.05", 0: "0", 0.5: "1.5", 1: "3"}


def test_the_limits_of_a_run_hold_and_what_is_beyond_is_counted(
    finished: Run, view: ContactMapView
) -> None:
    assert view.scale.high == 3.0
    finished.record.columns["element_force"][-1, 1, 1] = 50.0
    show_last(view, finished)
    assert view.scale.high == 3.0
    assert "1 beyond scale" in view.root.title.text
    assert drawn(view, "shown")[1, 1] > view.drawing.mapper.high


def test_without_an_expected_force_limits_grow_in_leaps_and_never_shrink(finished: Run) -> None:
    view, limits = ContactMapView(), []
    view.reset(6e-3, 6, None)
    for step in range(finished.record.count):
        view.show(finished.record, step, 1e-3)
        limits.append(view.scale.high)
    largest = finished.record.columns["element_force"].max()
    assert np.all(np.diff(limits) >= 0)
    assert largest <= limits[-1] <= 2 * largest
    assert len(set(limits)) < 20
    view.show(finished.record, 0, 1e-3)
    assert view.scale.high == limits[-1]
    view.expect(10 * largest)  # the quasi-static run has come late
    assert view.scale.fixed
    assert 10 * largest <= view.scale.high <= 20 * largest
    view.clear()
    assert view.scale.high == 0


@pytest.mark.parametrize("name", list(MODES))
def test_every_mode_draws_its_quantity_in_its_unit(
    finished: Run, view: ContactMapView, name: str
) -> None:
    show_last(view, finished)
    view.show_mode(name)
    fields = finished.record.fields(-1)[1]
    touching = fields["state"] == ElementState.COMPRESSED
    expected = {
        "force": fields["element_force"],
        "compression": fields["compression"] * 1e6,
        "displacement": fields["displacement"] * 1e6,
        "age": fields["age"] * 1e3,
        "contact area": fields["contact_area"] * 1e8,  # of 1 mm2, in %
    }
    assert touching.any()
    if name == "state":
        np.testing.assert_array_equal(drawn(view, "shown"), fields["state"])
        assert list(view.drawing.bar.major_label_overrides.values()) == list(STATES)
    else:
        np.testing.assert_allclose(drawn(view)[touching], expected[name][touching], rtol=1e-5)
        assert np.nanmax(drawn(view, "shown")) <= 1
    assert view.root.title.text.startswith(f"{MODES[name].title}, step 52, ")
    assert view.drawing.unit == MODES[name].unit


def test_a_mode_chosen_later_has_the_limits_of_the_whole_run(
    finished: Run, view: ContactMapView
) -> None:
    view.show(finished.record, 5, 1e-3)
    view.show_mode("compression")
    highest = finished.record.columns["compression"].max() * 1e6
    assert highest <= view.scale.high <= 1.3 * highest
    limits = view.scale
    show_last(view, finished)
    assert view.scale == limits
    with pytest.raises(InputError, match="did you mean 'force'"):
        view.show_mode("forces")


def test_nothing_is_sent_twice(finished: Run, view: ContactMapView) -> None:
    show_last(view, finished)
    sent: list[str] = []
    for model in (view.drawing.image, view.drawing.marks):
        model.on_change("data", lambda attr, old, new: sent.append(attr))
    show_last(view, finished)
    assert sent == []
    view.show(finished.record, 20, 1e-3)
    assert sent == ["data"]


def test_a_tap_tells_row_and_column(finished: Run, view: ContactMapView) -> None:
    taps: list[tuple[int, int]] = []
    view.on_tap = lambda row, column: taps.append((row, column))
    tap = [
        Tap(view.root, x=x, y=y)
        for x, y in ((4.2, 0.3), (6.1, 2.0), (1.0, -0.2), (math.nan, 1.0), (None, 1.0))
    ]
    view._tapped(tap[0])
    assert taps == []  # there is nothing yet
    show_last(view, finished)
    for event in tap:
        view._tapped(event)
    assert taps == [(0, 4)]


def test_the_followed_element_is_framed(view: ContactMapView) -> None:
    view.follow(2, 4)
    frame = view.drawing.frame.data
    assert (frame["x"], frame["y"], frame["side"]) == ([4.5], [2.5], [1.0])
    view.reset(6e-3, 4, None)
    assert view.drawing.frame.data["x"] == []  # there is no such element any more
    view.follow(2, 3)
    view.forget()
    assert view.drawing.frame.data["x"] == []


def test_in_the_lecture_hall_type_is_larger(view: ContactMapView) -> None:
    desk = view.root.aspect_ratio
    view.enlarge(HALL)
    assert view.root.title.text_font_size == f"{HALL.title}px"
    assert view.drawing.bar.major_label_text_font_size == f"{HALL.tick}px"
    view.enlarge(DESK)
    assert view.root.aspect_ratio == desk


def test_a_large_title_has_two_lines_so_that_it_is_not_cut(
    view: ContactMapView, finished: Run
) -> None:
    show_last(view, finished)
    view.enlarge(HALL)
    assert view.root.title.text.startswith("Force [N]\nstep 52, ")
    view.show_mode("age")
    assert view.root.title.text.startswith("Time in contact [ms]\nstep 52, ")
    view.clear()
    assert view.root.title.text.split("\n") == ["Time in contact [ms]", " "]
    view.enlarge(DESK)
    assert view.root.title.text == "Time in contact [ms]"


def test_the_map_shows_the_nearest_step_whose_fields_are_kept(small: Scenario) -> None:
    small.numerics.field_memory = 10 * 36 * 33.0  # of 52 steps
    run = Run(small)
    run.start()
    assert run.join(60)
    view, record = ContactMapView(), run.record
    view.reset(6e-3, 6, 2.5)
    whole = {step.index: step.element_force for step in run.simulation}
    assert record.field_stride == 8
    for step, shown in ((51, 51), (50, 51), (42, 40), (31, 32), (16, 16)):
        view.show(record, step, run.simulation.kernel.spacing)
        pressed = whole[shown] > 0
        assert pressed.any()
        np.testing.assert_allclose(drawn(view)[pressed], whole[shown][pressed], rtol=1e-6)
        assert np.isnan(drawn(view)[~pressed]).all()
        assert f"step {shown + 1}," in view.root.title.text
