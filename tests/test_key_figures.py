"""Events of release and the energy account, from columns made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact import key_figures


def events(releases: list[int] | np.ndarray, drive: list[float] | np.ndarray) -> list[int]:
    columns = {"releases": np.asarray(releases), "drive": np.asarray(drive, float)}
    return key_figures.avalanches(columns).tolist()


#: up to 100 and back to -100 in steps of one; an event is 1 % of the way back, 1 to 2
UP_AND_BACK = np.concatenate([np.arange(0, 100), np.arange(100, -101, -1)])


def at(**places: int) -> np.ndarray:
    """Releases by the drive on the way back: at(p5=3) is 3 of them at 5, m5 at -5."""
    releases = np.zeros(UP_AND_BACK.size, int)
    for place, count in places.items():
        drive = int(place[1:]) * (-1 if place[0] == "m" else 1)
        releases[200 - (drive + 100) + 100] = count
    return releases


def test_releases_of_a_step_are_one_event_and_those_far_apart_are_several() -> None:
    assert events(at(p50=3, m20=7, m90=2), UP_AND_BACK) == [3, 7, 2]


def test_releases_within_a_hundredth_of_the_way_are_one_event() -> None:
    # the way to the last release is 200, an event takes 2
    assert events(at(m20=4, m21=1, m22=5, m100=1), UP_AND_BACK) == [10, 1]
    assert events(at(m20=4, m23=5, m100=1), UP_AND_BACK) == [4, 5, 1]


def test_the_largest_group_is_taken_first() -> None:
    """A forerunner does not cut the avalanche that follows it in two."""
    assert events(at(m20=1, m22=50, m23=40, m24=3, m100=1), UP_AND_BACK) == [1, 93, 1]


@pytest.mark.parametrize("finer", [2, 5])
def test_finer_steps_and_another_rate_change_no_event(finer: int) -> None:
    releases = at(m20=6, m21=4, m60=1, m61=2, m100=1)
    coarse = events(releases, UP_AND_BACK)
    index = np.arange(UP_AND_BACK.size * finer - finer + 1) / finer
    drive = np.interp(index, np.arange(UP_AND_BACK.size), UP_AND_BACK)
    spread = np.zeros(drive.size, int)
    spread[::finer] = releases
    # the six break one after the other within the way of a coarse step
    spread[np.flatnonzero(spread == 6)[0] : np.flatnonzero(spread == 6)[0] + 2] = [2, 4]
    assert events(spread, drive) == coarse == [10, 3, 1]


def test_bonds_that_break_while_the_drive_stands_still_are_one_event() -> None:
    drive = [0, 1, 1, 1, 1, -1]
    assert events([0, 0, 2, 3, 4, 0], drive) == [9]


def test_without_releases_there_are_no_events() -> None:
    assert events([0, 0, 0], [0, 1, 0]) == []
    assert events([], []) == []


@pytest.mark.parametrize("seed", range(3))
def test_every_release_belongs_to_one_event(seed: int) -> None:
    rng = np.random.default_rng(seed)
    releases = rng.poisson(0.3, UP_AND_BACK.size)
    assert sum(events(releases, UP_AND_BACK)) == releases.sum()


def test_the_account_says_what_is_missing() -> None:
    columns = {name: np.array([0.0, 1.0]) for name in key_figures.ACCOUNT}
    columns["drive_work"] = np.array([0.0, 5.5])
    account = key_figures.energy_account(columns)
    assert account["imbalance"] == 0.5
    assert list(account) == ["drive_work", *key_figures.ACCOUNT, "imbalance"]
    empty = key_figures.energy_account({name: np.zeros(0) for name in columns})
    assert set(empty.values()) == {0.0}


def test_the_first_step_that_may_blow_up_is_the_first_below_zero() -> None:
    columns = {"stability_margin": np.array([1.0, 0.2, 0.0, np.nan, -0.1, 0.3, -2.0])}
    assert key_figures.first_unstable(columns) == 4
    assert key_figures.first_unstable({"stability_margin": np.ones(5)}) is None


def test_energy_is_created_where_the_tread_gives_more_than_it_got() -> None:
    layer = np.array([0.0, 1, 2, 1, 0.5, -0.5, 3])
    assert key_figures.energy_created({"layer_work": layer}) == 5
    assert key_figures.energy_created({"layer_work": np.abs(layer)}) is None
    # 4 are exchanged, and what is left of them is rounding
    assert key_figures.energy_created({"layer_work": np.array([2.0, -1e-12])}) is None
    assert key_figures.energy_created({"layer_work": np.zeros(0)}) is None


def test_the_imbalance_is_what_is_missing_in_each_step() -> None:
    columns = {name: np.array([0.0, 1.0]) for name in key_figures.ACCOUNT}
    columns["drive_work"] = np.array([0.5, 5.0])
    assert key_figures.imbalance(columns).tolist() == [0.5, 0.0]
