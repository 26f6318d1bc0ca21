"""A function that is not asked twice about the same objects."""

from __future__ import annotations

import numpy as np

from tyrecontact.contact.latest import Latest


def test_only_what_is_identical_is_not_computed_again() -> None:
    asked: list[float] = []

    def total(values: np.ndarray, scale: float) -> float:
        asked.append(values.sum() * scale)
        return asked[-1]

    latest, one, same = Latest(total), np.ones(3), np.ones(3)
    unit, double = 1.0, 2.0
    assert latest(one, unit) == latest(one, unit) == 3
    assert len(asked) == 1
    assert latest(same, unit) == 3  # equal, but another one
    assert latest(one, double) == 6
    assert latest(one, unit) == 3
    assert len(asked) == 4
