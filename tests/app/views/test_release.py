"""The release tab: counts that agree with the run, and how to get a release where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from app.runner import Run
from app.views.release import ReleaseView
from tyrecontact import Scenario
from tyrecontact.contact.bonds import ElementState


def test_before_a_run_it_says_how_to_see_one() -> None:
    view = ReleaseView()
    view.show(None)
    assert 'preset "adhesion"' in view.reading.sentence


def test_a_ramp_only_presses(finished: Run) -> None:
    view = ReleaseView()
    view.show(finished)
    assert "only presses" in view.reading.sentence
    assert 'preset "adhesion"' in view.reading.sentence
    assert list(view.reading.plots) == ["contacts"]


def test_without_adhesion_it_says_so(small: Scenario) -> None:
    small.adhesion.release_force = 0.0
    run = Run(small)
    run.start()
    assert run.join(60)
    view = ReleaseView()
    view.show(run)
    assert "0 N is no adhesion" in view.reading.sentence


def test_what_is_shown_is_what_broke(pulled: Run) -> None:
    view = ReleaseView()
    view.show(pulled)
    results = pulled.results()
    assert results is not None
    broken = int(results.releases.sum())
    assert broken > 0
    assert view.reading.figures["Bonds broken"] == str(broken)
    assert view.reading.figures["Largest event"] == f"{results.largest_avalanche} bonds"
    assert view.reading.sentence.startswith(f"{broken} bonds have broken")
    assert results.adherence_force is not None
    assert "Adherence force" in view.reading.figures
    stems, heads = view.reading.plots["steps"]
    assert stems.columns()["y"].sum() == heads.columns()["y"].sum() == broken
    (bars,) = view.reading.plots["sizes"]
    sizes, events = bars.columns()["x"], bars.columns()["y"]
    assert events.sum() == results.avalanches.size
    assert (sizes * events).sum() == pytest.approx(broken)


def test_elements_that_are_pulled_are_counted_from_the_maps(pulled: Run) -> None:
    view = ReleaseView()
    view.show(pulled)
    _, found, broken = view.reading.plots["contacts"]
    results = pulled.results()
    assert results is not None
    expected = (results.state == ElementState.TENSION).sum(axis=(1, 2))
    time = results.time * 1e3
    shown = np.searchsorted(time, found.columns()["x"] - 1e-9)
    np.testing.assert_array_equal(found.columns()["y"], expected[shown])
    assert found.columns()["y"].max() > 0
    assert broken.columns()["y"][-1] == results.releases.sum()
