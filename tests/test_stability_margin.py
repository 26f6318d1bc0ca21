"""The margin, and the account of energies, of the run that blows up, and of those that do not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tyrecontact import Results, Scenario, Simulation

Runs = Callable[[str], Results]


def test_a_passive_run_keeps_all_its_margin(preset_run: Runs) -> None:
    for name in ("default", "quasi-static"):
        np.testing.assert_array_equal(preset_run(name).stability_margin, 1)


def test_the_margin_is_used_up_before_the_run_fails(preset_run: Runs) -> None:
    """A user is told before the blow-up that it is coming."""
    results = preset_run("thesis-instability")
    crossing = int(np.flatnonzero(results.stability_margin < 0)[0])
    assert results.failed_at is not None
    assert 0 < crossing <= results.failed_at
    # and not out of the blue: contacts stiffen, and the margin goes with them
    margin = results.stability_margin[: crossing + 1]
    assert margin[0] == 1
    assert np.all(np.diff(margin) < 0.02)
    assert np.sum((margin > 0.2) & (margin < 0.8)) > 5


def test_below_the_crossing_nothing_grows(preset_run: Runs) -> None:
    """Step by step the force of the band-limited run rises as smoothly as that of the passive."""
    results = preset_run("thesis-instability")
    safe = int(np.flatnonzero(results.stability_margin < 0)[0])
    assert np.all(np.diff(results.contact_force[:safe]) >= 0)


def test_the_tread_gives_energy_back_where_the_run_blows_up(preset_run: Runs) -> None:
    results = preset_run("thesis-instability")
    below = np.flatnonzero(results.layer_work < 0)
    assert results.failed_at is not None
    assert below[0] >= int(np.flatnonzero(results.stability_margin < 0)[0])
    assert below[0] < results.failed_at + 30
    account = results.energy
    assert account["layer_work"] < -abs(account["drive_work"])
    # what it gives is lost again in steps that are far too large; the books balance
    scale = sum(abs(value) for value in account.values())
    assert abs(account["imbalance"]) < 1e-12 * scale  # rounding


def test_a_passive_tread_takes_energy_in_every_run(preset_run: Runs) -> None:
    for name in ("default", "quasi-static"):
        results = preset_run(name)
        assert results.layer_work.min() >= 0
        assert np.diff(results.algorithmic_loss).min() >= -1e-12
        assert abs(results.energy["imbalance"]) < 1e-13 * results.energy["drive_work"]


def test_softer_springs_keep_their_margin(quick: Scenario) -> None:
    """Below the critical stiffness the same kernel runs safely to the end."""
    quick.numerics.param.update(kernel="band-limited", solver="thesis", max_iterations=10)
    quick.springs.youngs_modulus = 5e4
    results = Simulation(quick).run()
    assert results.stability_margin.min() > 0
    assert results.converged.all()
    assert results.layer_work.min() >= 0
