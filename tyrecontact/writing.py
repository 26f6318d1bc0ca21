"""Files that are whole or absent: written beside their target, then renamed."""

from __future__ import annotations

import errno
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from tyrecontact.errors import InputError, TyreContactError


def require_writable(path: Path) -> None:
    """Refuse an output that cannot be written before the run, not after it.

    Raises
    ------
    InputError : the path names a folder, or a file that cannot be written.
    """
    try:
        if path.resolve().is_dir():
            raise IsADirectoryError(errno.EISDIR, "it is a folder")
        _try(_part(path))
    except (OSError, ValueError) as error:
        raise _refusal("file", path, error) from None


def require_folder(path: Path) -> None:
    """Make a folder for outputs, and refuse one that cannot be written.

    Raises
    ------
    InputError : it cannot be made, or nothing can be written there.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
        _try(path / "trial.part")
    except (OSError, ValueError) as error:
        raise _refusal("folder", path, error) from None


def write_whole(path: Path, write: Callable[[Path], Any]) -> None:
    """Have `write` write a file that takes its name when it is complete.

    Raises
    ------
    TyreContactError : it could not be written; what was there before is still there.
    """
    part = _part(path)
    try:
        write(part)
        part.replace(path.resolve())
    except OSError as error:
        raise TyreContactError(f"--output could not be written, {path}: {error}") from error
    finally:
        with suppress(OSError):
            part.unlink(missing_ok=True)


def _part(path: Path) -> Path:
    target = path.resolve()
    return target.with_name(f"{target.name}.part")


def _try(path: Path) -> None:
    path.touch()
    path.unlink()


def _refusal(kind: str, path: Path, error: Exception) -> InputError:
    reason = getattr(error, "strerror", None) or error
    return InputError(f"--output must name a {kind} that can be written, got {path}: {reason}")
