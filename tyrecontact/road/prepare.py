r"""What is done to a measured road before it is used: trim, turn over, level, cut, fill.

Missing heights are filled so that each is the mean of its neighbours (Laplace's equation on the
grid, no flux through the edge). No filled height then lies above all those around it: filling
makes no top for the tread to touch.
"""

from __future__ import annotations

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from tyrecontact.errors import InputError
from tyrecontact.road.scan import Scan


def trimmed(scan: Scan, start: float, end: float) -> Scan:
    """A profile without so much of its start and end [m]: reference plates, run-in."""
    first, last = (round(length / scan.pitch) for length in (start, end))
    if not first and not last:
        return scan
    if not scan.is_profile:
        raise InputError(
            f"trim must be 0 for a map (move its centre instead), got {start:g} and {end:g} m"
        )
    heights = scan.heights[first : max(len(scan.heights) - last, 0)]
    if len(heights) < 2:
        raise InputError(
            f"trim must leave some of the {scan.extent[0]:.4g} m of {scan.name}, got {start:g} "
            f"and {end:g} m"
        )
    clause = f"trimmed by {start * 1e3:.4g} mm at the start and {end * 1e3:.4g} mm at the end"
    return scan.changed(heights, clause)


def turned_over(scan: Scan) -> Scan:
    """Heights of a file that counts depths, positive down, made positive up."""
    return scan.changed(-scan.heights, "depths, positive down, turned into heights")


def levelled(scan: Scan) -> Scan:
    """The scan less its least-squares plane (a line for a profile) through the valid heights."""
    rows, columns = np.atleast_2d(scan.heights).shape
    y, x = (np.arange(n) - (n - 1) / 2 for n in (rows, columns))
    along_y, along_x = (np.vander(t, 3, increasing=True) for t in (y, x))
    # sums over rows first: terms for each height would take three times the scan's memory
    heights = np.atleast_2d(np.where(scan.valid, scan.heights, 0.0))
    moments = along_y.T @ (np.atleast_2d(scan.valid).astype(float) @ along_x)
    sums = along_y.T @ (heights @ along_x)
    powers = ((0, 0), (1, 0), (0, 1))  # 1, y, x
    normal = [[moments[i + k, j + m] for k, m in powers] for i, j in powers]
    mean, slope_y, slope_x = np.linalg.lstsq(np.array(normal), [sums[p] for p in powers])[0]
    plane = (mean + slope_y * y)[:, None] + slope_x * x
    flat = scan.heights - plane.reshape(scan.heights.shape)
    slopes = np.array([slope_y, slope_x][-scan.heights.ndim :]) / scan.pitch
    names = ("y", "x")[-len(slopes) :]
    told = " and ".join(f"{slope * 1e3:.3g} mm/m along {name}" for slope, name in zip(
        slopes[::-1], names[::-1], strict=True))  # fmt: skip
    return scan.changed(flat, f"levelled: {told} taken off")


def cut(scan: Scan, size: float, centre_x: float, centre_y: float) -> Scan:
    """The part of a scan around a point, a little larger than a patch needs it.

    Parameters
    ----------
    size : side of the patch [m].
    centre_x, centre_y : of the patch off the middle of the scan [m]; y has no meaning for a
        profile. Moved to the nearest height.

    Raises
    ------
    InputError : the patch reaches beyond the scan.
    """
    centres = (centre_y, centre_x)[-scan.heights.ndim :]
    if scan.is_profile and centre_y:
        raise InputError(f"centre_y must be 0 for a profile, got {centre_y:g} m")
    window = []
    for count, centre in zip(scan.heights.shape, centres, strict=True):
        shift = round(centre / scan.pitch)
        room = min(count + 2 * shift, count - 2 * shift)  # symmetric about the centre
        if room * scan.pitch < size * (1 - 1e-9):
            got = " x ".join(f"{length * 1e3:.4g}" for length in reversed(scan.extent))
            off = "" if not shift else f" with its centre {centre * 1e3:.4g} mm off the middle"
            raise InputError(
                f"road must cover {size * 1e3:.4g} x {size * 1e3:.4g} mm{off}, got {got} mm"
            )
        needed = int(np.ceil(size / scan.pitch * (1 - 1e-9))) + 4
        kept = min(room, needed + (needed - room) % 2)
        start = (count - kept) // 2 + shift
        window.append(slice(start, start + kept))
    heights = scan.heights[tuple(window)]
    told = " and ".join(f"{axis} {centre * 1e3:.4g} mm" for axis, centre in zip(
        ("x", "y"), centres[::-1], strict=False) if centre)  # fmt: skip
    return scan.changed(heights, *([f"centre moved by {told}"] if told else []))


def filled(scan: Scan, limit: float) -> Scan:
    """The scan with its missing heights filled from around them.

    Parameters
    ----------
    limit : largest share of heights that may be missing [-].

    Raises
    ------
    InputError : more is missing.
    """
    missing = ~scan.valid
    share = float(missing.mean())
    if not share:
        return scan
    if not share <= limit:
        raise InputError(
            f"missing heights must be at most {limit:.1%} of the part that is used to be filled, "
            f"got {share:.1%} of {scan.name} (raise fill_limit, or move the centre)"
        )
    return scan.changed(
        _harmonic(scan.heights, missing),
        f"{share:.2%} of the heights ({np.count_nonzero(missing)}) filled from around them",
    )


def _harmonic(heights: np.ndarray, missing: np.ndarray) -> np.ndarray:
    """Each missing height as the mean of its neighbours; the others as they are."""
    number = np.full(heights.shape, -1)
    count = np.count_nonzero(missing)
    number[missing] = np.arange(count)
    degree, given = np.zeros(count), np.zeros(count)
    rows, columns = [], []
    for axis in range(heights.ndim):
        for here, there in (_ends(axis, heights.ndim), _ends(axis, heights.ndim)[::-1]):
            mine, theirs = number[here], number[there]
            known, unknown = (mine >= 0) & (theirs < 0), (mine >= 0) & (theirs >= 0)
            np.add.at(degree, mine[mine >= 0], 1.0)
            np.add.at(given, mine[known], heights[there][known])
            rows.append(mine[unknown])
            columns.append(theirs[unknown])
    row, column = np.concatenate(rows), np.concatenate(columns)
    neighbours = sparse.csc_matrix((np.ones(len(row)), (row, column)), shape=(count, count))
    result = heights.copy()
    # symmetric and positive definite: an ordering for that, and no pivots off the diagonal
    factors = splu(
        sparse.diags(degree, format="csc") - neighbours,
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    result[missing] = factors.solve(given)
    return result


def _ends(axis: int, ndim: int) -> tuple[tuple[slice, ...], tuple[slice, ...]]:
    """All but the last, and all but the first, along an axis: a height and its neighbour."""
    here = [slice(None)] * ndim
    there = [slice(None)] * ndim
    here[axis], there[axis] = slice(None, -1), slice(1, None)
    return tuple(here), tuple(there)
