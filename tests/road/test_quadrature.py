"""Gauss-Legendre rules on [0, 1]."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.road.quadrature import PANEL, gauss, panels


@pytest.mark.parametrize("count", [4, 22, 64])
def test_polynomials_of_twice_the_order_are_integrated_exactly(count: int) -> None:
    x, weight = gauss(count)
    for power in (0, 1, 2 * count - 1):
        assert weight @ x**power == pytest.approx(1 / (power + 1), rel=1e-12)  # rounding


@pytest.mark.parametrize("least", [1, 64, 65, 1000.5])
def test_panels_integrate_what_oscillates(least: float) -> None:
    x, weight = panels(least)
    assert PANEL > x.size - least >= 0
    assert x.size % PANEL == 0
    assert np.all(np.diff(x) > 0)
    # two nodes a wave and a few more are enough
    wave = np.pi * (x.size - 20) / 1.5
    assert weight @ np.cos(wave * x) == pytest.approx(np.sin(wave) / wave, abs=1e-12)
