"""Products of kernel and element forces on the lattice, and the memory of past forces.

The displacement of an element depends on its distance to the loaded one alone, so that every
sum over elements is a convolution: a product of waves (contact/transforms.py).
"""

from __future__ import annotations

from copy import copy
from functools import cached_property

import numpy as np

from tyrecontact.contact.blocks import Lagged, Memory
from tyrecontact.contact.neighbours import Neighbours
from tyrecontact.contact.transforms import PARTS, Fourier, Matrices, kernel_waves, transform
from tyrecontact.tread.kernels import Kernel


class Products:
    """What it takes to sum a kernel over the elements; made once for all that share it.

    Parameters
    ----------
    values : displacement per force by offset [m/N], shape (ny, nx).

    Attributes
    ----------
    grid : waves of the kernel, as the transform wants them.
    """

    def __init__(self, values: np.ndarray) -> None:
        self.values, self.transform = values, transform(values.shape)
        self._waves = kernel_waves(values)
        self.grid = self.transform.grid(self._waves)

    @cached_property
    def grid_of_others(self) -> np.ndarray:
        """The same without what the force on an element does to itself."""
        return self.transform.grid(self._waves - self.values[0, 0])

    @cached_property
    def single_grid_of_others(self) -> np.ndarray:
        return self.grid_of_others.astype(np.float32)

    @cached_property
    def neighbours(self) -> Neighbours:
        """What preconditions solutions."""
        own = float(self.values[0, 0])
        return Neighbours(self._waves - own, own)

    @cached_property
    def as_matrices(self) -> tuple[np.ndarray, ...] | None:
        """What products are taken by, where it is matrices (compiled.py, `Tread`)."""
        if not isinstance(self.transform, Matrices):
            return None
        double = (self.transform.across, self.transform.along, self.grid)
        single = (*double[:2], self.grid_of_others, self.neighbours.stencils)
        return (*double, *(values.astype(np.float32) for values in single))


class Compliance:
    """Compliance between all elements within a step, ready for products with element forces.

    Parameters
    ----------
    values : displacement per force by offset [m/N], shape (ny, nx).
    shared : displacement of all elements per unit of the total force [m/N]: a rigid motion.

    Attributes
    ----------
    shape : (ny, nx) elements.
    self_compliance : displacement of an element under its own force [m/N].
    products : what does not depend on `shared`.
    """

    def __init__(self, values: np.ndarray, shared: float = 0.0) -> None:
        self.shared = shared
        self.shape: tuple[int, int] = values.shape
        self.self_compliance = float(values[0, 0]) + shared
        self.products = Products(values)

    def with_shared(self, shared: float) -> Compliance:
        """The same with another rigid motion [m/N]; nothing is computed anew."""
        if shared == self.shared:
            return self
        other = copy(self)
        other.self_compliance = self.self_compliance - self.shared + shared
        other.shared = shared
        return other

    def displacement(self, force: np.ndarray) -> np.ndarray:
        """Displacement [m] under element forces [N], both (ny nx,)."""
        products = self.products
        near = products.transform.product(products.grid, force.reshape(self.shape)).ravel()
        return near + self.shared * force.sum() if self.shared else near

    def from_others(self, force: np.ndarray) -> np.ndarray:
        """The same without what the force on an element does to itself."""
        products = self.products
        grid = products.grid_of_others
        if force.dtype == np.float32:
            grid = products.single_grid_of_others
        near = products.transform.product(grid, force.reshape(self.shape)).ravel()
        return near + self.shared * (force.sum() - force) if self.shared else near

    @property
    def is_transformed_fast(self) -> bool:
        """Whether products are taken by fast transforms; those keep single precision."""
        return isinstance(self.products.transform, Fourier)

    def matrix(self, elements: np.ndarray) -> np.ndarray:
        """Dense matrix between the listed elements (flat indices) [m/N]."""
        row, column = np.divmod(elements, self.shape[1])
        dy = np.abs(np.subtract.outer(row, row))
        dx = np.abs(np.subtract.outer(column, column))
        return self.products.values[dy, dx] + self.shared


class LatticeKernel:
    """A kernel ready for products with element forces.

    Attributes
    ----------
    kernel : the `Kernel`, values (lags, ny, nx) [m/N].
    shape : (ny, nx) elements.
    now : compliance within a step, g_0.
    """

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.shape: tuple[int, int] = kernel.values.shape[1:]
        self.now = Compliance(kernel.values[0])

    @cached_property
    def at_rest(self) -> Compliance:
        """Compliance under forces that have not changed for as long as the kernel remembers."""
        return Compliance(self.kernel.static_compliance)

    @cached_property
    def lagged(self) -> Lagged | None:
        """What past forces are multiplied with; None if the kernel remembers none."""
        if len(self.kernel.values) < 2:
            return None
        waves = kernel_waves(self.kernel.values)
        return Lagged(waves.reshape(len(waves), -1))


class History:
    """Past element forces, and the displacement that they still cause.

    u_n = sum_(j=1)^(lags-1) g_j * F_(n-j), over all elements that carried force then.
    """

    def __init__(self, kernel: LatticeKernel) -> None:
        self._shape, self._transform = kernel.shape, transform(kernel.shape)
        self._memory: Memory | None = None
        if kernel.lagged is not None:
            self._memory = Memory(kernel.lagged, PARTS)

    def displacement(self) -> np.ndarray:
        """Displacement of the coming step due to all past forces [m], (ny, nx)."""
        if self._memory is None:
            return np.zeros(self._shape)
        return self._transform.backward(self._memory.sum())

    def remember(self, force: np.ndarray) -> None:
        """Take the element forces [N], (ny, nx), of the step that has been solved."""
        if self._memory is not None:
            self._memory.take(self._transform.forward(force))

    def settle(self, force: np.ndarray) -> None:
        """Take element forces [N], (ny, nx), that have acted for longer than is remembered."""
        if self._memory is not None:
            self._memory.fill(self._transform.forward(force))
