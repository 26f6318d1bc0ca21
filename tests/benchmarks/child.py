"""Cold starts and memory: `python -m tests.benchmarks.child CASE` does one thing in a new process.

It prints as JSON: seconds of the import and of the thing, peak of the resident memory [B].
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

_ROOT = Path(__file__).parents[2]


def kernel() -> Callable[[], object]:
    """The default kernel, where none is on the disk."""
    from tyrecontact import Simulation, presets

    simulation = Simulation(presets.get("default"))
    return lambda: simulation.kernel


def springs() -> Callable[[], object]:
    """The default springs from 2000 x 2000 heights."""
    from tyrecontact import Scenario, Simulation

    simulation = Simulation(Scenario(road={"pixel": 1e-5}))
    assert simulation.patch.heights.shape == (2000, 2000)
    return lambda: simulation.springs


def default() -> Callable[[], object]:
    """The default scenario in 1024 steps: road, springs, cached kernel and all."""
    from tests.benchmarks import cases

    return lambda: cases.default_run().run()


def window(elements: int) -> Callable[[], object]:
    """A few steps with a full memory, road and springs and cached kernel included."""
    from itertools import islice

    from tests.benchmarks import cases

    return lambda: list(islice(iter(cases.window(elements, "passive")), 6))


def long() -> Callable[[], object]:
    """82,000 steps recorded and written to a file: the same sixty, over and over."""
    from dataclasses import replace
    from itertools import islice

    from tyrecontact import Simulation, presets
    from tyrecontact.results import FIELDS, Record

    simulation = Simulation(presets.get("default"))
    steps, count = list(islice(simulation, 60)), 82_000

    def run() -> None:
        record = Record(count, simulation.bodies.kernel.shape)
        for index in range(count):
            step = steps[index % len(steps)]
            fields = {name: getattr(step, name).copy() for name in FIELDS}
            record.append(replace(step, index=index, **fields))
        with TemporaryDirectory() as folder:
            simulation.collect(record).to_xarray().to_netcdf(f"{folder}/run.nc")

    return run


def measured(case: str, cache: str | None = None) -> dict[str, float]:
    """Run a case in a process of its own."""
    command = [sys.executable, "-m", "tests.benchmarks.child", case]
    environment = os.environ | ({"TYRECONTACT_CACHE": cache} if cache else {})
    done = subprocess.run(
        command, cwd=_ROOT, env=environment, capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout)


def cold(case: str) -> dict[str, float]:
    """The same with an empty cache of kernels."""
    with TemporaryDirectory() as folder:
        return measured(case, folder)


def main(case: str) -> None:
    start = time.perf_counter()
    import tyrecontact  # noqa: F401

    imported = time.perf_counter()
    name, _, elements = case.partition("-")
    prepared = {"kernel": kernel, "springs": springs, "default": default, "long": long}.get(name)
    run = prepared() if prepared else window(int(elements)) if elements else lambda: None
    begin = time.perf_counter()
    run()
    seconds = time.perf_counter() - begin
    print(json.dumps({"import": imported - start, "seconds": seconds, "peak": peak_memory()}))


def peak_memory() -> int:
    """Peak of the resident memory of this process [B].

    Linux hands ru_maxrss on from the process that started this one, which may be larger.
    """
    status = Path("/proc/self/status")
    if not status.exists():
        kilobyte = 1 if sys.platform == "darwin" else 1024  # its unit there is the byte
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * kilobyte
    line = next(line for line in status.read_text().splitlines() if line.startswith("VmHWM"))
    return int(line.split()[1]) * 1024


if __name__ == "__main__":
    main(sys.argv[1])
