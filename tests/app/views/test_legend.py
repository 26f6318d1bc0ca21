"""The legend of the live plots."""

from __future__ import annotations

from app.views.legend import Entry, LegendView
from app.views.style import HALL, RUN_COLOR


def test_failed_steps_and_pinned_runs_come_and_go() -> None:
    view = LegendView()
    labels = [entry.label for entry in view.entries]
    view.show_failed(True)
    view.show_pinned([Entry("factor 2", "#009E73", 2.0, "4 2")])
    assert [entry.label for entry in view.entries] == [*labels, "not converged", "factor 2"]
    assert 'stroke-dasharray="4 2"' in view.root.object
    view.show_failed(False)
    view.show_pinned([])
    assert [entry.label for entry in view.entries] == labels


def test_the_run_has_the_colour_of_its_line_in_either_theme() -> None:
    view = LegendView()
    view.darken(True)
    assert RUN_COLOR[True] in view.root.object
    view.enlarge(HALL)
    assert f"{HALL.label}px" in view.root.object


def test_a_label_cannot_carry_markup() -> None:
    view = LegendView()
    view.show_pinned([Entry("<script>", "#000000")])
    assert "<script>" not in view.root.object
