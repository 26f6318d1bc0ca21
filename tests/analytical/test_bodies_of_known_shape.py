"""A whole quasi-static run against closed solutions: a sphere and a flat punch on the tread.

Elements are the grid on which the tread is solved here: tops of a known shape, under linear
springs 300 times stiffer than the tread under one element, so that the tread alone gives way.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

from tyrecontact import Results, Scenario, Simulation
from tyrecontact.road.heights import Patch
from tyrecontact.road.punch import stiffness_factor
from tyrecontact.road.springs import linear

MODULUS, POISSON, SIZE = 25e6, 0.4999, 2e-3
THICKNESS = SIZE
PLANE = MODULUS / (1 - POISSON**2)
#: of the sphere [m], and how far it is pressed
RADIUS, INDENTATION = 50e-3, 9e-6


def distance(count: int) -> np.ndarray:
    """From the patch's middle to the elements' [m], shape (count, count)."""
    x = (np.arange(count) + 0.5) * SIZE / count - SIZE / 2
    return np.hypot(x[:, None], x)


def pressed(tops: np.ndarray, indentation: float) -> Results:
    """Tops [m], (count, count), pressed in four steps into a tread at rest on a rigid base."""
    count = len(tops)
    scenario = Scenario(
        road={"elements": count, "size": SIZE},
        tread={
            "static_modulus": MODULUS,
            "poissons_ratio": POISSON,
            "thickness": THICKNESS,
            "base_modulus": 1e13,
            "base_thickness": 1e-5,
        },
        loading={"max_indentation": indentation, "rate": indentation * 51200 / 4},
        numerics={"kernel": "static", "tolerance": 1e-7, "max_iterations": 200},
    )
    scenario.numerics.initial_guess = "last"
    simulation = Simulation(scenario)
    side = SIZE / count
    simulation.patch = Patch(np.kron(tops, np.ones((4, 4))), side / 4)
    simulation.springs = linear(np.full(count**2, 300 * PLANE * side), 1e-3, side / 2)
    results = simulation.run()
    assert results.converged.all()
    return results


def sphere(radius: float, indentation: float, thickness: float) -> tuple[float, float]:
    """Force [N] and contact radius [m] of a frictionless sphere on a bonded layer.

    The punch's equation with the right side 1 - (a x)^2 / (R delta), and phi(1) = 0 for a.
    """
    x, weight = (np.polynomial.legendre.leggauss(60)[i] / 2 for i in (0, 1))
    x = np.append(x + 0.5, 1.0)
    u, du = (np.polynomial.legendre.leggauss(400)[i] * 12.5 for i in (0, 1))
    u = u + 12.5
    k0, decay = 3 - 4 * POISSON, np.exp(-2 * u)
    rest = (4 * u**2 + 4 * u + 1 + k0**2) * decay + 2 * k0 * decay**2
    deficit = rest / (k0 * (1 + decay**2) + (4 * u**2 + 1 + k0**2) * decay)  # 1 - L

    @cache
    def parts(a: float) -> tuple[np.ndarray, np.ndarray]:
        cosine = np.cos(a / thickness * np.outer(x, u))
        kernel = -2 / np.pi * a / thickness * (cosine * deficit * du) @ cosine[:-1].T
        right = np.stack([np.ones(x.size), x**2], axis=1)
        phi = np.linalg.solve(np.eye(60) + kernel[:-1] * weight, right[:-1])
        return weight @ phi, right[-1] - kernel[-1] * weight @ phi

    def edge(a: float) -> float:
        at_edge = parts(a)[1]
        return float(a**2 / radius * at_edge[1] - indentation * at_edge[0])

    a = float(brentq(edge, 1e-6 * radius, radius, xtol=1e-15))
    integral = parts(a)[0]
    return 2 * PLANE * a * (indentation * integral[0] - a**2 / radius * integral[1]), a


def test_the_sphere_on_a_thick_layer_is_hertz() -> None:
    force, a = sphere(RADIUS, INDENTATION, 1e3 * SIZE)
    hertz = 4 / 3 * PLANE * np.sqrt(RADIUS) * INDENTATION**1.5
    # what is left of the layer: a / thickness = 3e-4, times about 1.3
    assert force == pytest.approx(hertz, rel=1e-3)
    assert a == pytest.approx(np.sqrt(RADIUS * INDENTATION), rel=1e-3)


def hertz_error(count: int) -> tuple[float, float]:
    """Of force and contact radius, relative, for a sphere on `count` elements a side.

    The tread's displacement is a mean over an element, and that of the paraboloid is higher than
    its middle by side^2 / 12 R; the highest middles lie side^2 / 4 R below the pole.
    """
    side = SIZE / count
    tops = -(distance(count) ** 2) / (2 * RADIUS)
    results = pressed(tops, INDENTATION - side**2 / (3 * RADIUS))
    force, a = sphere(RADIUS, INDENTATION, THICKNESS)
    found = np.sqrt(results.contacts[-1] / np.pi) * side
    return results.contact_force[-1] / force - 1, found / a - 1


def test_a_sphere_converges_to_its_closed_solution() -> None:
    """It reaches over 0.78 of the patch; the layer makes it 1.6 times stiffer than Hertz."""
    force, radius = np.abs([hertz_error(count) for count in (6, 12, 24)]).T
    assert np.all(force[1:] < force[:-1] / 2)  # between the first and the second order
    # the springs' give is side / (300 x 0.8 a) = 4e-4 at 24 elements, the rest is the rim's
    assert force[-1] < 1.5e-3
    assert radius[-1] < 0.03  # a ring of elements is 0.1 of a wide; about a fourth of that


def punch_error(count: int) -> float:
    """Of the force of a flat circular punch, on a radius of the same area."""
    inside = distance(count) <= 0.4 * SIZE
    results = pressed(np.where(inside, 0.0, -50e-6), 10e-6)
    assert results.contacts[-1] == inside.sum()
    a = np.sqrt(inside.sum() / np.pi) * SIZE / count
    kappa = float(stiffness_factor(np.array(a / THICKNESS), POISSON))
    return results.contact_force[-1] / (2 * PLANE * a * 10e-6 * kappa) - 1


def test_a_flat_punch_converges_to_its_closed_solution() -> None:
    """F = 2 E* a delta kappa; its pressure is infinite at the rim, hence of the first order."""
    errors = [punch_error(count) for count in (6, 12, 24)]
    assert -0.06 < errors[0] < errors[1] < errors[2] < 0  # uniform pressures: too soft
    assert errors[1] / errors[0] < 0.5
    assert errors[2] > -0.008  # a tenth of side / a = 0.1, as in the step before
