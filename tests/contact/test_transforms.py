"""Both transforms against sums over elements written out, on patches of all shapes."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact import transforms
from tyrecontact.contact.transforms import Fourier, Matrices, kernel_waves, near_values, transform

SHAPES = [(1, 1), (1, 2), (3, 1), (2, 2), (3, 4), (5, 5), (8, 6), (7, 16)]


def dense(values: np.ndarray) -> np.ndarray:
    """Matrix between all elements of a kernel by offset (ny, nx)."""
    row, column = np.divmod(np.arange(values.size), values.shape[1])
    dy, dx = (np.abs(np.subtract.outer(i, i)) for i in (row, column))
    return values[dy, dx]


def random(shape: tuple[int, ...], seed: int) -> np.ndarray:
    return np.random.default_rng(seed).standard_normal(shape)


@pytest.mark.parametrize("kind", [Matrices, Fourier])
@pytest.mark.parametrize("shape", SHAPES)
def test_a_product_of_waves_is_the_sum_over_elements(kind: type, shape: tuple[int, int]) -> None:
    values, field, made = random(shape, 1), random(shape, 2), kind(shape)
    expected = (dense(values) @ field.ravel()).reshape(shape)
    waves = kernel_waves(values)
    at_once = made.product(made.grid(waves), field)
    in_parts = made.backward(waves.ravel() * made.forward(field))
    for found in (at_once, in_parts):  # sums of up to 112 numbers of the size 1
        np.testing.assert_allclose(found, expected, atol=1e-13)


@pytest.mark.parametrize("kind", [Matrices, Fourier])
def test_there_and_back_is_nothing(kind: type) -> None:
    field = random((5, 4), 3)
    np.testing.assert_allclose(
        kind((5, 4)).backward(kind((5, 4)).forward(field)), field, atol=1e-14
    )


@pytest.mark.parametrize("shape", SHAPES)
def test_waves_of_several_kernels_at_once(shape: tuple[int, int]) -> None:
    values = random((3, 2, *shape), 4)
    every = kernel_waves(values)
    assert every.shape == (3, 2, shape[0] + 1, shape[1] + 1)
    np.testing.assert_allclose(every[2, 1], kernel_waves(values[2, 1]), atol=1e-14)


def test_values_near_the_origin_come_back_from_the_waves() -> None:
    values = random((6, 5), 5)
    np.testing.assert_allclose(near_values(kernel_waves(values)), values[:2, :2], atol=1e-14)


def test_large_patches_are_transformed_fast() -> None:
    most = transforms.MATRICES_UP_TO
    assert isinstance(transform((most, 3)), Matrices)
    assert isinstance(transform((3, most + 1)), Fourier)
    assert transform((4, 4)) is transform((4, 4))
