"""Sums in blocks of steps against the sum over all lags, written out."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact import blocks
from tyrecontact.contact.blocks import RATIO, SHORTEST, Lagged, Memory

WAVES, PARTS = 5, 2


def kernel(lags: int) -> np.ndarray:
    return np.random.default_rng(lags).standard_normal((lags, WAVES))


def plain(g: np.ndarray, x: list[np.ndarray]) -> np.ndarray:
    """sum_(j=1)^(lags-1) g_j x_(n-j)."""
    total = np.zeros((PARTS, WAVES))
    for lag, past in zip(range(1, len(g)), reversed(x), strict=False):
        total += g[lag] * past
    return total


# no more than the shortest block, just one more, just at each border of lengths, far from any
@pytest.mark.parametrize("lags", [2, 3, 16, 17, 33, 100, 192, 193, 256, 300, 800])
def test_the_sum_is_that_over_all_lags(lags: int) -> None:
    g, random = kernel(lags), np.random.default_rng(1)
    memory, x = Memory(Lagged(g), PARTS), []
    for _ in range(2 * lags + 70 if lags < 300 else lags + 300):
        # rounding: products of numbers of the size 1, as many as there are lags
        np.testing.assert_allclose(memory.sum(), plain(g, x), atol=1e-14 * (lags + 20))
        x.append(random.standard_normal((PARTS, WAVES)))
        memory.take(x[-1])


def test_long_blocks_are_transformed_by_another_way(monkeypatch: pytest.MonkeyPatch) -> None:
    g, random = kernel(150), np.random.default_rng(2)
    x = [random.standard_normal((PARTS, WAVES)) for _ in range(200)]
    sums = []
    for most in (64, 4):
        monkeypatch.setattr(blocks, "_MATRICES_UP_TO", most)
        memory = Memory(Lagged(g), PARTS)
        for value in x:
            memory.take(value)
        sums.append(memory.sum())
    np.testing.assert_allclose(*sums, atol=1e-12)


@pytest.mark.parametrize("steps", [0, 1, 15, 16, 77])
@pytest.mark.parametrize("lags", [4, 60, 200])
def test_what_has_not_changed_for_long_can_be_filled_in(lags: int, steps: int) -> None:
    g, random = kernel(lags), np.random.default_rng(3)
    memory, still = Memory(Lagged(g), PARTS), random.standard_normal((PARTS, WAVES))
    for _ in range(steps):
        memory.take(random.standard_normal((PARTS, WAVES)))
    memory.fill(still)
    x = [still] * lags
    for _ in range(lags + 40):
        np.testing.assert_allclose(memory.sum(), plain(g, x), atol=1e-14 * (lags + 20))
        x.append(random.standard_normal((PARTS, WAVES)))
        memory.take(x[-1])


def test_the_number_of_blocks_grows_with_the_logarithm_of_the_lags() -> None:
    """Each length has fewer blocks than make one of the next, but for the longest."""
    counts = {}
    for lags in (256, 1024, 4096):
        lengths = Lagged(np.ones((lags, 1))).by_length
        counts[lags] = sum(len(parts) for parts in lengths)
        assert [parts.shape[2] - 1 for parts in lengths] == [
            SHORTEST * RATIO**n for n in range(len(lengths))
        ]
    assert counts[4096] - counts[1024] == counts[1024] - counts[256] == RATIO - 1
