"""Exchanged, mean, standard and linear springs: what each keeps of the original ones."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road.simplification import exchange_index
from tyrecontact.road.springs import (
    Springs,
    exchange_stiffest,
    from_heights,
    linearised,
    mean,
    standard,
)

PITCH, MODULUS = 5e-5, 10e6
COUNT = 30
NAMES = ("force", "stiffness", "energy", "radius", "punch_stiffness", "punch_stiffness_slope")


@pytest.fixture(scope="module")
def springs() -> Springs:
    """Elements of 20 x 20 heights each, of increasing roughness."""
    rng = np.random.default_rng(4)
    heights = rng.standard_normal((COUNT, 400)) * np.linspace(2e-6, 9e-6, COUNT)[:, None]
    return from_heights(heights, PITCH, MODULUS)


def at(springs: Springs, delta: float) -> np.ndarray:
    return np.full(springs.count, delta)


@pytest.mark.parametrize("ranking", ["force", "stiffness"])
def test_the_stiffest_springs_get_the_next(springs: Springs, ranking: str) -> None:
    value = getattr(springs, ranking)(at(springs, 9e-6))
    order = np.argsort(-value)
    source = order.copy()
    source[:5] = order[5:10]
    exchanged = exchange_stiffest(springs, 5, 9e-6, ranking)
    # the whole spring is exchanged, punch included, not its force at one compression
    for delta in (9e-6, 30e-6):
        for name in (*NAMES, "onset"):
            before = getattr(springs, name)(at(springs, delta))
            after = getattr(exchanged, name)(at(springs, delta))
            np.testing.assert_array_equal(after[order], before[source])


def test_who_is_exchanged_for_whom(springs: Springs) -> None:
    index = exchange_index(springs, 5, 9e-6)
    ranking = np.argsort(-springs.force(at(springs, 9e-6)))
    assert set(np.flatnonzero(index != np.arange(COUNT))) == set(ranking[:5])
    np.testing.assert_array_equal(index[ranking[:5]], ranking[5:10])


def test_the_compression_decides_on_the_ranking(springs: Springs) -> None:
    """Rough elements are soft at first; which ones are stiffest changes with the compression."""
    early, late = (exchange_stiffest(springs, 5, delta) for delta in (2e-6, 40e-6))
    assert np.any(early.force(at(springs, 9e-6)) != late.force(at(springs, 9e-6)))


def test_force_and_stiffness_rank_differently(springs: Springs) -> None:
    one, other = (exchange_stiffest(springs, 8, 3e-6, by) for by in ("force", "stiffness"))
    assert np.any(one.force(at(springs, 3e-6)) != other.force(at(springs, 3e-6)))


def test_no_exchange_changes_nothing(springs: Springs) -> None:
    same = exchange_stiffest(springs, 0, 9e-6)
    np.testing.assert_array_equal(same.force(at(springs, 3e-5)), springs.force(at(springs, 3e-5)))


@pytest.mark.parametrize("count", [-1, COUNT // 2 + 1])
def test_more_than_half_cannot_be_exchanged(springs: Springs, count: int) -> None:
    with pytest.raises(InputError, match=f"between 0 and {COUNT // 2}, got {count}"):
        exchange_stiffest(springs, count, 9e-6)


def test_an_unknown_ranking_is_refused(springs: Springs) -> None:
    with pytest.raises(InputError, match="ranking of springs must be one of force, stiffness"):
        exchange_stiffest(springs, 3, 9e-6, "forces")


@pytest.mark.parametrize("delta", [1e-6, 9e-6, 30e-6, 1e-3])
@pytest.mark.parametrize("name", NAMES)
def test_the_mean_spring_is_the_mean_of_all(springs: Springs, name: str, delta: float) -> None:
    found = getattr(mean(springs), name)(at(springs, delta))
    assert np.ptp(found) == 0
    expected = getattr(springs, name)(at(springs, delta)).mean()
    assert found[0] == pytest.approx(expected, rel=1e-9)  # rounding of coefficients


@pytest.mark.parametrize("count", [1, 3, 8])
def test_standard_springs_are_few_and_keep_the_sum(springs: Springs, count: int) -> None:
    few = standard(springs, count)
    force = few.force(at(springs, 9e-6))
    assert np.unique(force).size == count
    assert force.sum() == pytest.approx(springs.force(at(springs, 9e-6)).sum(), rel=1e-9)
    np.testing.assert_array_equal(force, standard(springs, count).force(at(springs, 9e-6)))


def test_more_standard_springs_are_closer_to_the_true_ones(springs: Springs) -> None:
    true = np.log(springs.force(at(springs, 9e-6)))
    off = [
        np.abs(np.log(standard(springs, count).force(at(springs, 9e-6))) - true).mean()
        for count in (1, 3, 8, 30)
    ]
    assert off == sorted(off, reverse=True)
    assert off[-1] < 1e-9  # as many as there are springs: each its own


def test_springs_of_one_kind_stay_as_they_are(springs: Springs) -> None:
    """Fewer kinds than standard springs asked for."""
    two = springs.take(np.repeat([0, 20], 15))
    force = standard(two, 6).force(at(two, 9e-6))
    np.testing.assert_allclose(force, two.force(at(two, 9e-6)), rtol=1e-12)  # rounding


def test_standard_springs_do_not_depend_on_the_order_of_the_elements(springs: Springs) -> None:
    order = np.random.default_rng(1).permutation(COUNT)
    direct = standard(springs, 4).force(at(springs, 9e-6))
    shuffled = standard(springs.take(order), 4).force(at(springs, 9e-6))
    np.testing.assert_allclose(shuffled, direct[order], rtol=1e-9)  # rounding of sums


@pytest.mark.parametrize("reference", [3e-6, 10e-6])
def test_linear_springs_have_the_true_force_at_one_compression(
    springs: Springs, reference: float
) -> None:
    straight = linearised(springs, reference)
    true = springs.force(at(springs, reference))
    for share in (0.1, 1.0, 20.0):
        delta = at(springs, share * reference)
        np.testing.assert_allclose(straight.force(delta), share * true, rtol=1e-9)  # rounding
        np.testing.assert_array_equal(
            straight.radius(delta), springs.radius(at(springs, reference))
        )
        np.testing.assert_array_equal(straight.onset(delta), 0)
        np.testing.assert_array_equal(straight.punch_stiffness(delta), straight.stiffness(delta))


@pytest.mark.parametrize("compression", [0.0, -1e-6, np.nan, np.inf])
def test_an_impossible_compression_is_refused(springs: Springs, compression: float) -> None:
    with pytest.raises(InputError, match="linear_compression must be positive"):
        linearised(springs, compression)


def test_no_standard_spring_is_too_few(springs: Springs) -> None:
    with pytest.raises(InputError, match="standard_count must be at least 1, got 0"):
        standard(springs, 0)
