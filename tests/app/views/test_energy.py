"""The energy tab: terms that add up to the work, in a unit that can be read."""

from __future__ import annotations

import numpy as np
import pytest

from app.runner import Run
from app.views.energy import EnergyView, joules


@pytest.mark.parametrize(
    ("value", "text"),
    [(3.2e-3, "3.20 mJ"), (0.0, "0 J"), (-2.41, "−2.41 J"), (4.56e-7, "456 nJ"), (1e-25, "0 J")],
)
def test_energies_have_three_digits_and_a_prefix(value: float, text: str) -> None:
    assert joules(value) == text


def test_before_a_run_it_says_what_will_be_there() -> None:
    view = EnergyView()
    view.show(None)
    assert "Press Run" in view.reading.sentence


def test_areas_end_at_the_work_of_the_drive(pulled: Run) -> None:
    view = EnergyView()
    view.show(pulled)
    *areas, work = view.reading.plots["account"]
    assert {area.label for area in areas} == {"tread", "springs", "releases", "time steps"}
    thickness = sum(area.columns()["y"] - area.columns()["y2"] for area in areas)
    np.testing.assert_allclose(thickness, work.columns()["y"], atol=1e-6)
    assert not view.reading.bad
    assert "which is rounding" in view.reading.sentence
    assert "was lost as bonds broke" in view.reading.sentence
    assert view.reading.figures["Missing"] == "rounding"


def test_a_tread_that_makes_energy_is_bad_news(wild: Run) -> None:
    view = EnergyView()
    view.show(wild)
    assert view.reading.bad
    assert "which no tread can" in view.reading.sentence
    results, still = wild.results(), wild.baseline
    assert results is not None
    assert still is not None
    *_, work = view.reading.plots["account"]
    each = {line.label: line.columns()["y"] for line in view.reading.plots["each"]}
    assert each["tread"].min() < 0
    assert work.label == "work done"


def test_without_a_quasi_static_run_all_of_a_wild_one_is_shown(wild: Run) -> None:
    view = EnergyView()
    view.show(wild)
    assert view.reading.plots["account"].opts.get("plot").kwargs["ylim"] != (None, None)
    assert "as high as a run that goes well" in view.reading.sentence
    wild._computation.baseline = None
    view = EnergyView()
    view.show(wild)
    assert view.reading.plots["account"].opts.get("plot").kwargs["ylim"] == (None, None)
    assert "which no tread can" in view.reading.sentence
    assert "as high as a run that goes well" not in view.reading.sentence
