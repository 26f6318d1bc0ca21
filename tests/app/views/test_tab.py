"""What all tabs do alike: nothing twice, in place, and a sentence where there is nothing to see."""

from __future__ import annotations

import gc
import time
import weakref

import panel as pn
from bokeh.models import Legend
from bokeh.plotting import figure

from app.runner import Phase, Run
from app.views.energy import EnergyView
from app.views.release import ReleaseView
from app.views.stiffness import StiffnessView
from app.views.style import DESK, HALL
from app.views.tab import TabView
from tyrecontact import Scenario

ALL = (StiffnessView, ReleaseView, EnergyView)


def panes(view: TabView) -> list[pn.viewable.Viewable]:
    return list(view.root[1])


def test_a_run_that_was_refused_is_told_with_its_reason(small: Scenario) -> None:
    small.road.file = "nowhere.txt"
    run = Run(small)
    run.start()
    assert run.join(60)
    for made in ALL:
        view = made()
        view.show(run)
        assert "was refused, road file must be readable" in view.reading.sentence
        assert view.reading.bad
        assert not panes(view)


def test_a_run_of_few_steps_is_told_as_far_as_it_goes(small: Scenario) -> None:
    run = Run(small, paused=True)
    run.start()
    for _ in range(2):
        run.step()
    while run.record is None or run.record.count < 2:
        time.sleep(0.005)
    run.stop()
    assert run.join(30)
    for view in (made() for made in ALL):
        view.show(run)
        assert view.reading.sentence
        view.root.get_root()


def test_a_tab_keeps_no_run_alive(small: Scenario) -> None:
    run = Run(small)
    run.start()
    assert run.join(60)
    views = [made() for made in ALL]
    for view in views:
        view.show(run)
    gone = weakref.ref(run)
    del run
    gc.collect()
    assert gone() is None
    assert all(view.reading.plots for view in views)


def test_a_run_that_was_stopped_before_its_first_step_says_so(small: Scenario) -> None:
    run = Run(small, paused=True)
    run.start()
    while run.record is None:
        time.sleep(0.005)
    run.stop()
    assert run.join(30)
    for view in (made() for made in ALL):
        view.show(run)
        assert "stopped before its first step" in view.reading.sentence


def test_the_same_is_not_drawn_twice_and_new_data_come_in_place(finished: Run) -> None:
    view = EnergyView()
    view.show(finished)
    reading, before = view.reading, panes(view)
    view.show(finished)
    assert view.reading is reading
    other = Run(finished.scenario)
    other.start()
    assert other.join(60)
    view.show(other)
    assert view.reading is not reading
    assert panes(view) == before
    view.show(other, HALL)
    assert panes(view) != before
    view.show(None)
    assert not panes(view)


def test_a_run_under_way_is_not_drawn_more_often_than_can_be_afforded(finished: Run) -> None:
    view = EnergyView()
    finished.phase = Phase.RUNNING
    view.show(finished)
    reading = view.reading
    view._shown = (weakref.ref(finished), 1, Phase.RUNNING, DESK)
    view.show(finished)
    assert view.reading is reading
    finished.phase = Phase.FINISHED
    view.show(finished)
    assert view.reading is not reading


def test_type_is_as_large_as_asked_for_and_stays_so(pulled: Run) -> None:
    view = StiffnessView()
    view.show(pulled, HALL)
    model = view.root.get_root()
    figures = list(model.select({"type": figure}))
    assert len(figures) == 4
    for fig in figures:
        assert fig.title.text_font_size == f"{HALL.title}px"
        assert fig.title.js_property_callbacks["change:text_font_size"]
        assert all(axis.axis_label_text_font_size == f"{HALL.label}px" for axis in fig.axis)
        for legend in fig.select({"type": Legend}):
            assert legend.label_text_font_size == f"{HALL.label}px"
