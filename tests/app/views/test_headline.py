"""The headline without a browser: figures with units, progress, one sentence."""

from __future__ import annotations

from app.plain_words import three_digits
from app.runner import Run
from app.views.headline import HeadlineView


def test_the_headline_gives_figures_with_units_and_a_sentence(finished: Run) -> None:
    view = HeadlineView()
    assert "Run" in view.sentence
    view.update(finished)
    results = finished.results()
    assert view.figures["Peak force"] == (three_digits(results.contact_force.max()), "N")
    assert view.figures["Indentation"] == ("100.0", "µm")
    assert view.figures["Contacts"][1] == "of 36"
    assert view.figures["Final stiffness"][1] == "MN/m"
    assert view.sentence == f"Complete, {len(results)} steps: all converged."
    assert view.root.state["progress"] == 1.0
    assert view.root.state["ended"]


def test_what_was_refused_stays_until_something_is_accepted(finished: Run) -> None:
    view = HeadlineView()
    view.refuse("pitch must be given")
    assert view.notice == "Not accepted: pitch must be given."
    view.update(finished)
    assert view.root.state["notice"] == view.notice
    assert view.sentence.startswith("Complete")
    view.accept()
    assert view.root.state["notice"] == ""
    assert view.figures["Peak force"][0] != "–"
