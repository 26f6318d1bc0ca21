"""The kernel that goes into a run: in time, at rest, and where it becomes unstable."""

from __future__ import annotations

import numpy as np

from app.views.input_kernel import SHOWN, KernelInput
from app.views.style import DESK
from tyrecontact import Scenario, Simulation
from tyrecontact.tread.kernels import critical_stiffness


def _curves(plot: object) -> list:
    """Points of each layer of a plot."""
    return [np.column_stack([layer.dimension_values(0), layer.dimension_values(1)])
            for layer in plot.object]  # fmt: skip


def test_before_and_after_resampling(small: Scenario) -> None:
    small.numerics.param.update(kernel="band-limited", time_resolution_factor=2)
    simulation = Simulation(small)
    shown = KernelInput.of(simulation)
    assert shown.coarse is not None
    np.testing.assert_allclose(shown.coarse.time_step, 2 * shown.kernel.time_step)
    coarse, fine, marks = _curves(shown.draw_impulse("loaded element", DESK))
    # the thesis draws a line between the samples: every second one is an old one
    np.testing.assert_allclose(fine[::2][: len(coarse)], coarse, rtol=1e-9)
    np.testing.assert_array_equal(fine, marks)
    assert fine[-1, 0] <= SHOWN * 1e3
    kernel = simulation.kernel
    np.testing.assert_allclose(fine[3, 1], kernel.values[3, 0, 0] / kernel.time_step)
    assert "grey: before resampling" in shown.sheet().caption


def test_creep_ends_at_the_compliance_at_rest(small: Scenario) -> None:
    shown = KernelInput.of(Simulation(small))
    assert shown.coarse is None
    rest = shown.kernel.static_compliance * 1e6
    loaded, beside, corner = _curves(shown.draw_creep(DESK))
    np.testing.assert_allclose(
        [loaded[-1, 1], beside[-1, 1], corner[-1, 1]], [rest[0, 0], rest[0, 1], rest[1, 1]]
    )
    along, _ = _curves(shown.draw_distance(DESK))
    np.testing.assert_allclose(along[:, 1], rest[0])
    np.testing.assert_allclose(along[:, 0], range(6))


def test_what_springs_it_stands_is_said(small: Scenario) -> None:
    passive = KernelInput.of(Simulation(small))
    assert passive.critical == np.inf
    assert passive.facts["Critical stiffness"] == "none: unconditionally stable"
    assert passive.sheet().caption.endswith("make its time stepping unstable.")
    small.numerics.kernel = "band-limited"
    simulation = Simulation(small)
    limited = KernelInput.of(simulation)
    assert limited.critical == critical_stiffness(simulation.kernel, (6, 6))
    assert limited.facts["Critical stiffness"].endswith(" kN/m")
    assert limited.sheet().caption.endswith(" kN/m each.")


def test_the_tread_at_rest_has_no_time(small: Scenario) -> None:
    small.numerics.kernel = "static"
    shown = KernelInput.of(Simulation(small))
    assert "Time step" not in shown.facts
    assert len(shown.sheet().plots) == 1
    assert len(_curves(shown.sheet().plots[0](DESK))[0]) == 6
