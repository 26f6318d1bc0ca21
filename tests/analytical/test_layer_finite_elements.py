"""Static compliance of two layers against plane-strain finite elements, one wavenumber each.

Half a wavelength of the strip under the pressure cos(k x), its sides free to slide: biquadratic
displacements, and in each layer a bilinear pressure of its own, since it jumps between them
(Taylor-Hood: nu = 0.499 locks nothing).
"""

from __future__ import annotations

import numpy as np
import pytest
import skfem
from scipy import sparse
from skfem.helpers import ddot, div, sym_grad

from tyrecontact.tread.materials import Layer, NearlyConstantLoss
from tyrecontact.tread.plate import surface_compliance


def layer(thickness: float, modulus: float, poissons_ratio: float) -> Layer:
    return Layer(thickness, 1300.0, NearlyConstantLoss(modulus, 0.0), poissons_ratio)


DEFAULT = [layer(10e-3, 25e6, 0.499), layer(3e-3, 72e9, 0.33)]
STIFF_ON_SOFT = [layer(4e-3, 60e6, 0.3), layer(6e-3, 8e6, 0.45)]


def depths(layers: list[Layer], wavenumber: float) -> list[np.ndarray]:
    """Cell boundaries of each layer, twelve and more where the wave decays within it."""
    result, top = [], 0.0
    for one in layers:
        cells = int(np.ceil(max(12, 4 * wavenumber * one.thickness)))
        result.append(top + one.thickness * np.arange(cells + 1) / cells)
        top += one.thickness
    return result


@skfem.BilinearForm
def shear(u, v, _w):  # type: ignore[no-untyped-def]
    return 2 * ddot(sym_grad(u), sym_grad(v))


@skfem.BilinearForm
def volume(u, q, _w):  # type: ignore[no-untyped-def]
    return -q * div(u)


@skfem.BilinearForm
def squeeze(p, q, _w):  # type: ignore[no-untyped-def]
    return -p * q


@skfem.LinearForm
def pressure(v, w):  # type: ignore[no-untyped-def]
    return v[1] * np.cos(w.wavenumber * w.x[0])


def compliance_by_finite_elements(layers: list[Layer], wavenumber: float) -> float:
    """Amplitude of the surface's displacement per pressure [m/Pa]."""
    edges = depths(layers, wavenumber)
    z = np.unique(np.concatenate([edges[0], edges[1][1:]]))
    mesh = skfem.MeshQuad.init_tensor(np.linspace(0, np.pi / wavenumber, 13), z)
    element = skfem.ElementVector(skfem.ElementQuad2())
    stiffness, coupling, bulk = None, [], []
    for one, edge in zip(layers, edges, strict=True):
        middle = mesh.p[1, mesh.t].mean(axis=0)
        inside = np.flatnonzero((middle > edge[0]) & (middle < edge[-1]))
        u_basis = skfem.Basis(mesh, element, elements=inside, intorder=5)
        p_basis = u_basis.with_element(skfem.ElementQuad1())
        modulus = float(one.modulus(np.zeros(())).real)
        nu, mu = one.poissons_ratio, modulus / (2 + 2 * one.poissons_ratio)
        part = mu * shear.assemble(u_basis)
        stiffness = part if stiffness is None else stiffness + part
        coupling.append(volume.assemble(u_basis, p_basis))
        bulk.append((1 - 2 * nu) / (2 * mu * nu) * squeeze.assemble(p_basis))
    matrix = sparse.bmat(
        [
            [stiffness, coupling[0].T, coupling[1].T],
            [coupling[0], bulk[0], None],
            [coupling[1], None, bulk[1]],
        ]
    ).tocsr()
    return _response(mesh, element, matrix, wavenumber)


def _response(
    mesh: skfem.MeshQuad, element: skfem.Element, matrix: sparse.csr_matrix, wavenumber: float
) -> float:
    """Work of the pressure per half wavelength, as an amplitude."""
    basis = skfem.Basis(mesh, element)
    right, bottom = mesh.p.max(axis=1)
    top = skfem.FacetBasis(
        mesh, element, facets=mesh.facets_satisfying(lambda x: x[1] == 0), intorder=7
    )
    load = np.zeros(matrix.shape[0])
    load[: basis.N] = pressure.assemble(top, wavenumber=wavenumber)
    sides = basis.get_dofs(lambda x: np.isclose(x[0], 0) | np.isclose(x[0], right))
    base = basis.get_dofs(lambda x: np.isclose(x[1], bottom))
    unused = np.flatnonzero(np.diff(matrix.indptr) == 0)  # pressures of the other layer
    fixed = np.concatenate([sides.all(["u^1"]), base.all(), unused])
    x = skfem.solve(*skfem.condense(matrix, load, D=fixed))
    return float(load @ x * 2 * wavenumber / np.pi)


@pytest.mark.parametrize("kh", [0.3, 0.7, 1.5, 3.0, 6.0, 12.0])
@pytest.mark.parametrize("layers", [DEFAULT, STIFF_ON_SOFT], ids=["default", "stiff on soft"])
def test_two_layers_at_rest_are_those_of_finite_elements(layers: list[Layer], kh: float) -> None:
    wavenumber = kh / layers[0].thickness
    found = float(surface_compliance(wavenumber, 0.0, layers).real)
    expected = compliance_by_finite_elements(layers, wavenumber)
    # cells of a 24th of a wavelength: the energy of biquadratic ones is off by about
    # (k cell)^4 / 360 = 1.3e-5, of either sign with a pressure of its own; four times that
    assert found == pytest.approx(expected, rel=5e-5, abs=0)
