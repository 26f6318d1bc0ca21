"""A scan of a hundred megabytes comes in pieces, is understood, and becomes the road."""

from __future__ import annotations

import io

import numpy as np

from tests.app.test_road_file import Taken
from tyrecontact.assembly.road import road_patch
from tyrecontact.parts.road import Road


def test_a_hundred_megabytes_become_the_road() -> None:
    across = np.linspace(0.0, 70.0, 3550)
    heights = 0.2 * np.sin(across)[:, None] * np.cos(across)[None, :]  # mm
    file = io.BytesIO()
    np.save(file, heights)
    assert file.getbuffer().nbytes > 100e6
    taken = Taken()
    taken.upload("large.npy", file.getvalue())
    assert taken.refusals == []
    taken.fill(pitch=20.0, height_unit="mm")
    assert "71.0 × 71.0 mm" in taken.dialog.facts.object
    taken.control.use()
    (settings,) = taken.roads
    assert settings["road.pitch"] == 20e-6
    road = Road(**{path.removeprefix("road."): value for path, value in settings.items()})
    patch = road_patch(road)
    assert patch.rms > 0
    # the heights of the file, whose range is 0.4 mm, tilted by levelling at the most
    assert 0.3e-3 < np.ptp(patch.heights) < 0.5e-3
    taken.control.close()
