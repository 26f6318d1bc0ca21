"""Small runs whose curves the tabs show: one that is pulled off, one that blows up."""

from __future__ import annotations

import pytest

from app.runner import Run
from tyrecontact import Scenario


def completed(scenario: Scenario) -> Run:
    run = Run(scenario)
    run.start()
    assert run.join(60)
    return run


@pytest.fixture
def pulled(small: Scenario) -> Run:
    """Pressed in, held, and pulled off until it parts."""
    small.loading.param.update(
        profile="load-hold-unload", max_indentation=60e-6, hold_time=1e-3, unloading_rate=0.05,
        retraction=0.2e-3,
    )  # fmt: skip
    small.adhesion.release_force = 0.1
    return completed(small)


@pytest.fixture
def wild(small: Scenario) -> Run:
    """The thesis' method on a road that is too stiff for it."""
    small.loading.max_indentation = 200e-6
    small.numerics.param.update(
        kernel="band-limited", solver="thesis", max_iterations=10, initial_guess="last"
    )
    return completed(small)
