"""Point clouds (`.las`, `.laz`; extra `[laz]`): triangulated, then put on a grid."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.spatial import Delaunay

from tyrecontact.errors import InputError
from tyrecontact.road import scan
from tyrecontact.road.formats.raw import Asked, Raw
from tyrecontact.road.gridding import largest_square

#: a cloud with more points than this is refused: triangulation takes a minute then
MAX_POINTS = 5_000_000
#: triangles with a side longer than this many mean distances bridge a gap of the cloud
_GAP = 5.0


def read(path: Path, asked: Asked) -> Raw:
    """x, y, z of all points, in the unit that is given: these files rarely say which."""
    try:
        import laspy
    except ImportError:
        raise InputError(
            f"{path.name} must be read with laspy, got an installation without it: "
            "pip install tyrecontact[laz]"
        ) from None
    with laspy.open(path) as file:
        count = file.header.point_count
        if not 3 <= count <= MAX_POINTS:
            raise InputError(f"{path.name} must hold 3 to {MAX_POINTS:g} points, got {count}")
        cloud = file.read()
        points = np.column_stack([np.asarray(cloud[axis], float) for axis in "xyz"])
    if len(points) != count:
        raise InputError(f"{path.name} must hold {count} points, got {len(points)}")
    made = largest_square(triangulated(points), asked.step, scan.MAX_HEIGHTS)
    return Raw(made.heights, "point cloud (LAS)", spacing=made.step, resampled=True, done=made.done)


def triangulated(points: np.ndarray) -> np.ndarray:
    """Triangles between neighbouring points, shape (m, 3, 3), from points of shape (n, 3)."""
    flat = points[:, :2] - points[:, :2].mean(axis=0)
    corners = Delaunay(flat).simplices
    sides = np.linalg.norm(flat[corners] - flat[np.roll(corners, 1, axis=1)], axis=-1)
    near = sides.max(axis=1) <= _GAP * np.median(sides)
    return points[corners[near]]
