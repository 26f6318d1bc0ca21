"""The same road cut into more and more elements: the force goes to a limit, from above.

An element reaches out to its highest point, and its spring stands for what lies below; the more
elements, the more of that the tread itself resolves.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation
from tyrecontact.road import textures

SIZE, PIXEL, INDENTATION = 8e-3, 25e-6, 40e-6


@pytest.fixture
def road_file(tmp_path: Path, shortest: float) -> Path:
    """A self-affine road of 8 um rms with wavelengths from `shortest` [m] up to 4 mm."""
    road = textures.self_affine(
        SIZE, PIXEL, 8e-6, roll_off_wavelength=4e-3, cut_off_wavelength=shortest, seed=3
    )
    np.save(tmp_path / "road.npy", road.heights)
    return tmp_path / "road.npy"


def forces(road_file: Path, elements: int) -> np.ndarray:
    """At a half and at all of the indentation [N], the tread at rest, 2 mm thick."""
    scenario = Scenario(
        road={
            "file": str(road_file), "pitch": PIXEL, "height_unit": "m", "levelling": "none",
            "size": SIZE, "elements": elements,
        },
        tread={"thickness": 2e-3, "base_thickness": 1e-5},
        loading={"max_indentation": INDENTATION, "rate": INDENTATION * 51200 / 2},
        numerics={"kernel": "static", "tolerance": 1e-8},
    )  # fmt: skip
    results = Simulation(scenario).run()
    assert results.converged.all()
    np.testing.assert_allclose(results.indentation[1:], [INDENTATION / 2, INDENTATION])
    return results.contact_force[1:]


@pytest.mark.parametrize(
    ("shortest", "counts", "shrinks"),
    [
        (1e-3, (10, 20, 40, 80), 0.6),  # all wavelengths resolved at the end: first order, 0.5
        (50e-6, (10, 20, 40), 0.75),  # never: heights within an element go as its side^H, 0.57
    ],
)
def test_more_elements_bring_the_force_to_a_limit(
    road_file: Path, counts: tuple[int, ...], shrinks: float
) -> None:
    force = np.array([forces(road_file, count) for count in counts])
    change = -np.diff(force, axis=0)
    assert np.all(change > 0)
    # the coarsest elements are not yet in step with the order: hence a fifth and a third more
    assert np.all(change[1:] < shrinks * change[:-1])
    assert change[-1, -1] < 0.06 * force[-1, -1]
