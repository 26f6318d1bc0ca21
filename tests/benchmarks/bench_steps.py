"""Time of a step: runs in their middle, by size, kernel and lags, and what they are compared with.

`extra_info` tells what is put into the table: seconds by step, contacts per element, and so on.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.benchmarks import cases, tamaas_solve
from tests.benchmarks.cases import Window
from tests.benchmarks.direct import DirectMethod
from tyrecontact import fast

Benchmark = Any  # pytest-benchmark's fixture
#: at which both methods are compared [m]
RESIDUAL = 2e-17
#: contacts per element in the middle of the passive windows, by size
_shares: dict[int, float] = {}


@pytest.fixture(scope="session", autouse=True)
def _own_cache() -> None:
    """Unlike the tests, benchmarks take kernels from the user's cache: some take a minute."""


def fastest(benchmark: Benchmark, run: Callable[[], Any], rounds: int, longest: float) -> Window:
    """Time whole windows; the fastest is kept, as others may use the machine too."""
    found: list[Window] = []
    benchmark.pedantic(
        lambda steps: found.append(cases.timed_window(steps, longest)),
        setup=lambda: ((run(),), {}),
        rounds=rounds,
    )
    best = min(found, key=lambda window: window.mean)
    benchmark.extra_info.update(
        seconds=best.mean,
        median=float(np.median(best.seconds)),
        longest=float(best.seconds.max()),
        steps=best.seconds.size,
        share=best.share,
        margin=best.margin,
    )
    return best


@pytest.mark.parametrize("kernel", [*cases.KERNELS, "static"])
@pytest.mark.parametrize("elements", cases.SIZES)
def test_step(benchmark: Benchmark, elements: int, kernel: str) -> None:
    simulation, rounds = cases.run(elements, kernel), 1 if elements > 100 else 3
    longest = cases.STATIC_LONGEST if kernel == "static" else cases.LONGEST
    benchmark.extra_info.update(case="step", kernel=kernel, elements=elements)
    best = fastest(benchmark, lambda: cases.begun(simulation), rounds, longest)
    if kernel == "passive":
        _shares[elements] = best.share


@pytest.mark.parametrize("kernel", [*cases.KERNELS, "static"])
def test_step_without_numba(
    benchmark: Benchmark, kernel: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fast, "enabled", False)
    simulation = cases.run(20, kernel)
    benchmark.extra_info.update(case="plain", kernel=kernel)
    fastest(benchmark, lambda: cases.begun(simulation), 3, cases.LONGEST)


@pytest.mark.parametrize("lags", cases.MANY_LAGS)
def test_step_by_lags(benchmark: Benchmark, lags: int) -> None:
    simulation = cases.window(20, "passive", lags)
    benchmark.extra_info.update(case="lags", lags=lags)
    fastest(benchmark, lambda: cases.begun(simulation), 3, cases.LONGEST)


@pytest.mark.parametrize("kernel", [*cases.KERNELS, "static"])
def test_direct_step(benchmark: Benchmark, kernel: str) -> None:
    """The baseline: all the same steps, to the same residual; the faster of two runs."""
    simulation, found = cases.run(20, kernel), []
    method = DirectMethod(simulation, simulation.solver.tolerance)
    benchmark.pedantic(
        lambda steps: found.append(cases.timed(steps)[0].mean()),
        setup=lambda: ((cases.begun(method),), {}),
        rounds=2,
    )
    benchmark.extra_info.update(
        case="direct", kernel=kernel, seconds=float(min(found)), difference=difference(kernel)
    )


def difference(kernel: str) -> float:
    """Largest difference of an element force from the direct method's, of the largest force.

    Both to a residual of 2e-17 m, in the first steps.
    """
    simulation = cases.run(20, kernel)
    simulation.solver = replace(simulation.solver, tolerance=RESIDUAL)
    direct = DirectMethod(simulation, RESIDUAL)
    pairs = [(one, other) for one, other, _ in zip(simulation, direct, range(40), strict=False)]
    expected = np.array([other.force for _, other in pairs])
    found = np.array([one.element_force.ravel() for one, _ in pairs])
    return float(np.abs(found - expected).max() / np.abs(expected).max())


@pytest.mark.parametrize("elements", cases.SIZES)
def test_tamaas(benchmark: Benchmark, elements: int) -> None:
    """One solve of about the share of contacts that the passive windows have in their middle."""
    solve, found, version = tamaas_solve.solve(elements, _shares.get(elements, 0.75))
    benchmark.extra_info.update(case="tamaas", elements=elements, share=found, version=version)
    benchmark.pedantic(solve, rounds=3 if elements > 100 else 20, warmup_rounds=1)
    benchmark.extra_info["seconds"] = benchmark.stats.stats.min
