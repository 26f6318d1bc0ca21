"""kappa as a caller meets it: shapes, order, and what is refused (limits: tests/analytical)."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.road.punch import stiffness_factor


@pytest.mark.parametrize("bonded", [False, True])
def test_a_very_small_punch_feels_a_half_space(bonded: bool) -> None:
    assert stiffness_factor(np.array(0.0), bonded=bonded) == 1.0


@pytest.mark.parametrize("shape", [(), (5,), (2, 3)])
def test_the_shape_is_that_of_the_ratios(shape: tuple[int, ...]) -> None:
    assert np.shape(stiffness_factor(np.full(shape, 0.7))) == shape


@pytest.mark.parametrize(
    ("poissons_ratio", "bonded"),
    [(0.0, False), (0.3, False), (0.5, False), (0.3, True), (0.5, True)],
)
def test_kappa_rises_with_the_radius(poissons_ratio: float, bonded: bool) -> None:
    ratios = np.concatenate([[0.0], np.geomspace(1e-5, 300, 4000)])
    assert np.all(np.diff(stiffness_factor(ratios, poissons_ratio, bonded)) > 0)


def test_kappa_rises_with_poissons_ratio() -> None:
    values = [float(stiffness_factor(np.array(1.5), nu)) for nu in (0.0, 0.2, 0.4, 0.49, 0.5)]
    assert values == sorted(values)


@pytest.mark.parametrize("bonded", [False, True])
@pytest.mark.parametrize("ratio", [1e-3, 64.0])
def test_kappa_does_not_jump_where_the_table_ends(ratio: float, bonded: bool) -> None:
    step = 1e-6
    below, above = stiffness_factor(ratio * np.array([1 - step, 1 + step]), bonded=bonded)
    # no rule for kappa rises faster than the cube, hence by 3 x 2 steps; twice that is a jump
    assert above / below - 1 < 12 * step


@pytest.mark.parametrize("ratio", [-0.1, np.nan])
def test_a_ratio_that_is_no_ratio_is_refused(ratio: float) -> None:
    with pytest.raises(InputError, match="radius_over_thickness"):
        stiffness_factor(np.array([1.0, ratio]))


@pytest.mark.parametrize("poissons_ratio", [-0.1, 0.51, np.nan])
def test_an_impossible_poissons_ratio_is_refused(poissons_ratio: float) -> None:
    with pytest.raises(InputError, match="poissons_ratio"):
        stiffness_factor(np.array([1.0]), poissons_ratio)
