"""The springs that go into a run: curves, the exchanged ones, and what is drawn apart."""

from __future__ import annotations

import numpy as np
import pytest

from app.views.input_springs import MOST, SpringsInput
from app.views.style import DESK
from tyrecontact import Scenario, Simulation


def test_curves_are_those_of_the_springs(small: Scenario) -> None:
    simulation = Simulation(small)
    springs = SpringsInput.of(simulation)
    assert springs.force.shape == springs.stiffness.shape == (36, springs.compression.size)
    number = springs.element @ [6, 1]
    assert sorted(number) == list(range(36))
    at = np.full(36, springs.compression[30] * 1e-6)
    np.testing.assert_allclose(springs.force[:, 30], simulation.springs.force(at)[number])
    stiffness = simulation.springs.stiffness(at)[number] / 1e3
    np.testing.assert_allclose(springs.stiffness[:, 30], stiffness)
    assert not springs.exchanged.any()
    assert springs.facts["Exchanged for softer ones"] == "none"
    assert springs.apart_label == "the median spring"


def test_the_exchanged_ones_are_drawn_dashed_as_they_were(small: Scenario) -> None:
    small.springs.exchange_count = 5
    springs = SpringsInput.of(Simulation(small))
    assert springs.exchanged.sum() == springs.swapped.sum() == 5
    assert springs.ranked[springs.swapped].mean() > springs.ranked[~springs.swapped].max() / 2
    assert springs.facts["Exchanged for softer ones"] == "5, ranked at 9.00 µm"
    plots = [draw(DESK) for draw in springs.sheet().plots]
    force = plots[0].object
    lines = {item.label.value: item.renderers[0] for item in force.legend[0].items}
    dashed = lines["exchanged for softer"]
    assert len(dashed.data_source.data["row"]) == 5
    assert dashed.glyph.line_dash == "dashed"
    assert len(lines["as read"].data_source.data["row"]) == 31
    assert len(plots[2].object) == 2
    assert "Fig. 23" in springs.sheet().caption


@pytest.mark.parametrize("kind", ["mean", "standard", "linear"])
def test_simplified_springs_lie_upon_those_they_stand_for(small: Scenario, kind: str) -> None:
    plain = SpringsInput.of(Simulation(small))
    small.springs.simplification = kind
    simulation = Simulation(small)
    springs = SpringsInput.of(simulation)
    np.testing.assert_array_equal(springs.force, plain.force)
    at = np.full(36, springs.compression[30] * 1e-6)
    used = simulation.springs.force(at)
    np.testing.assert_allclose(np.sort(springs.apart[0][:, 30]), np.sort(used))
    assert springs.apart_label.endswith("used")


def test_no_more_springs_are_drawn_than_can_be_told_apart() -> None:
    many = Scenario(road={"elements": 24, "size": 24e-3, "pixel": 1e-4}, numerics={"lags": 32})
    springs = SpringsInput.of(Simulation(many))
    assert len(springs.force) == MOST
    assert springs.facts["Springs"] == "576, 400 drawn"
    assert springs.ranked.size == 576
