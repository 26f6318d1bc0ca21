"""Settings that cannot go together."""

from __future__ import annotations

import pytest

from tyrecontact import Scenario, Simulation
from tyrecontact.errors import InputError

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        (
            {"springs.exchange_count": 19},
            "springs.exchange_count must be at most half .* 18, got 19",
        ),
        (
            {"numerics.kernel": "band-limited", "numerics.time_resolution_factor": 3},
            "numerics.time_resolution_factor must be 1, 2 or 4 for the band-limited .* got 3",
        ),
        (
            {"tread.thickness": 1e-4, "loading.max_indentation": 1e-4},
            "loading.max_indentation must be less than tread.thickness, 0.0001 m, got 0.0001 m",
        ),
        ({"numerics.lags": 25}, "numerics.lags must cover .* 0.503 ms or 26 samples, got 25"),
        ({"numerics.lags": 343}, "numerics.lags must be at most 342, the steps of the .*, got 343"),
        ({"numerics.sampling_frequency": 1e6}, "numerics.lags must cover .* got 256"),
    ],
)
def test_settings_that_cannot_go_together_are_refused_before_the_run(
    changes: dict[str, object], sentence: str
) -> None:
    scenario = Scenario(road=ROAD)
    for path, value in changes.items():
        scenario.set(path, value)
    with pytest.raises(InputError, match=sentence):
        Simulation(scenario)


@pytest.mark.parametrize(
    ("path", "value"),
    [("springs.exchange_count", 18), ("numerics.lags", 26), ("numerics.lags", 342)],
)
def test_settings_that_just_go_together_are_taken(path: str, value: int) -> None:
    scenario = Scenario(road=ROAD)
    scenario.set(path, value)
    assert Simulation(scenario).scenario.to_dict() == scenario.to_dict()


def test_a_sampling_rate_too_slow_for_the_loading_is_told_of_the_loading() -> None:
    scenario = Scenario(road=ROAD, numerics={"sampling_frequency": 10.0, "lags": 2})
    with pytest.raises(InputError, match=r"loading must take 3 to .* steps"):
        Simulation(scenario)


def test_the_fastest_runs_of_the_thesis_may_keep_256_lags() -> None:
    """0.2 mm in 2 ms are 103 steps: lags that no step reaches cost time and change nothing."""
    scenario = Scenario(road=ROAD, loading={"rate": 0.1})
    assert len(Simulation(scenario)) == 103
    assert scenario.numerics.lags == 256
