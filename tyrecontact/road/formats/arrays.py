"""numpy's own files, `.npy` and `.npz`: heights alone, neither pitch nor unit."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.formats.raw import Asked, Raw, require_size


def read_npy(path: Path, _: Asked) -> Raw:
    """An array file."""
    heights = np.lib.format.open_memmap(path, mode="r")  # sized before it is read; no pickles
    require_size(heights.size, path)
    return _of_real_numbers(heights, path, "numpy array")


def read_npz(path: Path, _: Asked) -> Raw:
    """An archive with an array "heights", or with a single array."""
    with zipfile.ZipFile(path) as archive:
        unpacked = sum(entry.file_size for entry in archive.infolist())
        require_size(unpacked // 8, path)
        for entry in archive.infolist():
            require_size(_announced(archive, entry), path)
    with np.load(path, allow_pickle=False) as arrays:
        names = list(arrays)
        if "heights" not in names and len(names) != 1:
            raise InputError(
                f"{path.name} must hold an array 'heights' or a single array, got {names}"
            )
        heights = arrays["heights" if "heights" in names else names[0]]
    require_size(heights.size, path)
    return _of_real_numbers(heights, path, "numpy archive")


def _announced(archive: zipfile.ZipFile, entry: zipfile.ZipInfo) -> int:
    """How many heights an array in an archive says that it has; numpy makes room for them."""
    if not entry.filename.endswith(".npy"):
        return 0
    with archive.open(entry) as file:
        version = np.lib.format.read_magic(file)
        header = np.lib.format.read_array_header_1_0
        if version != (1, 0):
            header = np.lib.format.read_array_header_2_0
        return int(np.prod(header(file)[0], dtype=float))


def _of_real_numbers(heights: np.ndarray, path: Path, kind: str) -> Raw:
    if heights.dtype.kind not in "fiu":
        raise InputError(
            f"road file must hold a matrix of real numbers, got {path.name} with shape "
            f"{heights.shape} of {heights.dtype}"
        )
    return Raw(np.array(heights, float), kind)
