"""Scenarios that no one would think of, for what must take any."""

from __future__ import annotations

import random
from typing import Any

import param

from tyrecontact import Scenario
from tyrecontact.settings import Choice, Count, Tables, Text

#: a tread of three layers, each of a kind of its own
LAYERS: list[dict[str, Any]] = [
    {
        "thickness": 1 / 300, "density": 1100.0, "poissons_ratio": 0.49,
        "material": "fractional-zener", "static_modulus": 8e6, "glassy_modulus": 2.5e9,
        "exponent": 0.5, "relaxation_time": 3.717e-6,
    },
    {
        "thickness": 7e-3, "density": 1300, "poissons_ratio": -0.1, "material": "tabulated",
        "modulus_table": "",
    },
    {
        "thickness": 3e-3, "density": 2700.0, "poissons_ratio": 0.33,
        "material": "nearly-constant-loss", "youngs_modulus": 72e9, "loss_factor": 5e-5,
    },
]  # fmt: skip


def random_scenario(chance: random.Random, share: float = 1.0) -> Scenario:
    """A scenario of which a share of the settings is anything in bounds; no files, no layers.

    Each value can be; whether they go together is another matter.
    """
    scenario = Scenario()
    for path, parameter, _ in scenario.settings():
        if not isinstance(parameter, Text | Tables) and chance.random() < share:
            scenario.set(path, _anything(parameter, chance))
    return scenario


def _anything(parameter: param.Parameter, chance: random.Random) -> Any:
    if isinstance(parameter, Choice):
        return chance.choice(parameter.objects)
    low, high = parameter.bounds
    if isinstance(parameter, Count):
        return chance.randint(low, high)
    return chance.choice(
        [low, high, chance.uniform(low, high), float(f"{chance.uniform(low, high):.2e}")]
    )
