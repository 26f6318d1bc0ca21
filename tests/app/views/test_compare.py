"""The tab Compare: an empty state, tables, overlays, differences, and what can be done."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from app.pinned import Pinned
from app.runner import Run
from app.shelf import Shelf
from app.views.compare import CompareView
from app.views.compare_plots import DEPTH, TIME, plots
from app.views.force import ForceView
from app.views.pinned import PinnedCurves, entries
from app.views.style import HALL, Horizontal
from tyrecontact import Scenario

_BY_DEPTH = Horizontal("indentation_um", "Indentation [µm]", (0, 100))
_BY_TIME = Horizontal("time_ms", "Time [ms]", (0, 1))
_ALL = ["force", "iterations", "stiffness", "newton", "percent"]


@pytest.fixture
def softer(small: Scenario) -> Run:
    """The finished run, but with softer springs."""
    scenario = small.copy()
    scenario.springs.youngs_modulus = 8e6
    run = Run(scenario)
    run.start()
    assert run.join(60)
    return run


@pytest.fixture
def pair(finished: Run, softer: Run) -> Shelf:
    shelf = Shelf()
    shelf.pin(finished, "first")
    shelf.pin(softer, "softer")
    return shelf


def _wild(pin: Pinned) -> Pinned:
    """Steps fail from the middle on, and the force swings a hundred times too far."""
    columns = pin.results.columns
    half = pin.steps // 2
    columns["converged"][half:] = 0
    columns["contact_force"][half:] *= 100 * (-1.0) ** np.arange(pin.steps - half)
    return pin


def test_nothing_is_made_before_it_is_needed() -> None:
    view = CompareView(Shelf())
    assert view.controls is None
    view.show(None)
    assert "Pin a run to compare" in view.words.object
    assert view.controls is None
    assert not view.drawn.elements


def test_the_run_on_show_is_pinned_by_a_click(finished: Run) -> None:
    shelf = Shelf()
    view = CompareView(shelf)
    view.show(finished)
    assert view.controls is not None
    assert not view.controls.pin.disabled
    assert view.controls.unpin.disabled
    assert not view.controls.chosen.visible  # an empty choice says nothing
    view.controls.pin.clicks += 1
    (pin,) = shelf.pinned
    assert f"Pinned as “{pin.label}”. 1 of 8 places" in view.words.object
    assert view.controls.label.value == pin.label
    assert list(view.drawn.elements) == _ALL[:3]
    assert "What differs" not in view.tables.object


def test_two_runs_are_compared(pair: Shelf) -> None:
    view = CompareView(pair)
    view.show(None)
    assert list(view.drawn.elements) == _ALL
    assert "Springs: Young&#x27;s modulus" in view.tables.object
    assert "8 MPa" in view.tables.object
    assert view.tables.object.count("<table>") == 2
    assert view.tables.object.count('tabindex="0"') == 2
    assert "differences are from “first”" in view.words.object
    view.controls.reference.value = "softer"
    assert "differences are from “softer”" in view.words.object


def test_a_softer_road_needs_less_force(pair: Shelf) -> None:
    found = plots(pair.pinned, DEPTH, "first")
    (newton,), (percent,) = found.elements["newton"], found.elements["percent"]
    assert newton.label == "softer"
    excess, share = newton.dimension_values(1), percent.dimension_values(1)
    assert excess[-1] < 0
    force = pair.pinned[0].results.contact_force[-1]
    assert share[-1] == pytest.approx(100 * excess[-1] / force, rel=1e-6)
    assert np.isnan(share[0])


def test_force_and_iterations_go_by_time_or_indentation(pair: Shelf) -> None:
    results = pair.pinned[0].results
    by_time = plots(pair.pinned, TIME).elements["force"].values()[0]
    assert by_time.dimension_values(0)[-1] == pytest.approx(results.time[-1] * 1e3)
    by_depth = plots(pair.pinned, DEPTH).elements["force"].values()[0]
    assert by_depth.dimension_values(0)[-1] == pytest.approx(results.indentation[-1] * 1e6)


def test_a_run_that_goes_wild_squashes_no_other(pair: Shelf) -> None:
    sound, wild = pair.pinned[0], _wild(pair.pinned[1])
    found = plots([sound, wild], DEPTH, sound.label)
    assert found.cut["force"] == ["softer"]
    force = found.elements["force"]
    assert [curve.label for curve in force] == ["softer", "first"]  # the sound one in front
    low, high = force.opts.get("plot").kwargs["ylim"]
    assert low > -sound.results.contact_force.max()
    assert high < 1.5 * sound.results.contact_force.max()
    view = CompareView(pair)
    view.show(None)
    assert "“softer”: cut off at the frame" in view.words.object


def test_what_is_redrawn_is_drawn_in_place(pair: Shelf, finished: Run) -> None:
    view = CompareView(pair)
    view.show(finished)
    places, drawn = list(view._grid.objects), view.drawn
    view.show(finished)
    assert view.drawn is drawn
    view.controls.axis.value = TIME
    assert view.drawn is not drawn
    assert all(a is b for a, b in zip(view._grid.objects, places, strict=True))
    view.show(finished, HALL)
    assert f"font-size:{HALL.title}px" in view.words.object
    assert view._grid.objects[0] is not places[0]


def test_runs_are_renamed_and_unpinned(pair: Shelf) -> None:
    view = CompareView(pair)
    view.show(None)
    controls = view.controls
    controls.chosen.value = "softer"
    assert controls.label.value == "softer"
    controls.label.value = "first"
    controls.rename.clicks += 1
    assert "Not done: label must be unlike" in view.words.object
    controls.label.value = "8 MPa <b>"
    controls.rename.clicks += 1
    assert pair.pinned[1].label == "8 MPa <b>"
    assert controls.chosen.value == "8 MPa <b>"
    assert "8 MPa &lt;b&gt;" in view.tables.object
    controls.unpin.clicks += 1
    controls.unpin.clicks += 1
    assert pair.pinned == ()
    assert "Pin a run to compare" in view.words.object
    assert not view._grid.objects


def test_pins_of_others_are_seen_at_once(finished: Run, softer: Run) -> None:
    shelf = Shelf()
    view = CompareView(shelf)
    view.show(finished)
    shelf.pin(softer, "of a lesson")
    assert [run.label for run in view.runs] == ["of a lesson", "this run"]


def test_a_run_under_way_is_not_drawn_at_every_call(
    pair: Shelf, small: Scenario, wait_for: Callable
) -> None:
    small.loading.rate = 0.05
    run = Run(small, duration=20.0)
    run.start()
    wait_for(lambda: run.record is not None and run.record.count > 2)
    view = CompareView(pair)
    view.show(run)
    drawn, count = view.drawn, run.record.count
    wait_for(lambda: run.record.count > count)
    view._due = float("inf")
    view.show(run)
    assert view.drawn is drawn
    run.stop()
    assert run.join(60)
    view.show(run)
    assert view.drawn is not drawn
    assert "ended after" in view.words.object


def test_pinned_runs_stand_behind_the_live_one(pair: Shelf) -> None:
    force = ForceView()
    curves = PinnedCurves(force.root)
    curves.show(pair.pinned, _BY_DEPTH)
    looks = {(line.glyph.line_color, str(line.glyph.line_dash)) for line in curves.renderers}
    assert len(looks) == 2
    data = curves.renderers[0].data_source.data
    assert np.array_equal(data["force"], pair.pinned[0].results.contact_force)
    assert data["indentation_um"][-1] == pytest.approx(100, rel=0.05)
    curves.show(pair.pinned, _BY_TIME)
    assert {line.glyph.x for line in curves.renderers} == {"time_ms"}
    kept = curves.renderers[0].data_source.data
    pair.rename("first", "1st")
    curves.show(pair.pinned, _BY_TIME)
    assert curves.renderers[0].data_source.data is kept
    assert [entry.label for entry in entries(pair.pinned)] == ["1st", "softer"]
    curves.show([], _BY_TIME)
    assert not any(line.visible for line in curves.renderers)
    curves.enlarge(HALL)
    assert curves.renderers[0].glyph.line_width == pytest.approx(1.4 * HALL.line)
