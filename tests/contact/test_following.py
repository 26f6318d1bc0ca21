"""The worst pattern of force followed from step to step, against dense matrices."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import pytest

from tyrecontact.contact.lattice import Compliance
from tyrecontact.contact.stability import StabilityMargin
from tyrecontact.tread import kernels
from tyrecontact.tread.kernels import Kernel, band_limited, interpolated
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

SIDE = 16
#: documented accuracy, per 1 + lambda
ACCURACY = 1e-3


@pytest.fixture(scope="module", params=[1, 4])
def kernel(request: pytest.FixtureRequest) -> Kernel:
    """Worst where the force changes sign every step, and where it does not."""
    rubber = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499)
    base = Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33)
    coarse = band_limited([rubber, base], (SIDE, SIDE), 1e-3, 1 / 51200, lags=64)
    return interpolated(coarse, request.param)


@pytest.fixture
def products(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Numbers of elements of all products with the power that are asked for."""
    asked: list[int] = []
    product = Compliance.displacement

    def counted(self: Compliance, force: np.ndarray) -> np.ndarray:
        asked.append(force.size)
        return product(self, force)

    monkeypatch.setattr(Compliance, "displacement", counted)
    return asked


def largest_error(kernel: Kernel, steps: Iterable[np.ndarray]) -> float:
    """Of the margins of one step after another, per 1 + lambda."""
    margin, angle = StabilityMargin(kernel), kernels.critical_angle(kernel)
    power = Compliance(kernels.hermitian_symbol(kernel, angle) / (1 - np.cos(angle)))
    matrix, errors = power.matrix(np.arange(SIDE**2)), []
    for stiffness in steps:
        root = np.sqrt(stiffness.ravel())
        largest = max(np.linalg.eigvalsh(-root[:, None] * matrix * root)[-1], 0.0)
        errors.append(abs(margin.of(stiffness.ravel()) - (1 - largest)) / (1 + largest))
    return max(errors)


def patches(first: float, second: float, soft: float = 1e4) -> np.ndarray:
    """Soft springs of all kinds, and two far patches of stiff ones [N/m]."""
    stiffness = soft * np.random.default_rng(3).lognormal(0, 0.7, (SIDE, SIDE))
    stiffness[1:7, 1:7] += first
    stiffness[9:15, 9:15] += second
    return stiffness


def test_springs_that_stiffen_slowly_cost_few_products(kernel: Kernel, products: list[int]) -> None:
    steps = [patches(1e5, 2e5) * 1.02**i for i in range(30)]
    assert largest_error(kernel, steps) < ACCURACY
    assert len(products) < 100 + 8 * 29  # the first one from scratch


@pytest.mark.parametrize("soft", [1e3, 1e4])
def test_a_mode_elsewhere_that_overtakes_is_seen_in_the_step_in_which_it_does(
    kernel: Kernel, soft: float
) -> None:
    steps = [patches(3e5 * (1 - i / 80), 3e5 * (0.5 + i / 60), soft) for i in range(50)]
    assert largest_error(kernel, steps) < ACCURACY


def test_a_patch_that_is_there_all_at_once_is_seen(kernel: Kernel) -> None:
    """So little of the stiffness that it does not begin from scratch, and much more than that."""
    for share in (0.09, 10.0):
        before, after = patches(2e5, 0), patches(2e5, 0)
        after[12:15, 12:15] += share * before.sum() / 9
        assert largest_error(kernel, [before] * 3 + [after] * 3) < ACCURACY


def test_contacts_that_part_take_their_mode_with_them(kernel: Kernel) -> None:
    whole, parted = patches(3e5, 2.5e5), patches(3e5, 2.5e5)
    parted[3:5, 2:5] = 0
    few = np.where(np.arange(SIDE**2).reshape(SIDE, SIDE) < 90, whole, 0)
    assert largest_error(kernel, [whole, whole, parted, parted, few, whole]) < ACCURACY


def test_springs_that_change_wildly_are_judged_from_scratch(kernel: Kernel) -> None:
    random = np.random.default_rng(5)
    steps = [random.lognormal(11, 1.5, SIDE**2) * (random.random(SIDE**2) < 0.7) for _ in range(12)]
    assert largest_error(kernel, steps) < ACCURACY
