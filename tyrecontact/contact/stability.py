r"""How far a step is from where the time stepping blows up (physics, section 5).

With springs of stiffness K on the elements in contact, and the kernel's power H(theta) at its worst
angle (tread/stability.py),

    margin = 1 - lambda_max(-K^1/2 H K^1/2) / (1 - cos theta):

1 where nothing feeds an oscillation of that angle, 0 where it begins to grow. No kernel that takes
power from every history of forces comes below 1.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh

from tyrecontact.contact.lattice import Compliance
from tyrecontact.tread import kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.stability import lowest_power

#: accuracy of the margin
_ACCURACY = 1e-3
#: power below this share of the self compliance is rounding
_ROUNDING = 1e-9


class StabilityMargin:
    """The margin of a kernel for the contacts of one step after another.

    Attributes
    ----------
    is_passive : whether no springs can make the kernel feed an oscillation.
    """

    def __init__(self, kernel: Kernel) -> None:
        angle = kernels.critical_angle(kernel)
        power = kernels.hermitian_symbol(kernel, angle) / (1 - np.cos(angle))
        self._power = Compliance(power)
        self._last: np.ndarray | None = None
        # of all elements: long waves may draw power where a part of the patch draws none
        self.is_passive = lowest_power(power) >= -_ROUNDING * kernel.values[0, 0, 0]

    def of(self, stiffness: np.ndarray) -> float:
        """Margin [-] for element stiffnesses [N/m], shape (elements,)."""
        if self.is_passive or not stiffness.any():
            return 1.0
        if not np.isfinite(stiffness).all():  # of a run that is lost
            return float("nan")
        root = np.sqrt(stiffness)

        def product(v: np.ndarray) -> np.ndarray:
            v = v.ravel()
            return v - root * self._power.displacement(root * v)

        operator = LinearOperator((root.size, root.size), matvec=product, dtype=float)
        start = root if self._last is None else self._last
        try:
            value, vector = eigsh(operator, k=1, which="LA", v0=start, tol=_ACCURACY)
        except ArpackNoConvergence:  # what was found so far is no bound
            return float("nan")
        self._last = vector[:, 0]
        return float(2 - max(value[0], 1.0))
