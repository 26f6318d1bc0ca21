"""The campaign: each scenario once, no step too many, and files that are whole."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest
import xarray as xr

from tyrecontact import Scenario, Simulation
from tyrecontact.errors import InputError
from tyrecontact.figures import Figure
from tyrecontact.thesis import campaign, runs

Figures = dict[str, Figure]


def bar() -> SimpleNamespace:
    return SimpleNamespace(total=None, update=Mock())


def test_a_scenario_of_two_figures_is_run_once(
    tiny_figures: Figures, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = Mock(wraps=runs.run)
    monkeypatch.setattr(runs, "run", run)
    progress = bar()
    selected = campaign.chosen([])
    results = campaign.run_figures(selected, tmp_path, 1, progress)
    assert run.call_count == 2
    assert {name: list(family) for name, family in results.items()} == {
        "fig-43": ["a", "b"],
        "fig-44": ["c d"],
    }
    assert results["fig-43"]["a"] is results["fig-44"]["c d"]
    assert progress.total == sum(call.args[0] for call in progress.update.call_args_list)
    files = campaign.files(selected)
    assert files["fig-44"]["c d"] == files["fig-43"]["a"] == "runs/fig-43_a.nc"
    written = {f"runs/{path.name}" for path in (tmp_path / "runs").iterdir()}
    assert written == {name for family in files.values() for name in family.values()}


def test_two_processes_give_what_one_gives(tiny_figures: Figures, tmp_path: Path) -> None:
    selected = campaign.chosen(["43"])
    one = campaign.run_figures(selected, tmp_path, 1, bar())["fig-43"]
    two = campaign.run_figures(selected, tmp_path, 2, bar())["fig-43"]
    for label, run in one.items():
        # another thread count may add in another order
        np.testing.assert_allclose(
            two[label].contact_force, run.contact_force, rtol=1e-9, atol=1e-12
        )


def test_a_run_ends_when_road_and_tread_have_parted(quick_cycle: Scenario) -> None:
    whole = Simulation(quick_cycle).run()
    run = runs.run(quick_cycle.to_dict())
    assert len(run) < len(whole)
    assert run.contacts[-1] == 0 < run.contacts[-2]
    assert run.adherence_force == whole.adherence_force > 0
    np.testing.assert_array_equal(run.contact_force, whole.contact_force[: len(run)])


def test_a_run_that_fails_goes_on_for_a_while(
    quick: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(runs, "AFTER_FAILURE", 7)
    quick.numerics.param.update(solver="thesis", max_iterations=1)
    run = runs.run(quick.to_dict())
    assert len(run) == run.failed_at + 8


def test_a_run_comes_back_from_its_file(quick_cycle: Scenario, tmp_path: Path) -> None:
    run = runs.run(quick_cycle.to_dict())
    path = tmp_path / "run.nc"
    campaign.write_dataset(runs.to_dataset(run), path)
    back = runs.read(path)
    assert back.scenario.to_dict() == quick_cycle.to_dict()
    assert (back.stop_reason, back.spacing) == (run.stop_reason, run.spacing)
    for name in runs.KEPT:
        np.testing.assert_array_equal(back.columns[name], run.columns[name])
    with xr.open_dataset(path) as dataset:
        assert all("units" in dataset[name].attrs for name in [*runs.KEPT, "time"])


def test_figures_are_chosen_by_number_in_the_order_of_the_thesis(tiny_figures: Figures) -> None:
    assert [figure.name for figure in campaign.chosen(["44", "fig-43", "44"])] == [
        "fig-43",
        "fig-44",
    ]
    with pytest.raises(InputError, match="figure must be one of fig-43, fig-44, got '45'"):
        campaign.chosen(["45"])
