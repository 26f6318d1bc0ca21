"""What the closed forms are compared with: elastic layers, kernels, dense element matrices."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.tread.kernels import Kernel, band_limited, passive
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

MODULUS = 25e6
SAMPLING = 51200.0


@pytest.fixture(scope="session")
def elastic_layer() -> Callable[..., Layer]:
    """A layer without losses, by thickness [m] and Poisson's ratio."""

    def make(thickness: float, poissons_ratio: float) -> Layer:
        return Layer(thickness, 1300, NearlyConstantLoss(MODULUS, 0.0), poissons_ratio)

    return make


@pytest.fixture(scope="session")
def tread_layers() -> list[Layer]:
    """The default plate: 10 mm of rubber on 3 mm of aluminium."""
    rubber = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499)
    return [rubber, Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33)]


@pytest.fixture(scope="session")
def passive_kernel(tread_layers: list[Layer]) -> Kernel:
    return passive(tread_layers, (8, 8), 1e-3, 1 / SAMPLING, lags=64)


@pytest.fixture(scope="session")
def band_limited_kernel(tread_layers: list[Layer]) -> Kernel:
    return band_limited(tread_layers, (8, 8), 1e-3, 1 / SAMPLING, lags=64)


@pytest.fixture(scope="session")
def element_matrix() -> Callable[[np.ndarray], np.ndarray]:
    """Compliance between all elements (..., n, n) from that by offset (..., ny, nx)."""

    def make(values: np.ndarray) -> np.ndarray:
        row, column = (index.ravel() for index in np.indices(values.shape[-2:]))
        return values[..., abs(row[:, None] - row), abs(column[:, None] - column)]

    return make
