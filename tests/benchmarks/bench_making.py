"""Time of what comes before the steps, of whole runs from a cold start, and memory."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.benchmarks import cases, child
from tyrecontact import Scenario, Simulation, presets

Benchmark = Any  # pytest-benchmark's fixture


@pytest.fixture(scope="session", autouse=True)
def _own_cache() -> None:
    """Unlike the tests, benchmarks take kernels from the user's cache: some take a minute."""


def coldest(benchmark: Benchmark, run: Any, name: str) -> None:
    """Keep the fastest of three fresh processes."""
    found = min((run(name) for _ in range(3)), key=lambda process: process["seconds"])
    benchmark.extra_info.update(case=name, **found)


@pytest.mark.parametrize("kernel", ["passive", "band-limited"])
def test_kernel(
    benchmark: Benchmark, kernel: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Made anew; for the default one also in a process that has done nothing else."""
    monkeypatch.setenv("TYRECONTACT_CACHE", str(tmp_path))

    def setup() -> tuple[tuple[Simulation], dict[str, Any]]:
        for file in tmp_path.iterdir():
            file.unlink()
        return (Simulation(Scenario(numerics={"kernel": kernel})),), {}

    benchmark.pedantic(lambda simulation: simulation.kernel, setup=setup, rounds=5)
    if kernel == "passive":
        coldest(benchmark, child.cold, "kernel")


def test_springs(benchmark: Benchmark) -> None:
    """From 2000 x 2000 heights."""
    scenario = Scenario(road={"pixel": 1e-5})
    patch = Simulation(scenario).patch

    def setup() -> tuple[tuple[Simulation], dict[str, Any]]:
        simulation = Simulation(scenario)
        simulation.patch = patch
        return (simulation,), {}

    benchmark.pedantic(lambda simulation: simulation.springs, setup=setup, rounds=5)
    coldest(benchmark, child.measured, "springs")


def test_default_run(benchmark: Benchmark) -> None:
    """1024 steps, road and springs included, the kernel from the disk."""
    steps = len(cases.default_run())
    assert steps == 1025  # and the rest before them
    benchmark.pedantic(lambda: cases.default_run().run(), rounds=3, warmup_rounds=1)
    simulation = cases.default_run()
    _ = simulation.bodies, simulation.solver
    seconds = min(float(cases.timed(simulation)[0].sum()) for _ in range(3))
    benchmark.extra_info.update(loop=seconds, steps=steps)
    coldest(benchmark, child.measured, "default")


@pytest.mark.parametrize("preset", ["adhesion", "thesis-factor-4", "quasi-static"])
def test_preset_run(benchmark: Benchmark, preset: str) -> None:
    results = benchmark.pedantic(
        lambda: Simulation(presets.get(preset)).run(), rounds=3, warmup_rounds=1
    )
    seconds = benchmark.stats.stats.min
    benchmark.extra_info.update(case="run", preset=preset, seconds=seconds, steps=len(results))


@pytest.mark.parametrize(
    "what", ["import", "default", "long", *(f"window-{n}" for n in cases.SIZES)]
)
def test_memory(benchmark: Benchmark, what: str) -> None:
    """Peak of a process's resident memory."""
    found = benchmark.pedantic(child.measured, args=(what,), rounds=1)
    benchmark.extra_info.update(case="memory", what=what, peak=found["peak"])
