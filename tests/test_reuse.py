"""What is handed on from one simulation to the next gives the same numbers, and nothing stale."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation
from tyrecontact.reuse import DEPENDS, hand_on

PARTS = set(DEPENDS)


def _made(scenario: Scenario) -> Simulation:
    simulation = Simulation(scenario)
    for part in DEPENDS:
        getattr(simulation, part)
    return simulation


def _shared(made: Simulation, scenario: Scenario) -> tuple[set[str], Simulation]:
    fresh = Simulation(scenario)
    hand_on(made, fresh)
    return {part for part in PARTS if vars(fresh).get(part) is vars(made)[part]}, fresh


@pytest.mark.parametrize(
    ("path", "value", "anew"),
    [
        ("adhesion.release_force", 1.0, set()),
        ("loading.profile", "load-hold-unload", set()),
        ("springs.exchange_count", 8, {"springs"}),
        ("springs.youngs_modulus", 5e6, {"springs", "original_springs"}),
        ("numerics.time_resolution_factor", 2, {"kernel", "lattice", "margin"}),
        ("tread.thickness", 9e-3, {"kernel", "lattice", "margin"}),
        ("road.seed", 2, {"patch", "springs", "original_springs"}),
        ("road.elements", 5, PARTS),
    ],
)
def test_what_a_change_leaves_alone_is_shared_and_gives_the_same(
    quick: Scenario, path: str, value: object, anew: set[str]
) -> None:
    made, changed = _made(quick), quick.copy()
    changed.set(path, value)
    shared, fresh = _shared(made, changed)
    assert PARTS - shared == anew
    again, alone = fresh.run(), Simulation(changed).run()
    for name in ("contact_force", "stability_margin", "iterations"):
        np.testing.assert_array_equal(again.columns[name], alone.columns[name])


def test_every_setting_that_changes_a_part_makes_it_anew(quick: Scenario) -> None:
    """Each numeric setting a little off: what is shared must be what it would have been."""
    made = _made(quick)
    for path, parameter, value in quick.settings():
        if not isinstance(value, float) or path.startswith(("loading", "adhesion")):
            continue
        changed = quick.copy()
        low, high = parameter.bounds
        changed.set(path, min(max(1.01 * value, low), high))
        shared, _ = _shared(made, changed)
        if "springs" in shared:
            alone = Simulation(changed).springs
            np.testing.assert_array_equal(alone.energy_table, made.springs.energy_table, path)
        if "kernel" in shared and path.startswith(("tread", "road", "numerics")):
            np.testing.assert_array_equal(Simulation(changed).kernel.values, made.kernel.values)


def test_a_file_that_has_changed_under_its_name_is_read_again(
    quick: Scenario, tmp_path: Path
) -> None:
    path = tmp_path / "road.npy"
    heights = np.random.default_rng(1).standard_normal((120, 120)) * 1e-5
    np.save(path, heights)
    quick.road.param.update(file=str(path), pitch=5e-5, height_unit="m")
    made = _made(quick)
    shared, _ = _shared(made, quick)
    assert shared == PARTS
    np.save(path, 2 * heights)
    before = path.stat()
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns + 1_000_000))
    shared, fresh = _shared(made, quick)
    assert shared == set()
    assert np.ptp(fresh.patch.heights) == pytest.approx(2 * np.ptp(made.patch.heights))


def test_only_what_has_been_made_is_handed_on(quick: Scenario) -> None:
    made = Simulation(quick)
    _ = made.patch
    fresh = Simulation(quick)
    hand_on(made, fresh)
    assert PARTS & set(vars(fresh)) == {"patch"}
