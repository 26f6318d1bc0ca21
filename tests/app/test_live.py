"""The live plots without a run."""

from __future__ import annotations

from app.live import Live
from app.shelf import Shelf


def test_the_empty_plots_obey_the_choice_of_the_axis() -> None:
    live = Live(Shelf(), lambda: None)
    live.axis.value = "time"
    for view in (live.force, live.iterations):
        assert view.root.xaxis[0].axis_label == "Time [ms]"
        assert (view.root.x_range.start, view.root.x_range.end) == (0.0, 10.0)
