"""The one loop: what it promises to those who iterate it, and what must not change its results."""

from __future__ import annotations

from dataclasses import fields, replace
from itertools import islice, pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tyrecontact import Results, Scenario, Simulation, assembly, simulation
from tyrecontact.results import FIELDS, SCALARS, Record, Step


def arrays(step: Step) -> dict[str, np.ndarray]:
    return {name: getattr(step, name).copy() for name in FIELDS}


def forces(scenario: Scenario) -> np.ndarray:
    return Simulation(scenario).run().contact_force


def assert_equal_steps(one: Step, other: Step) -> None:
    for field in fields(Step):
        np.testing.assert_array_equal(getattr(one, field.name), getattr(other, field.name))


def test_length_times_and_path_are_those_of_the_steps(quick: Scenario) -> None:
    run = Simulation(quick)
    steps = list(run)
    assert len(run) == len(steps) == 51  # 50 steps, and the rest before them
    assert [step.index for step in steps] == list(range(51))
    np.testing.assert_array_equal([step.time for step in steps], run.schedule.time)
    np.testing.assert_array_equal([step.indentation for step in steps], run.schedule.drive)
    assert steps[0].contact_force == 0 < steps[-1].contact_force
    assert all(step.converged and not step.stop_reason for step in steps)


def test_every_iteration_starts_from_rest_and_gives_the_same(quick_cycle: Scenario) -> None:
    run = Simulation(quick_cycle)
    for one, other in zip(run, run, strict=True):  # two at once, and none disturbs the other
        assert_equal_steps(one, other)


def test_breaking_out_of_the_loop_leaves_nothing_behind(quick: Scenario) -> None:
    run = Simulation(quick)
    first = list(islice(run, 20))
    for one, other in zip(first, islice(run, 20), strict=True):
        assert_equal_steps(one, other)
    assert len(run.run()) == len(run)


def test_run_gives_what_the_loop_yields(quick: Scenario) -> None:
    run, seen = Simulation(quick), []
    results = run.run(lambda loop: (seen.append(step.index) or step for step in loop))
    assert seen == list(range(51))  # and the loop may be wrapped, as a progress bar does
    for row, step in enumerate(run):
        for name in ("time", *SCALARS, *FIELDS):
            np.testing.assert_array_equal(getattr(results, name)[row], getattr(step, name))
    assert results.stop_reason == "completed"
    assert results.spacing == run.kernel.spacing


def test_later_changes_of_the_scenario_do_not_reach_the_simulation(quick: Scenario) -> None:
    expected, run = forces(quick), Simulation(quick)
    quick.road.seed, quick.tread.static_modulus, quick.loading.rate = 2, 1e6, 1.0
    np.testing.assert_array_equal(run.run().contact_force, expected)
    assert run.scenario.road.seed == 1


def test_what_was_yielded_is_not_changed_by_later_steps(quick_cycle: Scenario) -> None:
    steps, copies = [], []
    for step in Simulation(quick_cycle):
        steps.append(step)
        copies.append(arrays(step))
    for step, copy in zip(steps, copies, strict=True):
        for name, values in copy.items():
            np.testing.assert_array_equal(getattr(step, name), values)


def test_what_the_receiver_does_to_a_step_does_not_reach_the_next(quick: Scenario) -> None:
    expected, found = forces(quick), []
    for step in Simulation(quick):
        found.append(step.contact_force)
        for name in FIELDS:
            getattr(step, name)[:] = 0
    np.testing.assert_array_equal(found, expected)


def test_no_two_steps_share_an_array(quick_cycle: Scenario) -> None:
    quick_cycle.numerics.param.update(kernel="static", initial_guess="last")
    steps = list(Simulation(quick_cycle))
    for one, other in pairwise(steps):
        assert not any(np.shares_memory(getattr(one, n), getattr(other, n)) for n in FIELDS)


def test_the_quasi_static_companion_follows_the_same_path_in_fewer_steps(
    quick_cycle: Scenario,
) -> None:
    dynamic = Simulation(quick_cycle)
    still = dynamic.quasi_static(30)
    results = still.run()
    assert len(still) == len(results)
    assert 25 <= len(results) <= 33  # equally spaced, both ends of the hold, and the last
    assert set(still.schedule.drive) <= set(dynamic.schedule.drive)
    assert still.schedule.drive[[0, -1]].tolist() == dynamic.schedule.drive[[0, -1]].tolist()
    assert still.schedule.drive.max() == dynamic.schedule.drive.max()
    assert results.converged.all()
    assert still.patch is dynamic.patch
    assert still.kernel.lags == 1
    assert dynamic.scenario.numerics.kernel == "passive"


def test_the_robust_solver_stops_where_it_does_not_converge_and_says_so(quick: Scenario) -> None:
    quick.numerics.max_iterations = 1
    results = Simulation(quick).run()
    assert len(results) < 51
    assert results.failed_at == len(results) - 1
    residual = results.residual[-1]
    assert results.stop_reason.startswith(
        f"not converged at step {results.failed_at} after 1 iterations: residual {residual:.2g} m"
    )
    assert results.stop_reason.endswith("a slower loading or more max_iterations")


def test_the_solver_of_the_thesis_goes_on_where_it_does_not_converge(quick: Scenario) -> None:
    quick.numerics.param.update(max_iterations=1, solver="thesis")
    results = Simulation(quick).run()
    assert len(results) == 51
    assert results.failed_at is not None
    assert results.stop_reason == "completed"


