"""Loops that are compiled where numba is installed (the extra `fast`), and threads.

numba halves the time of a step of 20 x 20 elements; everything works without it. Its functions are
compiled at their first use, in some ten seconds, and kept on disk.
"""

from __future__ import annotations

import os
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType

from threadpoolctl import threadpool_limits

#: whether compiled loops may be used; TYRECONTACT_COMPILED=0 in the environment forbids them
enabled = os.environ.get("TYRECONTACT_COMPILED", "1") != "0"


def compiled(name: str) -> ModuleType | None:
    """The module of compiled loops of this name, or None where there are none to be used."""
    return _module(name) if enabled else None


@cache
def _module(name: str) -> ModuleType | None:
    return import_module(name) if find_spec("numba") else None


def one_thread() -> threadpool_limits:
    """While this context lasts, products of matrices use one thread.

    Those of a step are too small to be shared, and the other core is the page's.
    """
    return threadpool_limits(limits=1, user_api="blas")
