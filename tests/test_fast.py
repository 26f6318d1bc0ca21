"""Compiled loops can be forbidden, and steps use one thread however runs overlap."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable

import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from tyrecontact import Simulation, fast, presets


def threads() -> set[int]:
    return {pool["num_threads"] for pool in threadpool_info() if pool["user_api"] == "blas"}


def test_loops_are_compiled_where_numba_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("numba")
    monkeypatch.setattr(fast, "enabled", True)
    assert fast.loops() is not None
    monkeypatch.setattr(fast, "enabled", False)
    assert fast.loops() is None


def test_where_nothing_can_be_kept_loops_are_compiled_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    numba, asked = pytest.importorskip("numba"), []

    def njit(cache: bool = False, **_options: object) -> Callable[[object], object]:
        asked.append(cache)
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return lambda function: function

    monkeypatch.setattr(numba, "njit", njit)
    assert fast.compiled(threads) is threads
    assert asked == [True, False]


FORBIDDEN = "import os; os.environ['TYRECONTACT_COMPILED'] = '0'"
MISSING = "import sys; sys.modules['numba'] = None"


@pytest.mark.parametrize("without", [FORBIDDEN, MISSING])
def test_everything_works_without_numba(without: str) -> None:
    script = (
        f"{without}\nimport tyrecontact as tc, sys\n"
        "scenario = tc.presets.get('quasi-static')\n"
        "scenario.set('road.elements', 5)\nscenario.set('road.size', 5e-3)\n"
        "assert tc.Simulation(scenario).run().failed_at is None\n"
        "assert not sys.modules.get('tyrecontact.compiled')\n"
    )
    environment = {k: v for k, v in os.environ.items() if k != "TYRECONTACT_COMPILED"}
    subprocess.run([sys.executable, "-c", script], check=True, env=environment, timeout=120)


def test_a_run_uses_one_thread_and_gives_them_back() -> None:
    with threadpool_limits(limits=2, user_api="blas"):
        before = threads()
        loop = iter(Simulation(presets.get("quasi-static")))
        next(loop)
        assert threads() == {1}
        loop.close()
        assert threads() == before


def test_runs_that_overlap_give_them_back_when_the_last_one_ends() -> None:
    with threadpool_limits(limits=2, user_api="blas"):
        before = threads()
        first, second = fast.one_thread(), fast.one_thread()
        first.__enter__()
        second.__enter__()
        first.__exit__(None, None, None)
        assert threads() == {1}
        second.__exit__(None, None, None)
        assert threads() == before
