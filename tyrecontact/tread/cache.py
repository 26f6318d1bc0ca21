"""Kernels kept on disk, under a hash of everything that they depend on.

A file is believed only if it names its fingerprint and its values have the digest that was
written with them; anything else is built anew. Nothing is ever unpickled.
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from platformdirs import user_cache_path

from tyrecontact.tread import kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import Layer

#: raise it when a change of the code changes the numbers of a kernel
_FORMAT = 2


def directory() -> Path:
    """Where kernels are kept: `TYRECONTACT_CACHE`, or the user's cache directory."""
    chosen = os.environ.get("TYRECONTACT_CACHE")
    return Path(chosen) if chosen else user_cache_path("tyrecontact") / "kernels"


def passive(
    layers: Sequence[Layer],
    shape: tuple[int, int],
    spacing: float,
    time_step: float,
    lags: int,
    quadrature: str = "BDF2",
) -> Kernel:
    """`kernels.passive`, from the disk if it is there."""
    frequency = np.append(kernels.quadrature_frequencies(time_step, lags, quadrature), 0)
    method = "passive" if quadrature == "BDF2" else f"passive {quadrature}"
    key = fingerprint(method, layers, shape, spacing, time_step, lags, frequency)
    return _kept(key, lambda: kernels.passive(layers, shape, spacing, time_step, lags, quadrature))


def passive_mobility(
    layers: Sequence[Layer], shape: tuple[int, int], spacing: float, time_step: float, lags: int
) -> Kernel:
    """`kernels.passive_mobility`, from the disk if it is there."""
    frequency = kernels.band_frequencies(time_step, lags)
    key = fingerprint("passive-mobility", layers, shape, spacing, time_step, lags, frequency)
    return _kept(key, lambda: kernels.passive_mobility(layers, shape, spacing, time_step, lags))


def band_limited(
    layers: Sequence[Layer], shape: tuple[int, int], spacing: float, time_step: float, lags: int
) -> Kernel:
    """`kernels.band_limited`, from the disk if it is there."""
    frequency = kernels.band_frequencies(time_step, lags)
    key = fingerprint("band-limited", layers, shape, spacing, time_step, lags, frequency)
    return _kept(key, lambda: kernels.band_limited(layers, shape, spacing, time_step, lags))


def static(layers: Sequence[Layer], shape: tuple[int, int], spacing: float) -> Kernel:
    """`kernels.static`, from the disk if it is there."""
    key = fingerprint("static", layers, shape, spacing, np.inf, 1, np.zeros(1))
    return _kept(key, lambda: kernels.static(layers, shape, spacing))


def fingerprint(
    method: str,
    layers: Sequence[Layer],
    shape: tuple[int, int],
    spacing: float,
    time_step: float,
    lags: int,
    laplace_frequency: np.ndarray,
) -> str:
    """Hash of all that a kernel depends on; a modulus counts by its values where it is used."""
    digest = hashlib.sha256()
    digest.update(repr((_FORMAT, method, shape, spacing, time_step, lags)).encode())
    for layer in layers:
        digest.update(repr((layer.thickness, layer.density, layer.poissons_ratio)).encode())
        digest.update(np.asarray(layer.modulus(laplace_frequency), complex).tobytes())
    return digest.hexdigest()


def _kept(key: str, build: Callable[[], Kernel]) -> Kernel:
    path = directory() / f"{key}.npz"
    kernel = _read(path, key)
    if kernel is None:
        kernel = build()
        _write(path, key, kernel)
    return kernel


def _read(path: Path, key: str) -> Kernel | None:
    """The kernel in a file, or None where the file is absent, damaged or not ours."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as stored:
            if str(stored["fingerprint"]) != key:
                return None
            values, geometry = stored["values"], stored["geometry"]
            if str(stored["digest"]) != _digest(values, geometry):
                return None
            return Kernel(values, float(geometry[0]), float(geometry[1]))
    except Exception:  # whatever numpy and zipfile make of damaged bytes
        return None


def _write(path: Path, key: str, kernel: Kernel) -> None:
    """Write beside the target and rename, so that no reader ever sees half a file."""
    geometry = np.array([kernel.spacing, kernel.time_step])
    digest = _digest(kernel.values, geometry)
    temporary = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as file:
            temporary = Path(file.name)
            np.savez(file, values=kernel.values, geometry=geometry, fingerprint=key, digest=digest)
        temporary.replace(path)
    except OSError:
        pass  # a cache that cannot be written costs time, not the run
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def _digest(values: np.ndarray, geometry: np.ndarray) -> str:
    digest = hashlib.blake2b(repr((values.shape, values.dtype.str)).encode())
    for array in (values, geometry):
        digest.update(np.ascontiguousarray(array).data)  # no copy: kernels may be large
    return digest.hexdigest()
