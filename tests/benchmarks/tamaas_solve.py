"""One quasi-static elastic contact by Tamaas, on the same grid and of the same share of contacts.

Tamaas (L. Frerot et al., J. Open Source Softw. 5 (2020) 2121; AGPL) is a boundary element library
in C++. It is measured against, and is no dependency.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

TOLERANCE = 1e-8


def solve(elements: int, share: float) -> tuple[Callable[[], float], float, str]:
    """A solve from the start, the contacts per element [-] it ends with, and the version.

    A self-affine surface (Hurst exponent 0.8, rms slope 1) on a half-space of modulus 1, pressed by
    the mean pressure that gives about the share of contacts asked for.
    """
    tamaas = pytest.importorskip("tamaas", reason="Tamaas is installed for a measurement only")
    tamaas.initialize(1)
    tamaas.set_log_level(tamaas.LogLevel.error)
    size = [elements, elements]
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0, 1.0], size)
    model.E, model.nu = 1.0, 0.0
    solver = tamaas.PolonskyKeerRey(model, _surface(tamaas, elements), TOLERANCE)

    def contacts(pressure: float) -> float:
        solver.solve(pressure)
        return float(np.mean(model.traction > 0))

    low, high = 1e-3, 2.0
    for _ in range(8):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if contacts(middle) < share else (low, middle)
    found = contacts(high)

    def once() -> float:
        model.traction[:] = 0
        return float(solver.solve(high))

    return once, found, str(tamaas.__version__)


def _surface(tamaas: Any, elements: int) -> np.ndarray:
    """Heights from the longest wave of the patch to one of eight elements."""
    generator = tamaas.SurfaceGeneratorFilter2D([elements, elements])
    generator.spectrum = tamaas.Isopowerlaw2D()
    generator.random_seed = 1
    spectrum = generator.spectrum
    spectrum.q0, spectrum.q1, spectrum.q2 = 1, 1, max(elements // 8, 3)
    spectrum.hurst = 0.8
    heights = generator.buildSurface()
    return heights / tamaas.Statistics2D.computeSpectralRMSSlope(heights)
