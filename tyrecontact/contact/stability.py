r"""How far a step is from where the time stepping blows up (physics, section 5).

With springs of stiffness K on the elements in contact, and the kernel's power H(theta) at its worst
angle (tread/stability.py),

    margin = 1 - lambda,    lambda = lambda_max(-K^1/2 H K^1/2) / (1 - cos theta), at least 0:

1 where nothing feeds an oscillation of that angle, 0 where it begins to grow. No kernel that takes
power from every history of forces comes below 1.

The worst patterns of force change little from step to step, so that they are followed
(contact/following.py); where the contact has changed much the eigenvalue is sought from scratch.
"""

from __future__ import annotations

from copy import copy

import numpy as np
from scipy.linalg import eigvalsh
from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh

from tyrecontact.contact.following import Followed
from tyrecontact.contact.lattice import Compliance
from tyrecontact.tread import kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.stability import lowest_power

#: accuracy of the margin, per 1 + lambda
_ACCURACY = 1e-3
#: power below this share of the self compliance is rounding
_ROUNDING = 1e-9
#: of so many contacts lambda is that of a dense matrix
_DENSE_UP_TO = 96
#: vectors of ARPACK's space: with its usual 20 it now and then takes the second for the first
_SPACE = 30
#: what is followed is lost when more than this share of the stiffness has changed in a step
_JUMP = 0.1


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
        self._start()
        # of all elements: long waves may draw power where a part of the patch draws none
        self.is_passive = lowest_power(power) >= -_ROUNDING * kernel.values[0, 0, 0]

    def fresh(self) -> StabilityMargin:
        """The margin for another run; what depends on the kernel alone is not computed again."""
        other = copy(self)
        other._start()
        return other

    def _start(self) -> None:
        self._random = np.random.default_rng(0)  # the same every time
        self._followed: Followed | None = None
        self._stiffness = np.zeros(self._power.products.values.size)

    def of(self, stiffness: np.ndarray) -> float:
        """Margin [-] for element stiffnesses [N/m], shape (elements,)."""
        if self.is_passive or not stiffness.any():
            return 1.0
        if not np.isfinite(stiffness).all():  # of a run that is lost
            return float("nan")
        changed = np.abs(stiffness - self._stiffness).sum()
        self._stiffness = stiffness
        contacts = np.flatnonzero(stiffness)
        if contacts.size <= _DENSE_UP_TO:
            return 1 - max(self._of_few(contacts), 0.0)
        last = self._followed
        if last is not None and changed <= _JUMP * stiffness.sum():
            self._followed = last.on(np.sqrt(stiffness), self._random)
        else:
            self._followed = None
        if self._followed is None:
            self._followed = self._from_scratch()
        return float("nan") if self._followed is None else 1 - max(self._followed.value, 0.0)

    def _of_few(self, contacts: np.ndarray) -> float:
        self._followed = None
        root = np.sqrt(self._stiffness[contacts])
        matrix = -root[:, None] * self._power.matrix(contacts) * root
        return float(eigvalsh(matrix, subset_by_index=[root.size - 1, root.size - 1])[0])

    def _from_scratch(self) -> Followed | None:
        """By ARPACK from a random start; None where it does not converge."""
        root = np.sqrt(self._stiffness)

        def product(v: np.ndarray) -> np.ndarray:
            v = v.ravel()
            return v - root * self._power.displacement(root * v)

        operator = LinearOperator((root.size, root.size), matvec=product, dtype=float)
        start = root * self._random.standard_normal(root.size)
        space = min(_SPACE, root.size)
        try:
            value, vector = eigsh(operator, k=1, which="LA", v0=start, ncv=space, tol=_ACCURACY)
        except ArpackNoConvergence:  # what was found so far is no bound
            return None
        return Followed(self._power, root, vector.T, float(value[0] - 1))
