"""The margin of the time stepping: one where the kernel is passive, nil where runs blow up."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.contact.lattice import LatticeKernel
from tyrecontact.contact.stability import StabilityMargin
from tyrecontact.tread.kernels import (
    Kernel,
    band_limited,
    critical_angle,
    critical_stiffness,
    interpolated,
    passive,
    static,
)
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

SHAPE = (10, 10)
LAYERS = [
    Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499),
    Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33),
]


@pytest.fixture(scope="module")
def coarse() -> Kernel:
    return band_limited(LAYERS, SHAPE, 1e-3, 1 / 51200, lags=64)


def of(kernel: Kernel, stiffness: float, **touching: np.ndarray) -> float:
    contact = touching.get("contact", np.ones(kernel.values[0].size))
    return StabilityMargin(kernel).of(stiffness * contact)


@pytest.mark.parametrize("share", [0.1, 0.9, 1.0, 1.5])
def test_equal_springs_in_full_contact_have_the_margin_of_the_critical_stiffness(
    coarse: Kernel, share: float
) -> None:
    """1 - k / k_crit."""
    found = of(coarse, share * critical_stiffness(coarse, SHAPE))
    assert found == pytest.approx(1 - share, abs=2e-3 * (1 + share))  # accuracy of the margin


@pytest.mark.parametrize("factor", [2, 4])
def test_the_margin_of_an_interpolated_kernel_is_that_of_its_worst_angle(
    coarse: Kernel, factor: int
) -> None:
    kernel = interpolated(coarse, factor)
    assert critical_angle(kernel) < 0.9 * np.pi  # not the Nyquist frequency
    limit = critical_stiffness(kernel, SHAPE)
    for share in (0.5, 1.0):
        # both find the angle on a grid and then on a finer one around it
        assert of(kernel, share * limit) == pytest.approx(1 - share, abs=0.01)


def test_a_passive_kernel_has_all_its_margin(coarse: Kernel, tread: LatticeKernel) -> None:
    passive = tread.kernel
    still = static(LAYERS, SHAPE, 1e-3)
    assert of(passive, 1e9) == of(still, 1e9) == 1
    assert StabilityMargin(passive).is_passive
    assert StabilityMargin(still).is_passive
    assert not StabilityMargin(coarse).is_passive


def test_without_contact_nothing_is_fed(coarse: Kernel) -> None:
    assert of(coarse, 0.0) == 1


def test_a_run_that_is_lost_has_no_margin(coarse: Kernel) -> None:
    assert np.isnan(of(coarse, np.nan))
    assert np.isnan(of(coarse, np.inf))


def test_fewer_contacts_and_softer_springs_have_more_margin(coarse: Kernel) -> None:
    margins = [of(coarse, stiffness) for stiffness in (1e4, 3e4, 1e5)]
    assert margins == sorted(margins, reverse=True)
    alone = np.zeros(100)
    alone[45] = 1
    few = np.zeros((10, 10))
    few[2:5, 2:5] = 1
    assert of(coarse, 1e5, contact=alone) >= of(coarse, 1e5, contact=few.ravel()) > margins[-1]


def test_the_margin_is_that_of_the_dense_matrix(coarse: Kernel) -> None:
    """Springs of all kinds, half of them apart, one after the other."""
    rng = np.random.default_rng(1)
    margin, sign = StabilityMargin(coarse), (-1.0) ** np.arange(coarse.lags)
    row, column = np.divmod(np.arange(100), 10)
    offsets = abs(row[:, None] - row), abs(column[:, None] - column)
    feed = -np.tensordot(sign, coarse.values, axes=1)[offsets]
    for _ in range(4):
        stiffness = rng.lognormal(10, 1.5, 100) * (rng.random(100) < 0.5)
        root = np.sqrt(stiffness)
        largest = np.linalg.eigvalsh(root[:, None] * feed * root)[-1]
        # H(pi) / 2 = sum (-1)^n g_n; accuracy of the iteration relative to 1 + largest
        assert margin.of(stiffness) == pytest.approx(1 - largest, abs=3e-3 * (1 + largest))


def test_long_waves_that_only_the_whole_patch_holds_count() -> None:
    """BDF2 at a fine step: 16 x 16 elements are judged passive, 20 x 20 by the same are not."""
    kernel = passive(LAYERS, (20, 20), 1e-3, 1 / 204800, lags=1024)
    limit = critical_stiffness(kernel, (20, 20))
    assert np.isfinite(limit)
    assert not StabilityMargin(kernel).is_passive
    # the limit is sufficient, so that twice as much at the worst angle may well be too much
    assert of(kernel, 2 * limit) < 0
    first_order = passive(LAYERS, (20, 20), 1e-3, 1 / 204800, lags=1024, quadrature="BDF1")
    assert critical_stiffness(first_order, (20, 20)) == np.inf
