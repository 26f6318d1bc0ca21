"""The punch factor against axisymmetric finite elements: slipping and sticking, thick to thin.

Displacements are biquadratic, the pressure bilinear (Taylor-Hood, for nu = 1/2), on a grid that
shrinks geometrically towards the punch's edge, where the stress is infinite.
"""

from __future__ import annotations

import numpy as np
import pytest
import skfem
from scipy import sparse
from skfem.helpers import ddot, div, sym_grad

from tyrecontact.road.punch import stiffness_factor


def towards(start: float, end: float, cells: int = 14, ratio: float = 0.55) -> np.ndarray:
    """Nodes from `start`, whose cells shrink geometrically towards `end`: to 4e-4 of the way."""
    return end + (start - end) * np.append(ratio ** np.arange(cells), 0.0)


def grid(thickness: float) -> skfem.MeshQuad:
    """A layer under a punch of radius 1; what its rim stirs dies as exp(-1.5 distance / h)."""
    r = np.union1d(towards(0.0, 1.0), towards(1 + 8 * thickness, 1.0))
    z = np.sort(towards(thickness, 0.0))
    return skfem.MeshQuad.init_tensor(r, z)


def kappa_by_finite_elements(ratio: float, poissons_ratio: float, bonded: bool) -> float:
    """Force of a unit indentation over that of a half-space, mu = 1."""
    thickness = 1 / ratio
    mesh = grid(thickness)
    u_basis = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
    p_basis = u_basis.with_element(skfem.ElementQuad1())
    per_lame = (1 - 2 * poissons_ratio) / (2 * poissons_ratio)  # mu / lambda, 0 at nu = 1/2

    @skfem.BilinearForm
    def shear(u, v, w):  # type: ignore[no-untyped-def]
        hoop = u[0] * v[0] / w.x[0] ** 2
        return 2 * (ddot(sym_grad(u), sym_grad(v)) + hoop) * w.x[0]

    @skfem.BilinearForm
    def volume(u, q, w):  # type: ignore[no-untyped-def]
        return -q * (div(u) * w.x[0] + u[0])

    @skfem.BilinearForm
    def squeeze(p, q, w):  # type: ignore[no-untyped-def]
        return -per_lame * p * q * w.x[0]

    coupling = volume.assemble(u_basis, p_basis)
    matrix = sparse.bmat(
        [
            [shear.assemble(u_basis), coupling.T],
            [coupling, squeeze.assemble(p_basis)],
        ]
    ).tocsr()
    x = np.zeros(matrix.shape[0])
    fixed = [u_basis.get_dofs(lambda x: np.isclose(x[1], thickness)).all()]
    fixed.append(u_basis.get_dofs(lambda x: np.isclose(x[0], mesh.p[0].max())).all())
    fixed.append(u_basis.get_dofs(lambda x: np.isclose(x[0], 0.0)).all(["u^1"]))
    punch = u_basis.get_dofs(lambda x: np.isclose(x[1], 0.0) & (x[0] <= 1 + 1e-12))
    down = punch.all(["u^2"])
    x[down] = 1.0
    if bonded:
        fixed.append(punch.all(["u^1"]))
    x = skfem.solve(*skfem.condense(matrix, x=x, D=np.concatenate([*fixed, down])))
    force = 2 * np.pi * (matrix @ x)[down].sum()
    return float(force * (1 - poissons_ratio) / 4)  # half-space: 4 mu a delta / (1 - nu)


CASES = [
    *((ratio, 0.5) for ratio in (0.05, 0.1, 0.2, 0.35, 0.5, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0)),
    *((ratio, poissons_ratio) for ratio in (0.2, 1.0, 5.0) for poissons_ratio in (0.1, 0.3)),
]


@pytest.mark.parametrize("bonded", [False, True], ids=["slips", "sticks"])
@pytest.mark.parametrize(("ratio", "poissons_ratio"), CASES)
def test_the_punch_factor_is_that_of_finite_elements(
    ratio: float, poissons_ratio: float, bonded: bool
) -> None:
    found = float(stiffness_factor(np.array(ratio), poissons_ratio, bonded))
    expected = kappa_by_finite_elements(ratio, poissons_ratio, bonded)
    # cells as wide as 0.45 of their distance from the edge are stiff by 0.05 % where the layer is
    # thin; where it is thick they have to span a / h more; six times finer a grid is three to
    # ten times closer everywhere
    assert expected == pytest.approx(found, rel=8e-4 + 2.2e-4 / ratio)
