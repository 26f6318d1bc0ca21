"""Small bodies in contact: kernels, linear springs, a rough road of 8 x 8 elements."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.road import heights, textures
from tyrecontact.road.springs import Springs, from_heights, linear
from tyrecontact.tread.kernels import passive
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

SHAPE = (8, 8)


@pytest.fixture(scope="session")
def tread() -> LatticeKernel:
    """The default plate under 8 x 8 elements of 1 mm at 51.2 kHz."""
    rubber = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499)
    base = Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33)
    return LatticeKernel(passive([rubber, base], SHAPE, 1e-3, 1 / 51200, lags=64))


@pytest.fixture(scope="session")
def element_heights() -> np.ndarray:
    """A worn road of 8 x 8 mm [m], shape (elements, pixels of an element)."""
    road = textures.worn(
        8e-3, 50e-6, valley_rms=40e-6, plateau_rms=15e-6, offset=20e-6,
        stone_size=4e-3, plateau_wavelength=1e-3, seed=3,
    )  # fmt: skip
    return heights.element_heights(road, SHAPE[0]).reshape(SHAPE[0] * SHAPE[1], -1)


@pytest.fixture(scope="session")
def rough_springs(element_heights: np.ndarray) -> Springs:
    return from_heights(element_heights, 50e-6, 10e6)


@pytest.fixture(scope="session")
def tops(element_heights: np.ndarray) -> np.ndarray:
    """Element tops below the highest one [m], <= 0."""
    highest = element_heights.max(axis=-1)
    return highest - highest.max()


@pytest.fixture(scope="session")
def linear_springs() -> Callable[[np.ndarray], Springs]:
    """Springs of constant stiffness [N/m], one an element, under punches of 0.1 mm."""
    return lambda stiffness: linear(stiffness, 1e-4, 1e-4)
