"""The tab Inputs, before a run, with one, and when settings are refused."""

from __future__ import annotations

import threading

import panel as pn

from app.runner import Phase, Run
from app.views.inputs import EMPTY, PARTS, InputsView
from app.views.style import HALL
from tyrecontact import Scenario


def _settle(view: InputsView) -> None:
    """Wait for the thread and take what it has made, as the event loop does."""
    assert view.worker.join(60)
    view.arrive()


def test_before_anything_a_sentence_says_what_will_be_there() -> None:
    view = InputsView()
    view.show(None)
    assert EMPTY in view.text.object
    assert not view.plots.objects
    assert view.choice.options == list(PARTS) == ["Road", "Springs", "Kernel", "Loading"]


def test_a_scenario_is_prepared_on_a_thread_part_by_part(small: Scenario) -> None:
    view = InputsView()
    view.show_scenario(small)
    assert "Preparing the road …" in view.text.object
    for name, plots in (("Road", 2), ("Springs", 3), ("Kernel", 4), ("Loading", 2)):
        view.choice.value = name
        _settle(view)
        assert len(view.plots) == plots
        assert "Preparing" not in view.text.object
        assert "(thesis, " in view.text.object
    view.choice.value = "Road"  # at once: it is there
    assert len(view.plots) == 2
    view.close()


def test_what_is_drawn_is_not_drawn_again(finished: Run) -> None:
    view = InputsView()
    view.show(finished)
    _settle(view)
    first = list(view.plots)
    view.show(finished)
    view.show_scenario(finished.scenario)
    assert list(view.plots) == first
    view.show(finished, HALL)
    assert list(view.plots) != first
    assert f"font-size:{HALL.label + 1}px" in view.text.object
    view.close()


def test_a_run_is_shown_with_what_it_was_made_of(finished: Run, small: Scenario) -> None:
    view = InputsView()
    view.show(finished)
    _settle(view)
    assert finished.simulation is not None
    assert "seed 1<" in view.text.object
    small.road.seed = 2
    view.show_scenario(small)
    # the old road stays until the new one is there, and that is said
    assert "Below is what it was before the change" in view.text.object
    assert len(view.plots) == 2
    _settle(view)
    assert "seed 2<" in view.text.object
    view.close()


def test_a_later_scenario_takes_the_place_of_the_one_before(small: Scenario) -> None:
    view = InputsView()
    for seed in (5, 6, 7):
        small.road.seed = seed
        view.show_scenario(small)
    _settle(view)
    assert "seed 7<" in view.text.object
    view.close()


def test_what_is_refused_is_said_in_a_sentence(small: Scenario) -> None:
    small.road.pixel = 1e-3
    view = InputsView()
    view.show_scenario(small)
    _settle(view)
    assert "Cannot be shown: pitch must give at least 4 heights" in view.text.object
    assert not view.plots.objects
    run = Run(small)
    run.start()
    assert run.join(60)
    assert run.phase is Phase.REFUSED
    view.show(run)
    assert "Cannot be shown: pitch" in view.text.object
    view.close()


def test_a_run_that_is_being_prepared_is_waited_for(small: Scenario) -> None:
    view = InputsView()
    run = Run(small)
    view.show(run)
    assert "Preparing road, springs and kernel …" in view.text.object
    run.start()
    assert run.join(60)
    view.show(run)
    _settle(view)
    assert len(view.plots) == 2
    view.close()


def test_after_the_close_nothing_arrives(small: Scenario) -> None:
    view = InputsView()
    view.show_scenario(small)
    view.close()
    _settle(view)
    assert not view.plots.objects
    assert not view.worker.take()


class _Document:
    """Keeps what is to be called on the next tick."""

    def __init__(self) -> None:
        self.ticks: list = []

    def add_next_tick_callback(self, callback: object) -> None:
        self.ticks.append(callback)


def test_the_page_is_told_through_its_document_and_drawn_a_plot_a_tick(small: Scenario) -> None:
    document = _Document()
    view = InputsView()
    view._document = document
    view.show_scenario(small)
    assert view.worker.join(60)
    seen = []
    while document.ticks:
        document.ticks.pop(0)()
        seen.append(len(view.plots))
    assert seen == [1, 2]
    view.close()


def test_it_is_cheap_to_make() -> None:
    threads = threading.active_count()
    view = InputsView()
    assert threading.active_count() == threads
    assert not view.root.select(pn.pane.HoloViews)
    assert len(view.root.select()) == 4  # itself, choice, text and the room for plots
