"""Time of a step: runs in their middle, by size, kernel and lags, and what they are compared with.

`extra_info` tells what is put into the table: seconds by step, contacts per element, and so on.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.benchmarks import cases, tamaas_solve
from tests.benchmarks.direct import DirectMethod

Benchmark = Any  # pytest-benchmark's fixture
#: of a step's residual: what the default tolerance leaves at 0.2 mm [m]
RESIDUAL = 2e-14


def fastest(benchmark: Benchmark, run: Callable[[], Any], rounds: int) -> cases.Window:
    """Time whole windows; the fastest is kept, as others may use the machine too."""
    found: list[cases.Window] = []
    benchmark.pedantic(
        lambda steps: found.append(cases.run_window(steps)),
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


def rounds(elements: int) -> int:
    return 1 if elements > 100 else 3


@pytest.mark.parametrize("kernel", cases.KERNELS)
@pytest.mark.parametrize("elements", cases.SIZES)
def test_step(benchmark: Benchmark, elements: int, kernel: str) -> None:
    simulation = cases.window(elements, kernel)
    benchmark.extra_info.update(case="step", kernel=kernel, elements=elements)
    fastest(benchmark, lambda: cases.begun(simulation), rounds(elements))


@pytest.mark.parametrize("elements", cases.SIZES)
def test_quasi_static_step(benchmark: Benchmark, elements: int) -> None:
    """Far from the last one, as 40 steps lead to 0.2 mm."""
    simulation = cases.quasi_static(elements)
    benchmark.extra_info.update(case="step", kernel="static", elements=elements)
    fastest(benchmark, lambda: cases.begun(simulation), rounds(elements))


@pytest.mark.parametrize("lags", cases.MANY_LAGS)
def test_step_by_lags(benchmark: Benchmark, lags: int) -> None:
    simulation = cases.window(20, "passive", lags)
    benchmark.extra_info.update(case="lags", lags=lags)
    fastest(benchmark, lambda: cases.begun(simulation), rounds=3)


@pytest.mark.parametrize("kernel", [*cases.KERNELS, "static"])
def test_direct_step(benchmark: Benchmark, kernel: str) -> None:
    """The baseline: the same steps, the last of them compared."""
    static = kernel == "static"
    simulation = cases.quasi_static(20) if static else cases.window(20, kernel)
    method = DirectMethod(simulation, RESIDUAL)
    seconds, steps = benchmark.pedantic(
        cases.timed, setup=lambda: ((cases.begun(method),), {}), rounds=1
    )
    found = np.array([step.element_force.ravel() for step in cases.begun(simulation)])
    expected = np.array([step.force for step in steps])
    difference = np.abs(found[: len(steps)] - expected).max() / np.abs(expected).max()
    benchmark.extra_info.update(
        case="direct", kernel=kernel, seconds=float(seconds.mean()), difference=float(difference)
    )


@pytest.mark.parametrize("elements", cases.SIZES)
def test_tamaas(benchmark: Benchmark, elements: int) -> None:
    """One solve of the share of contacts that our steps have in their middle."""
    steps = list(cases.begun(cases.quasi_static(elements, 8)))
    share = next(step.contacts for step in steps if step.indentation > 7e-5) / elements**2
    solve, found, version = tamaas_solve.solve(elements, share)
    benchmark.extra_info.update(case="tamaas", elements=elements, share=found, version=version)
    benchmark.pedantic(solve, rounds=3 if elements > 100 else 20, warmup_rounds=1)
    benchmark.extra_info["seconds"] = benchmark.stats.stats.min
