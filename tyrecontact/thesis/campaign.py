"""All runs of some figures, each distinct scenario once, two at a time, written as they end."""

from __future__ import annotations

import json
import multiprocessing
import os
import threading
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import connection
from pathlib import Path
from typing import Any, Protocol, TypeVar

from tyrecontact import figures
from tyrecontact.figures import Figure
from tyrecontact.results import Results
from tyrecontact.simulation import Simulation
from tyrecontact.thesis import runs
from tyrecontact.thesis.curves import CURVES
from tyrecontact.writing import write_whole

#: of linear algebra in each process: two processes with two threads each get in their own way
_THREADS = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS")


class Progress(Protocol):
    """A bar such as tqdm's: `total` is set first, then it is told of steps done."""

    total: Any

    def update(self, count: int) -> Any: ...


@dataclass(frozen=True)
class Task:
    """One distinct scenario.

    Attributes
    ----------
    name : of the first member that asks for it, as a file name.
    settings : `Scenario.to_dict()` of it.  steps : of its complete run.
    members : (figure, label) of all that show it.
    """

    name: str
    settings: dict[str, Any]
    steps: int
    members: list[tuple[str, str]]


T = TypeVar("T")


def chosen(names: Sequence[str]) -> list[Figure]:
    """The figures of these names, each once, in the thesis' order; all of them for none.

    Raises
    ------
    InputError : no figure has that name.
    """
    wanted = {figures.find(name).name for name in names} if names else set(figures.FIGURES)
    return [figure for figure in figures.FIGURES.values() if figure.name in wanted]


def tasks(selected: Sequence[Figure]) -> list[Task]:
    """The distinct scenarios of figures, the longest first."""
    found: dict[str, Task] = {}
    for figure in selected:
        if figure.name in CURVES:
            continue
        names = figure.members
        for label, scenario in figure.family().items():
            key = json.dumps(scenario.to_dict(), sort_keys=True)
            if key not in found:
                name = names[label].replace("N/ms", "N_ms").replace("/", "_")
                steps = len(Simulation(scenario))
                found[key] = Task(name, scenario.to_dict(), steps, [])
            found[key].members.append((figure.name, label))
    return sorted(found.values(), key=lambda task: -task.steps)


def run_figures(
    selected: Sequence[Figure], folder: Path, jobs: int, progress: Progress
) -> dict[str, dict[str, Results]]:
    """Run what the figures need and write it to folder/runs, one netCDF file a scenario.

    A process pool is used for more than one job; a script that calls this needs the usual
    `if __name__ == "__main__"`.

    Returns
    -------
    Runs by figure and label.

    Raises
    ------
    TyreContactError : a folder that cannot be written.
    """
    work = tasks(selected)
    progress.total = sum(task.steps for task in work)
    results: dict[str, dict[str, Results]] = {figure.name: {} for figure in selected}
    for task, found in _run_all(work, jobs):
        write_dataset(runs.to_dataset(found), folder / "runs" / f"{task.name}.nc")
        for name, label in task.members:
            results[name][label] = found
        progress.update(task.steps)
    for figure in selected:
        if figure.name in CURVES:
            write_dataset(CURVES[figure.name](), folder / "runs" / f"{figure.name}.nc")
    return {figure.name: _in_order(figure, results[figure.name]) for figure in selected}


def files(selected: Sequence[Figure]) -> dict[str, dict[str, str]]:
    """Figure -> label -> file of the run, as `run_figures` names it."""
    names: dict[str, dict[str, str]] = {figure.name: {} for figure in selected}
    for task in tasks(selected):
        for name, label in task.members:
            names[name][label] = f"runs/{task.name}.nc"
    for figure in selected:
        if figure.name in CURVES:
            names[figure.name] = {"": f"runs/{figure.name}.nc"}
    return {figure.name: _in_order(figure, names[figure.name]) for figure in selected}


def _in_order(figure: Figure, found: Mapping[str, T]) -> dict[str, T]:
    """By label, in the order of the family, whatever ended first."""
    return {label: found[label] for label in ["", *figure.family()] if label in found}


def _run_all(work: Sequence[Task], jobs: int) -> Iterator[tuple[Task, Results]]:
    """Each task and its run, as they end."""
    if jobs == 1:
        for task in work:
            yield task, runs.run(task.settings)
        return
    with _single_threads():
        context = multiprocessing.get_context("spawn")
        pool = ProcessPoolExecutor(jobs, mp_context=context, initializer=_end_with_parent)
        try:
            pending: dict[Future[Results], Task] = {
                pool.submit(runs.run, task.settings): task for task in work
            }
            for future in as_completed(pending):
                yield pending[future], future.result()
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def _end_with_parent() -> None:
    """End this process when the one that started it is gone, however it went."""
    parent = multiprocessing.parent_process()
    assert parent is not None

    def watch() -> None:
        connection.wait([parent.sentinel])
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


@contextmanager
def _single_threads() -> Iterator[None]:
    """Processes that start here use one thread each."""
    before = {name: os.environ.get(name) for name in _THREADS}
    os.environ.update(dict.fromkeys(_THREADS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def write_dataset(dataset: Any, path: Path) -> None:
    """Write a dataset as netCDF beside its name and rename it: never half a file."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, dataset.to_netcdf)