def test_a_tread_displaced_by_more_than_itself_ends_the_run(quick: Scenario) -> None:
    quick.springs.youngs_modulus = 1e10
    quick.numerics.param.update(kernel="band-limited", solver="thesis", max_iterations=1)
    results = Simulation(quick).run()
    assert 1 < len(results) < len(Simulation(quick))
    assert results.stop_reason.startswith(f"diverged at step {len(results) - 1}: ")
    largest = np.abs(results.displacement).max(axis=(1, 2))
    assert np.all(largest[:-1] <= quick.tread.thickness)
    assert largest[-1] > quick.tread.thickness


def test_a_displacement_that_is_no_number_ends_the_run(
    quick: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    advance, nothing = simulation.advance, {"displacement": np.full(36, np.nan)}
    monkeypatch.setattr(simulation, "advance", lambda *known: replace(advance(*known), **nothing))
    assert Simulation(quick).run().stop_reason.startswith("diverged at step 0: ")


def test_ctrl_c_keeps_what_was_computed(quick: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    expected, advance, calls = forces(quick), simulation.advance, iter(range(100))

    def interrupted(*arguments: Any) -> Any:
        if next(calls) == 10:
            raise KeyboardInterrupt
        return advance(*arguments)

    monkeypatch.setattr(simulation, "advance", interrupted)
    results = Simulation(quick).run()
    assert results.stop_reason == "stopped by the user"
    np.testing.assert_array_equal(results.contact_force, expected[:10])


def test_what_a_consumer_recorded_is_collected(quick: Scenario) -> None:
    run = Simulation(quick)
    record = Record(len(run), run.bodies.kernel.shape)
    for step in islice(run, 7):
        record.append(step)
    results = run.collect(record, "enough")
    assert (len(results), results.stop_reason) == (7, "enough")


def from_file(scenario: Scenario, heights: np.ndarray, pitch: float, file: Path) -> Results:
    np.save(file, heights)
    scenario = scenario.copy()
    scenario.road.param.update(file=str(file), pitch=pitch, height_unit="m", levelling="none")
    return Simulation(scenario).run()


def test_a_mirrored_or_turned_road_gives_mirrored_or_turned_forces(
    quick_cycle: Scenario, tmp_path: Path
) -> None:
    patch, made = assembly.road_patch(quick_cycle.road), Simulation(quick_cycle).run()
    for turn in (np.asarray, np.fliplr, np.flipud, np.transpose):
        found = from_file(quick_cycle, turn(patch.heights), patch.pitch, tmp_path / "road.npy")
        turned = [turn(force) for force in made.element_force]
        # the residual of 1e-14 m on springs of up to 1e6 N/m, and neighbours of the element
        np.testing.assert_allclose(found.element_force, turned, atol=1e-6)


def test_lags_beyond_the_tail_do_not_matter(quick: Scenario) -> None:
    """Pressed in 2 ms and held for 6 ms, a cycle longer than 256 lags of 5 ms."""
    quick.loading.param.update(rate=0.05, profile="load-hold-unload", hold_time=6e-3)
    quick.loading.param.update(unloading_rate=10.0, retraction=0.0)
    quick.numerics.lags = 384
    longest = forces(quick)[: int(8e-3 * 51200)]
    for lags in (64, 256):
        quick.numerics.lags = lags
        error = np.abs(forces(quick)[: len(longest)] - longest).max() / longest.max()
        kernel = assembly.tread_kernel(quick)
        # creep beyond the last lag is moved into the last quarter of the lags: the force changes
        # by no more than the share of the compliance that comes too early
        late = kernel.values[3 * lags // 4 :].sum(axis=0)
        assert error < late[0, 0] / kernel.static_compliance[0, 0]
    assert error < 6e-3  # with 256 lags a power law leaves 0.55 % to come after 5 ms


def test_half_the_time_step_gives_nearly_the_same(quick: Scenario) -> None:
    quick.loading.rate = 0.0256  # 200 steps
    coarse = forces(quick)
    quick.numerics.time_resolution_factor = 2
    # second order in the time step of 1/200 of the path: some 1e-4 where contacts come in fast
    np.testing.assert_allclose(forces(quick)[::2], coarse, atol=1e-3 * coarse.max())


def test_a_run_that_creates_energy_is_stopped_even_while_newton_converges(quick: Scenario) -> None:
    """A tread at rest can give back no more than it was given; an unstable scheme does."""
    quick.springs.youngs_modulus = 1e9
    quick.numerics.param.update(kernel="band-limited", max_iterations=200)
    results = Simulation(quick).run()
    assert results.stop_reason.startswith("unstable at step")
    assert results.converged.all()
    assert results.failed_at == len(results) - 1
    assert results.final_stiffness is None
    work = np.diff(results.displacement, axis=0) * results.element_force[1:]
    assert np.cumsum(work.sum(axis=(1, 2)))[-1] < 0
    quick.numerics.kernel = "passive"
    assert Simulation(quick).run().stop_reason == "completed"


def test_the_stability_margin_is_kept_from_one_evaluation_to_the_next(quick: Scenario) -> None:
    quick.numerics.kernel = "band-limited"
    every = Simulation(quick).run().stability_margin
    quick.numerics.margin_interval = 10
    seldom = Simulation(quick).run().stability_margin
    # its eigenvalue is found to 1e-3, from another start
    np.testing.assert_allclose(seldom[:40], np.repeat(every[:40:10], 10), atol=3e-3)
    assert every[-1] < 1
