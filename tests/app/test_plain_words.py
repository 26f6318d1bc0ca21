"""What is said of a run, in plain words."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from app.plain_words import describe, duration, three_digits
from app.runner import Phase, Run
from tyrecontact import Scenario


def test_what_is_coming_is_said_before_it_comes(finished: Run) -> None:
    assert "all converged" in describe(finished)[0]
    finished.record.columns["stability_margin"][20] = -0.3
    sentence, bad = describe(finished)
    assert not bad
    place = finished.record.columns["indentation"][20] * 1e6
    assert f"from {place:.1f} µm on the springs are too stiff" in sentence


def test_a_failed_step_is_described_with_place_size_cause_and_advice(finished: Run) -> None:
    columns = finished.record.columns
    columns["converged"][10] = 0
    columns["stability_margin"][8] = -0.3
    finished.scenario.numerics.kernel = "band-limited"
    finished.record.fields(10)[1]["element_force"][2, 4] += 50.0
    sentence, bad = describe(finished)
    assert bad
    assert "1 not converged, the first at step 11 and " in sentence
    assert "residual" in sentence
    assert "worst at row 2, column 4" in sentence
    assert f"From {columns['indentation'][8] * 1e6:.1f} µm on the band-limited kernel" in sentence
    assert "try time-resolution factor 2, or the passive kernel" in sentence


def test_a_step_at_which_a_run_had_to_end_is_counted_as_on_the_rest_of_the_page(
    finished: Run,
) -> None:
    finished.record.stop_reason = "diverged at step 41: the tread is displaced"
    assert describe(finished)[0].startswith("Diverged at step 42: the tread")


def test_a_step_that_fails_without_an_instability_gets_other_advice(finished: Run) -> None:
    finished.record.columns["converged"][10] = 0
    sentence, _ = describe(finished)
    assert "unstable" not in sentence
    assert "more iterations" in sentence


def test_why_a_run_had_to_end_early_is_said(finished: Run) -> None:
    finished.phase = Phase.STOPPED
    finished.message = "stopped after 60 s, the longest that this server computes"
    assert "the longest that this server computes" in describe(finished)[0]


def test_that_there_is_nothing_to_compare_with_is_said(finished: Run) -> None:
    finished.message = "no quasi-static run to compare with: no balance"
    assert "No quasi-static run to compare with" in describe(finished)[0]


def test_a_run_without_a_step_is_at_none(
    small: Scenario, wait_for: Callable[[Callable[[], bool]], None]
) -> None:
    run = Run(small, paused=True)
    run.start()
    wait_for(lambda: run.record is not None and run.phase is Phase.PAUSED)
    assert describe(run) == ("Paused before the first step.", False)
    run.stop()
    assert run.join(60)
    assert describe(run)[0].startswith("Stopped before the first step.")


def test_a_run_out_of_time_before_its_first_step_says_so(small: Scenario) -> None:
    run = Run(small)
    run.phase, run.message = Phase.STOPPED, "stopped after 60 s, the longest"
    assert "Stopped after 60 s" in describe(run)[0]


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (0.0, "0"),
        (203.79, "204"),
        (2234.9, "2230"),
        (0.6042, "0.604"),
        (35.0, "35.0"),
        (2.9, "2.90"),
        (1e-9, "1.00e−09"),
        (-0.25, "−0.250"),
    ],
)
def test_numbers_have_three_significant_digits(value: float, shown: str) -> None:
    assert three_digits(value) == shown


@pytest.mark.parametrize(
    ("seconds", "said"), [(0.2, "1 s"), (42.3, "42 s"), (600.0, "10 min"), (7200.0, "2.0 h")]
)
def test_times_are_said_as_people_say_them(seconds: float, said: str) -> None:
    assert duration(seconds) == said
