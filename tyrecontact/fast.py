"""Loops that are compiled where numba is installed (the extra `fast`), and threads.

numba halves the time of a step of 20 x 20 elements; everything works without it. Its functions are
compiled at their first use, in some ten seconds, and kept on disk; from there they come in half a
second, so that it is for long runs, many runs, and the page.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any

from threadpoolctl import threadpool_limits

#: whether compiled loops may be used; TYRECONTACT_COMPILED=0 in the environment forbids them
enabled = os.environ.get("TYRECONTACT_COMPILED", "1") != "0"


def loops() -> ModuleType | None:
    """compiled.py, or None where there is nothing compiled to be used."""
    return _loops() if enabled else None


@cache
def _loops() -> ModuleType | None:
    try:
        import numba  # noqa: F401
    except ImportError:  # also where it does not go with this numpy
        return None
    return import_module("tyrecontact.compiled")


def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """A loop compiled by numba: kept on disk, free for other threads, divisions as in numpy."""
    njit = import_module("numba").njit
    options = {"nogil": True, "error_model": "numpy"}
    try:
        made: Callable[..., Any] = njit(cache=True, **options)(function)
    except RuntimeError:  # there is nowhere to keep it
        made = njit(**options)(function)
    return made


_lock = threading.Lock()
_inside: list[threadpool_limits] = []


@contextmanager
def one_thread() -> Iterator[None]:
    """While a context lasts, products of matrices use one thread, in the whole process.

    Those of a step are too small to be shared, and the other core is the page's. Contexts may
    overlap: the last one to end gives the threads back.
    """
    with _lock:
        # what the first one has found is what the last one restores
        _inside.append(_inside[-1] if _inside else threadpool_limits(limits=1, user_api="blas"))
    try:
        yield
    finally:
        with _lock:
            limits = _inside.pop()
            if not _inside:
                limits.restore_original_limits()
