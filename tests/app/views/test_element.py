"""The followed element without a browser: what its plots and its sentence say."""

from __future__ import annotations

import numpy as np
import pytest

from app.runner import Run
from app.views.element import ElementView
from app.views.element_words import INVITATION, say
from app.views.style import DESK, HALL, horizontal
from tyrecontact import Scenario
from tyrecontact.contact.bonds import ElementState

ROW, COLUMN = 2, 3


@pytest.fixture
def view(finished: Run) -> ElementView:
    """A view that follows an element of a run that has ended."""
    made = ElementView()
    made.prepare(finished)
    made.update(finished, finished.record.count - 1, ended=True)
    made.follow(ROW, COLUMN)
    return made


def hardest(run: Run, step: int = -1) -> tuple[int, int]:
    force = run.record.fields(step)[1]["element_force"]
    return divmod(int(force.argmax()), force.shape[1])


def test_nothing_is_made_before_an_element_is_followed(finished: Run) -> None:
    view = ElementView()
    assert view.sentence == INVITATION
    view.prepare(finished)
    view.update(finished, 3, ended=False)
    assert (view.element, view.forces, view.chooser) == (None, None, None)
    assert len(view.root) == 2  # words, and the offer to choose


def test_history_and_working_point_are_those_of_the_element(
    finished: Run, view: ElementView
) -> None:
    columns = finished.record.columns
    force = columns["element_force"][:, ROW, COLUMN]
    path = view.forces.path.data
    np.testing.assert_array_equal(path["force"], force)
    np.testing.assert_allclose(path["time_ms"], columns["time"] * 1e3)
    view.update(finished, 20, ended=True)
    now = view.forces.now.data
    assert now["force"] == [force[20]]
    assert now["indentation_um"][0] == pytest.approx(columns["indentation"][20] * 1e6)


def test_the_working_point_lies_on_the_spring(finished: Run, view: ElementView) -> None:
    view.follow(*hardest(finished))
    now, curve = view.forces.now.data, view.forces.curve.data
    expected = np.interp(now["compression_um"][0], curve["compression_um"], curve["force"])
    assert now["force"][0] == pytest.approx(expected, rel=2e-3)
    assert view.forces.spring.x_range.end > now["compression_um"][0]
    assert view.forces.history.y_range.end > now["force"][0]
    # what is apart has no place on it
    apart = finished.record.columns["compression"][:, ROW, COLUMN] < 0
    view.follow(ROW, COLUMN)
    assert apart[0]
    np.testing.assert_array_equal(np.isnan(view.forces.path.data["compression_um"]), apart)


def test_the_bond_is_drawn_as_far_as_its_law_has_one(small: Scenario) -> None:
    for law, release, limit, dashed in (
        ("release-force", 0.02, 0.02, True),
        ("hysteresis", 0.02, 0.02, False),
        ("multiplicative", 0.02, None, True),
        ("release-force", 0.0, None, False),
    ):
        small.adhesion.param.update(law=law, release_force=release, table_step=0.0)
        run = Run(small)
        run.start()
        assert run.join(60)
        # one that pulls, whatever the law made of it
        run.record.columns["element_force"][-1, ROW, COLUMN] = -0.01
        run.record.columns["compression"][-1, ROW, COLUMN] = -1e-6
        view = ElementView()
        view.prepare(run)
        view.update(run, run.record.count - 1, ended=True)
        view.follow(ROW, COLUMN)
        assert view.forces.limit.visible is (limit is not None)
        if limit is not None:
            assert view.forces.limit.location == -limit
            assert view.forces.history.y_range.start < -limit
        assert (len(view.forces.bond.data["force"]) > 0) is dashed


def test_what_touches_is_as_much_as_the_contact_area_says(finished: Run, view: ElementView) -> None:
    row, column = hardest(finished)
    view.follow(row, column)
    heights = finished.simulation.patch.heights.reshape(6, 20, 6, 20)[row, :, column]
    below_top = (heights - heights.max()) * 1e6
    np.testing.assert_allclose(view.heights.heights.data["height"][0], below_top, atol=1e-4)
    fields = finished.record.fields(-1)[1]
    share = fields["contact_area"][row, column] / 1e-6
    touching = view.heights.touching.data["height"][0]
    assert touching.mean() == pytest.approx(share, abs=1.01 / touching.size)
    # the highest ones: those that the road has pressed in; the table of radii is interpolated
    depth = fields["compression"][row, column] * 1e6
    assert np.count_nonzero((touching == 1) != (below_top > -depth)) <= 1
    assert view.heights.heights.data["x"] == [pytest.approx(column)]


def test_heights_are_sent_again_only_where_other_ones_touch(
    finished: Run, view: ElementView
) -> None:
    view.follow(*hardest(finished))
    sent: list[str] = []
    view.heights.touching.on_change("data", lambda attr, old, new: sent.append(attr))
    view.heights.heights.on_change("data", lambda attr, old, new: sent.append("heights"))
    view.update(finished, 51, ended=True)
    assert sent == []
    view.update(finished, 0, ended=True)
    view.update(finished, 1, ended=True)  # nothing touches in either
    assert sent == ["data"]
    assert view.heights.touching.data["height"][0].sum() == 0


