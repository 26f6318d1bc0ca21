"""Runs made of plain arrays."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact import Results, Scenario


@pytest.fixture
def made() -> Callable[..., Results]:
    """Results of columns that a test gives; what it leaves out is that of a run that goes well."""

    def results(**columns: object) -> Results:
        arrays = {name: np.asarray(values) for name, values in columns.items()}
        count = len(next(iter(arrays.values())))
        usual = {
            "time": np.arange(count) * 1e-3,
            "indentation": np.linspace(0, 1e-4, count),
            "contact_force": np.zeros(count),
            "converged": np.ones(count, np.int8),
            "contacts": np.ones(count, int),
            "releases": np.zeros(count, int),
            "iterations": np.ones(count, int),
        }
        return Results(Scenario(), 1e-3, {**usual, **arrays})

    return results
