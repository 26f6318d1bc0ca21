"""The default plate, its kernels on a small lattice, and dense element matrices."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.tread.kernels import Kernel, band_limited, passive, static
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

SHAPE, SPACING, TIME_STEP, LAGS = (4, 4), 1e-3, 1 / 51200, 64


@pytest.fixture(scope="session")
def layers() -> list[Layer]:
    """The default plate: 10 mm of rubber on 3 mm of aluminium."""
    rubber = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499)
    return [rubber, Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33)]


@pytest.fixture(scope="session")
def passive_kernel(layers: list[Layer]) -> Kernel:
    return passive(layers, SHAPE, SPACING, TIME_STEP, LAGS)


@pytest.fixture(scope="session")
def band_limited_kernel(layers: list[Layer]) -> Kernel:
    return band_limited(layers, SHAPE, SPACING, TIME_STEP, LAGS)


@pytest.fixture(scope="session")
def static_kernel(layers: list[Layer]) -> Kernel:
    return static(layers, SHAPE, SPACING)


@pytest.fixture(scope="session")
def element_matrix() -> Callable[[np.ndarray], np.ndarray]:
    """Compliance between all elements (..., n, n) from that by offset (..., ny, nx)."""

    def make(values: np.ndarray) -> np.ndarray:
        row, column = (index.ravel() for index in np.indices(values.shape[-2:]))
        return values[..., abs(row[:, None] - row), abs(column[:, None] - column)]

    return make
