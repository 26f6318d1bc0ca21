"""Shared by all tests: a cache of kernels of their own, and runs that are computed once."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import pytest
from xdist.remote import Producer
from xdist.scheduler import LoadFileScheduling

# before numpy comes: on matrices this small threads mostly wait for each other
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from tyrecontact import Results, Scenario, Simulation, presets
from tyrecontact.figures import FIGURES, Figure


class _Files(LoadFileScheduling):
    """A file stays in one process, which prepares what it needs once; so do all of the browser's
    files that share a server.
    """

    def _split_scope(self, nodeid: str) -> str:
        file: str = super()._split_scope(nodeid)
        alone = "/browser/" not in file or file.endswith("test_leaving.py")
        return file if alone else "browser"


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> LoadFileScheduling:
    return _Files(config, log)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The browser's tests first: they take longest."""
    items.sort(key=lambda item: "browser" not in item.path.parts)


@pytest.fixture(scope="session", autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """No test reads or writes the user's cache."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TYRECONTACT_CACHE", str(tmp_path_factory.mktemp("kernels")))
        yield


@pytest.fixture
def quick() -> Scenario:
    """6 x 6 elements, to 0.1 mm in 50 steps: a run of a tenth of a second."""
    return Scenario(
        road={"elements": 6, "size": 6e-3, "pixel": 5e-5},
        loading={"max_indentation": 100e-6, "rate": 0.1024},
        numerics={"lags": 32},
    )


@pytest.fixture
def quick_cycle(quick: Scenario) -> Scenario:
    """The quick scenario pressed, held, and pulled off in 210 steps."""
    quick.loading.param.update(
        profile="load-hold-unload", hold_time=2e-4, unloading_rate=0.1, retraction=2e-4
    )
    return quick


@pytest.fixture
def tiny_figures(quick_cycle: Scenario) -> Iterator[dict[str, Figure]]:
    """Two figures of three members, two of which are the same run, in place of the thesis'."""
    shorter = quick_cycle.copy()
    shorter.loading.max_indentation = 60e-6
    first = Figure("fig-43", (43,), "a", lambda: {"a": quick_cycle.copy(), "b": shorter.copy()})
    other = Figure("fig-44", (44,), "c d", lambda: {"c d": quick_cycle.copy()})
    real = dict(FIGURES)
    FIGURES.clear()
    FIGURES.update({"fig-43": first, "fig-44": other})
    yield FIGURES
    FIGURES.clear()
    FIGURES.update(real)  # in its order


@pytest.fixture(scope="session")
def preset_run(_own_cache: None) -> Callable[[str], Results]:
    """Results of a preset by its name, each run once in the session."""

    @cache
    def run(name: str) -> Results:
        return Simulation(presets.get(name)).run()

    return run


@pytest.fixture(scope="session")
def measured() -> Path:
    """Folder of measured surfaces, beside the project or where TYRECONTACT_DATA says."""
    beside = Path(__file__).resolve().parents[2] / "shared" / "data"
    folder = Path(os.environ.get("TYRECONTACT_DATA", beside))
    if not folder.is_dir():
        pytest.skip(
            f"the measured surfaces are not at {folder} (TYRECONTACT_DATA names the folder)"
        )
    return folder