def test_a_run_that_goes_on_is_followed_and_ranges_only_grow(finished: Run) -> None:
    view, ends, place = ElementView(), [], hardest(finished)
    whole = finished.record._now
    finished.record._now = type(whole)(0, whole.table)
    view.prepare(finished)
    view.follow(*place)
    for count in range(1, whole.count + 1):
        finished.record._now = type(whole)(count, whole.table, whole.last)
        view.update(finished, count - 1, ended=count == whole.count)
        if view.forces.path.data["force"][-1] > 0:
            ends.append(view.forces.history.y_range.end)
        assert len(view.forces.path.data["force"]) == count
    assert np.all(np.diff(ends) >= 0)
    assert len(set(ends)) < 20


def test_buttons_pick_the_element_that_stands_out(finished: Run, view: ElementView) -> None:
    followed: list[tuple[int, int]] = []
    view.on_follow = lambda row, column: followed.append((row, column))
    press, tension = view.chooser.buttons
    press.clicks += 1
    assert view.element == hardest(finished)
    tension.clicks += 1
    assert view.sentence == "No element is in tension at this step."
    finished.record.columns["state"][-1, 5, 1] = ElementState.TENSION
    finished.record.columns["element_force"][-1, 5, 1] = -0.3
    tension.clicks += 1
    assert view.element == (5, 1)
    assert followed == [hardest(finished), (5, 1)]


def test_row_and_column_are_chosen_by_keyboard_too(finished: Run, view: ElementView) -> None:
    assert (view.chooser.row.value, view.chooser.column.value) == (ROW, COLUMN)
    assert view.chooser.row.end == 5
    view.chooser.row.value = 4
    assert view.element == (4, COLUMN)
    view.follow(0, 1)
    assert (view.chooser.row.value, view.chooser.column.value) == (0, 1)
    empty = ElementView()
    empty.open()
    empty.chooser.buttons[0].clicks += 1
    assert empty.sentence.startswith("Press Run first")


def test_another_run_is_followed_on_where_it_has_the_element(
    finished: Run, view: ElementView, small: Scenario
) -> None:
    view.prepare(finished)
    assert view.element == (ROW, COLUMN)
    assert len(view.forces.path.data["force"]) == finished.record.count
    small.road.elements = 3
    smaller = Run(small)
    smaller.start()
    assert smaller.join(60)
    view.prepare(smaller)
    assert view.element is None
    assert view.sentence == INVITATION
    assert len(view.forces.path.data["force"]) == 0


def test_axis_type_and_theme_reach_plots_made_before_and_after(finished: Run) -> None:
    view, simulation = ElementView(), finished.simulation
    axis = horizontal("time", simulation.schedule.time, simulation.schedule.drive)
    view.show_against(axis)
    view.enlarge(HALL)
    view.darken(True)
    view.prepare(finished)
    view.follow(1, 1)
    assert view.forces.history.xaxis[0].axis_label == "Time [ms]"
    assert view.forces.spring.xaxis[0].axis_label == "Compression [µm]"
    assert view.forces.history.title.text_font_size == f"{HALL.title}px"
    dark = view.forces.path, view.forces._lines[0].glyph.line_color
    view.darken(False)
    assert view.forces._lines[0].glyph.line_color != dark[1]


@pytest.mark.parametrize(
    ("state", "force", "depth", "said"),
    [
        (ElementState.COMPRESSED, 1.234, 3.4e-6,
         "pressed with 1.23 N, compressed by 3.40 µm, in contact for 2.10 ms, "
         "38.0 % of its area touches"),
        (ElementState.TENSION, -0.31, -2e-6,
         "pulled with 0.310 N, drawn out by 2.00 µm, in contact for 2.10 ms, "
         "38.0 % of its area held by its bond"),
        (ElementState.TENSION, -0.31, 2e-6,
         "pulled with 0.310 N, still compressed by 2.00 µm, in contact for 2.10 ms, "
         "38.0 % of its area held by its bond"),
        (ElementState.APART, 0.0, -12.7e-6, "apart, 12.7 µm from touching"),
        (ElementState.APART, 0.0, 1e-6, "it carries no force, its dent has not recovered"),
        (ElementState.RELEASED, 0.0, 1e-6, "its bond broke in this step"),
    ],
)  # fmt: skip
def test_the_sentence_says_what_the_element_does(
    state: ElementState, force: float, depth: float, said: str
) -> None:
    values = {"state": state, "element_force": force, "compression": depth, "age": 2.1e-3,
              "contact_area": 0.38e-6}  # fmt: skip
    fields = {name: np.full((8, 13), value) for name, value in values.items()}
    assert say(7, 12, fields, 1e-6) == f"Element row 7, column 12: {said}."


def test_the_small_scale_is_a_square_whatever_the_size_of_type(view: ElementView) -> None:
    for size in (HALL, DESK):
        view.enlarge(size)
        assert view.heights.root.frame_width == view.heights.root.frame_height
    assert not view.heights.root.match_aspect  # a wider frame would show what is not there
