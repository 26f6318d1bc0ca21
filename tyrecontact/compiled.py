"""Loops compiled by numba: look-ups in springs, Newton's method, the latest steps of the memory.

`newton.robust` for elements that answer alike in push and pull (`Mirrored`), on patches whose
products are taken by matrices (contact/transforms.py). Sums are rounded otherwise, linear solves
always preconditioned, and in single precision, enough for what Newton's method makes up for. All is
in this file: numba makes anew what it keeps when a function's own file changes, and no other.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tyrecontact.fast import compiled


class Tread(NamedTuple):
    """A `Compliance`: both transforms and the grid of waves; the transforms, the grid without an
    element's own compliance and the `Neighbours` in single precision; compliances of an element and
    shared by all [m/N]."""

    across: Any
    along: Any
    grid: Any
    across_single: Any
    along_single: Any
    grid_of_others: Any
    stencils: Any
    own: float
    shared: float


class Limits(NamedTuple):
    """Tolerance [m]; share of b beyond which a guess is poor; of linear solves the loosest and the
    tightest accuracy, and the share of the tolerance; iterations and halvings at most."""

    tolerance: float
    poor: float
    loosest: float
    tightest: float
    share: float
    iterations: int
    halvings: int


class Point(NamedTuple):
    """What is known at one d: arrays of shape (elements,), the largest imbalance [m], Psi [J]."""

    compression: Any
    force: Any
    stiffness: Any
    energy: Any
    displacement: Any
    imbalance: Any
    residual: float
    potential: float


@compiled
def _cell_of(compression: float, depth: float, cells: int) -> Any:
    """Number of the cell of a compression [m] >= 0, and the distance from its lower node [m]."""
    place = np.sqrt(min(compression / depth, 1.0))
    cell = int(place * cells) if place >= 0 else 0  # also of what is no number
    return cell, compression - depth * (cell / cells) ** 2


@compiled
def _respond(coefficients: Any, x: float) -> Any:
    """U, U' and U'' of a polynomial of the fifth degree, by Horner's scheme."""
    u = f = k = coefficients[0]
    for power in range(1, 4):
        u = u * x + coefficients[power]
        f = f * x + u
        k = k * x + f
    u = u * x + coefficients[4]
    return u * x + coefficients[5], f * x + u, 2 * k


@compiled
def between_nodes(table: Any, column: int, depth: float, compression: Any) -> Any:
    """A column of a table (elements, cells + 1, columns) at compressions [m] >= 0, (elements,)."""
    result, cells = np.empty(compression.size), table.shape[1] - 1
    for i in range(compression.size):
        cell, x = _cell_of(compression[i], depth, cells)
        result[i] = table[i, cell, column]
        if cell < cells:
            width = depth * (2 * cell + 1) / cells**2
            result[i] += (table[i, cell + 1, column] - result[i]) * min(x / width, 1.0)
    return result


@compiled
def robust(
    table: Any, depth: float, bonded: Any, tread: Any, target: Any, guesses: Any, limits: Any
) -> Any:
    """The solution as a `Point`, and the iterations used.

    Parameters
    ----------
    table, depth, bonded : of U (elements, cells + 1, 6), [m], elements that pull, too.
    tread : `Tread`.  target : b [m].  limits : `Limits`.
    guesses : first guess of d [m], and one for when it is poor; shape (1 or 2, elements).
    """
    point = _point(table, depth, bonded, tread, target, guesses[0].copy())
    if len(guesses) > 1 and not point.residual <= limits.poor * np.abs(target).max():
        other = _point(table, depth, bonded, tread, target, guesses[1].copy())
        if other.potential < point.potential:
            point = other
    iterations, found = 0, True
    while found and not point.residual <= limits.tolerance and iterations < limits.iterations:
        goal = limits.share * limits.tolerance / point.residual
        accuracy = min(limits.loosest, max(limits.tightest, goal))
        step, slope = _newton_step(tread, point.stiffness, point.imbalance, accuracy)
        iterations += 1
        part, rounding = 1.0, 1e-14 * abs(point.potential)
        trial = _point(table, depth, bonded, tread, target, point.compression + step)
        found = trial.residual < 0.5 * point.residual
        for _ in range(limits.halvings):
            found = found or trial.potential <= point.potential + 1e-4 * part * slope + rounding
            if found:
                point = trial
                break
            part /= 2
            trial = _point(table, depth, bonded, tread, target, point.compression + part * step)
    return point, iterations


@compiled
def _point(table: Any, depth: float, bonded: Any, tread: Any, target: Any, d: Any) -> Any:
    force, stiffness, energy = np.zeros_like(d), np.zeros_like(d), np.zeros_like(d)
    cells, total = table.shape[1] - 1, 0.0
    for i in range(d.size):
        if d[i] > 0 or bonded[i]:
            cell, x = _cell_of(abs(d[i]), depth, cells)
            energy[i], size, stiffness[i] = _respond(table[i, cell], x)
            force[i] = np.copysign(size, d[i])
            total += force[i]
    displacement = _product(tread.across, tread.along, tread.grid, force)
    imbalance, residual, potential = np.empty_like(d), 0.0, 0.0
    for i in range(d.size):
        displacement[i] += tread.shared * total
        imbalance[i] = target[i] - displacement[i] - d[i]
        if abs(imbalance[i]) > residual or np.isnan(imbalance[i]):  # what is no number stays
            residual = abs(imbalance[i])
        potential += force[i] * (displacement[i] / 2 + d[i] - target[i]) - energy[i]
    return Point(d, force, stiffness, energy, displacement, imbalance, residual, potential)


@compiled
def _product(across: Any, along: Any, grid: Any, force: Any) -> Any:
    field = force.reshape(across.shape[1], along.shape[1])
    waves = np.dot(np.dot(across, field), along.T)
    for i in range(waves.shape[0]):
        for j in range(waves.shape[1]):
            waves[i, j] *= grid[i, j]
    return np.dot(np.dot(across.T, waves), along).reshape(-1)


@compiled
def _newton_step(tread: Any, stiffness: Any, imbalance: Any, accuracy: float) -> Any:
    """Delta of (1 + g_0 K) Delta = f (contact/linear.py), and how Psi changes along it."""
    # the largest imbalance as unit: single precision knows no small numbers
    count, unit = imbalance.size, np.abs(imbalance).max()
    scale, residual = np.empty(count, np.float32), np.empty(count, np.float32)
    step = np.empty(count, np.float32)
    for i in range(count):
        scale[i] = np.sqrt(stiffness[i] / (1 + stiffness[i] * tread.own))
        step[i] = imbalance[i] / unit
        residual[i] = scale[i] * step[i]
    _conjugate_gradients(tread, scale, residual, step, accuracy)
    slope, full = 0.0, np.empty(count)
    for i in range(count):
        full[i] = unit * step[i]
        slope -= stiffness[i] * imbalance[i] * full[i]
    return full, slope


@compiled
def _conjugate_gradients(tread: Any, scale: Any, residual: Any, step: Any, accuracy: float) -> None:
    """Take g_0 S y from the step, where (1 + S g' S) y = residual."""
    count, rho, size = residual.size, np.float32(1.0), np.dot(residual, residual)
    direction, guess = np.zeros(count, np.float32), np.empty(count, np.float32)
    force, stencil, goal = np.empty(count, np.float32), _stencil(tread, scale), accuracy**2 * size
    own, shared = np.float32(tread.own), np.float32(tread.shared)
    for _ in range(count):
        if not size > goal:
            return
        _precondition(stencil, scale, residual, guess, tread.along.shape[1])
        before, rho, total = rho, np.dot(residual, guess), np.float32(0.0)
        turn = np.float32(rho / before)
        for i in range(count):
            direction[i] = guess[i] + turn * direction[i]
            force[i] = scale[i] * direction[i]
            total += force[i]
        others = _product(tread.across_single, tread.along_single, tread.grid_of_others, force)
        curvature = 0.0
        for i in range(count):
            others[i] += shared * (total - force[i])
            curvature += direction[i] * direction[i] + force[i] * others[i]
        part = np.float32(rho / curvature)
        for i in range(count):
            step[i] -= part * (others[i] + own * force[i])
            residual[i] -= part * (scale[i] * others[i] + direction[i])
        size = np.dot(residual, residual)


@compiled
def _stencil(tread: Any, scale: Any) -> Any:
    """`Neighbours.stencil`."""
    largest, touching, levels = 0.0, 0, len(tread.stencils)
    for value in scale:
        largest = max(largest, value * value)
        touching += value > 0
    level = int(np.dot(scale, scale) / max(touching, 1) * tread.own * levels)
    stencil = tread.stencils[min(level, levels - 1)]
    return stencil / np.float32(max(stencil[4] * largest, 1.0))


@compiled
def _precondition(stencil: Any, scale: Any, residual: Any, guess: Any, columns: int) -> None:
    """guess = (1 - S h S) residual."""
    rows = residual.size // columns
    near = np.zeros((rows + 2, columns + 2), np.float32)
    for i in range(rows):
        for j in range(columns):
            near[i + 1, j + 1] = scale[i * columns + j] * residual[i * columns + j]
    for i in range(rows):
        for j in range(columns):
            element = i * columns + j
            guess[element] = residual[element] - scale[element] * (
                stencil[0] * near[i + 1, j + 1]
                + stencil[1] * (near[i + 1, j] + near[i + 1, j + 2])
                + stencil[2] * (near[i, j + 1] + near[i + 2, j + 1])
                + stencil[3] * (near[i, j] + near[i, j + 2] + near[i + 2, j] + near[i + 2, j + 2])
            )


@compiled
def recent_sum(numbers: Any, steps: Any, known: Any) -> Any:
    """known + sum over steps of numbers x (contact/blocks.py, `Memory.sum`).

    numbers : shape (steps, waves).  steps : (steps, parts, waves).  known : (parts, waves).
    """
    total = known.copy()
    for step in range(len(steps)):
        for part in range(total.shape[0]):
            for wave in range(total.shape[1]):
                total[part, wave] += numbers[step, wave] * steps[step, part, wave]
    return total
