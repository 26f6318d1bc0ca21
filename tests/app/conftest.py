"""Panel keeps global state: every test of the page starts and ends with none."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator

import panel as pn
import pytest

from app.runner import Run
from app.session import Session
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


@pytest.fixture
def wait_for() -> Callable[[Callable[[], bool]], None]:
    """Wait until something is so; what should come at once and does not is given a minute."""

    def wait(condition: Callable[[], bool], seconds: float = 60.0) -> None:
        limit = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < limit, "waited too long"
            time.sleep(0.002)

    return wait


@pytest.fixture
def session(small: Scenario) -> Session:
    made = Session()
    made.controls.load("default", small)
    made.whatif.pace.value = "as fast as it can"
    return made
