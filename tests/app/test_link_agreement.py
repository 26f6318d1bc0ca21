"""Of settings that cannot go together as many as can are taken."""

from __future__ import annotations

import random

from app.link_agreement import together
from app.links import KEYS
from tests.app.scenarios import random_scenario
from tyrecontact import Simulation


def test_settings_that_go_together_are_all_taken() -> None:
    scenario, left = together("adhesion", {"loading.rate": 0.05, "numerics.kernel": "static"})
    assert left == []
    assert (scenario.loading.rate, scenario.numerics.kernel) == (0.05, "static")
    assert scenario.loading.profile == "load-hold-unload"


def test_the_last_that_is_in_the_way_of_the_others_is_left() -> None:
    scenario, left = together("default", {"road.elements": 4, "springs.exchange_count": 80})
    assert (scenario.road.elements, scenario.springs.exchange_count) == (4, 0)
    assert left == [
        "springs.exchange_count was left as it is in the preset: springs.exchange_count must be "
        "at most half the elements, 8, got 80"
    ]


def test_what_is_taken_of_anything_can_be_run() -> None:
    for seed in range(6):
        wild = random_scenario(random.Random(seed))
        settings = {path: value for path, _, value in wild.settings() if path in KEYS}
        scenario, left = together("default", settings)
        Simulation(scenario)
        assert len(left) < 10
