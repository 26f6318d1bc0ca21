"""From settings to the path of the road."""

from __future__ import annotations

import numpy as np
import pytest

from tyrecontact import assembly
from tyrecontact.parts.process import Loading


@pytest.mark.parametrize(
    ("change", "duration", "end"),
    [
        ({"profile": "linear"}, 0.2e-3 / 0.03, 0.2e-3),
        ({"profile": "quadratic"}, np.sqrt(0.2e-3 / 4.5), 0.2e-3),
        ({"profile": "load-hold-unload"}, 0.2e-3 / 0.03 + 2e-3 + 0.4e-3 / 0.003, -0.2e-3),
    ],
)
def test_each_profile_takes_its_settings(
    change: dict[str, str], duration: float, end: float
) -> None:
    path = assembly.loading_path(Loading(**change))
    assert path.time[-1] == pytest.approx(duration, rel=1e-12)  # rounding of sums
    assert path.drive[-1] == end
