"""The scale of a map's colours: halves of their own, short limits, labels that tell the truth."""

from __future__ import annotations

import numpy as np
import pytest

from app.views.map_scale import Scale, leap


@pytest.mark.parametrize(
    ("value", "limit"),
    [(1.0, 1.0), (1.01, 1.2), (3.58, 4.0), (9.9, 10.0), (0.057, 0.06), (19.8e3, 20e3), (0.3, 0.3)],
)
def test_limits_are_short_numbers(value: float, limit: float) -> None:
    assert leap(value) == pytest.approx(limit)


def test_each_half_is_linear_by_itself_and_labelled_so() -> None:
    scale = Scale().holding(-0.6, 10.0, room=1.0)
    assert (scale.low, scale.high) == (pytest.approx(-0.6), 10.0)
    placed = scale.place(np.array([-0.6, -0.3, 0.0, 5.0, 10.0, np.nan]))
    np.testing.assert_allclose(placed, [-1, -0.5, 0, 0.5, 1, np.nan])
    for at, label in scale.ticks.items():
        assert scale.place(np.array([float(label.replace("−", "-"))]))[0] == pytest.approx(at)
    assert len(scale.palette) == 512


def test_magnitudes_have_one_half() -> None:
    scale = Scale().holding(0.0, 3.9, room=1.0)
    assert list(scale.ticks.values()) == ["0", "1", "2", "3", "4"]
    assert len(scale.palette) == 256


def test_a_scale_only_grows() -> None:
    scale = Scale().holding(-1.0, 5.0)
    assert scale.holding(-0.5, 2.0) is scale
    assert scale.holding(-9.0, 2.0).high == scale.high
    assert scale.holding(-np.inf, np.inf) is scale
    fixed = Scale(0.0, 4.0, fixed=True).holding(-0.2, 50.0)
    assert (fixed.low, fixed.high) == (pytest.approx(-0.3), 4.0)
