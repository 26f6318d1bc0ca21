"""The direct method itself: its sums written out, and what it says where Newton fails."""

from __future__ import annotations

import numpy as np
import pytest

from tests.benchmarks import direct
from tests.benchmarks.direct import DenseTread, DirectMethod, NotConvergedError
from tyrecontact import Scenario, Simulation
from tyrecontact.tread.kernels import Kernel

LAGS, NY, NX = 4, 2, 3


@pytest.mark.parametrize("kept", [0.0, 1e9])
def test_displacements_are_sums_over_lags_and_elements(
    monkeypatch: pytest.MonkeyPatch, kept: float
) -> None:
    """Whether the matrices are kept or formed anew."""
    monkeypatch.setattr(direct, "_KEPT_BYTES", kept)
    random = np.random.default_rng(1)
    values, forces = random.normal(size=(LAGS, NY, NX)), random.normal(size=(6, NY, NX))
    tread = DenseTread(Kernel(values, 1e-3, 1e-5))
    for force in forces:
        tread.remember(force.ravel(), at_rest=False)
    expected = np.zeros((NY, NX))
    for lag, i, j, p, q in np.ndindex(LAGS, NY, NX, NY, NX):
        if lag > 0:
            expected[i, j] += values[lag, abs(i - p), abs(j - q)] * forces[6 - lag, p, q]
    np.testing.assert_allclose(tread.displacement(), expected.ravel(), atol=1e-13)  # rounding


def test_forces_that_have_always_acted_do_what_the_kernel_at_rest_does() -> None:
    values, force = np.random.default_rng(1).normal(size=(LAGS, NY, NX)), np.arange(6.0)
    tread = DenseTread(Kernel(values, 1e-3, 1e-5))
    tread.remember(force, at_rest=True)
    found = tread.displacement() + tread.matrix(0) @ force
    np.testing.assert_allclose(found, tread.at_rest() @ force, atol=1e-13)  # rounding


def test_a_residual_that_cannot_be_reached_is_an_error(quick: Scenario) -> None:
    with pytest.raises(NotConvergedError, match="not converged to 0 m in 100 iterations"):
        list(DirectMethod(Simulation(quick), tolerance=0.0))
