"""Panel keeps global state: every test of the page starts and ends with none."""

from __future__ import annotations

from collections.abc import Iterator

import panel as pn
import pytest

from app.runner import Run
from tyrecontact import Scenario


@pytest.fixture(autouse=True)
def _fresh_panel_state() -> Iterator[None]:
    pn.state.reset()
    yield
    pn.state.reset()


@pytest.fixture
def small() -> Scenario:
    """A road of 6 x 6 elements, 52 steps: a run of a tenth of a second."""
    return Scenario(
        road={"elements": 6, "size": 6e-3, "pixel": 5e-5},
        loading={"max_indentation": 100e-6, "rate": 0.1},
        numerics={"lags": 32},
    )


@pytest.fixture
def finished(small: Scenario) -> Run:
    """A run of the small scenario that has come to its end."""
    run = Run(small)
    run.start()
    assert run.join(60)
    return run
