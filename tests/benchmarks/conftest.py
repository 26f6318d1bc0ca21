"""Benchmarks are asked for by name (`python -m tests.benchmarks`); `pytest` alone collects none."""

from __future__ import annotations

import pytest


@pytest.fixture(scope="session", autouse=True)
def _own_cache() -> None:
    """Unlike the tests, benchmarks take kernels from the user's cache: some take a minute."""
