"""Lines of named columns, as profilometers write them: which column is what, and said so."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tyrecontact.errors import InputError
from tyrecontact.road.formats.raw import Raw
from tyrecontact.road.scan import UNITS

_HEIGHT = re.compile(r"height|depth|elevation|level|texture|profile|^z\b", re.IGNORECASE)
_DISTANCE = re.compile(r"distance|position|chainage|station|^x\b", re.IGNORECASE)
#: the last of the signs before m is a µ in an encoding that was not understood
_UNIT = re.compile(r"[(\[]\s*(mm|[uµμ\ufffd]m|m)\s*[)\]]")
#: distances may differ from equal steps by this share of a step (they are rounded in the file)
_REGULAR = 0.1


@dataclass(frozen=True)
class Header:
    """What stands before the numbers, and how these are split; None: at white space."""

    lines: tuple[str, ...]
    delimiter: str | None
    columns: int

    @property
    def skipped(self) -> int:
        """How many lines that is."""
        return len(self.lines)


def from_columns(values: np.ndarray, header: Header, path: Path) -> Raw:
    """The profile in lines of named columns.

    Parameters
    ----------
    values : shape (lines, columns).
    header : its last line names the columns, with units in brackets where it knows them.

    Raises
    ------
    InputError : no column, or several, named as heights; distances that are not regular.
    """
    names = _names(header.lines[-1], values.shape[1])
    height = _found("height", _HEIGHT, names, header, path)[0]
    distance = next(iter(_found("distance", _DISTANCE, names, header, path, needed=False)), None)
    unit = _unit(names[height])
    # profilometers call heights depths and count them up all the same
    doubt = " (if it counts down: height_direction)" if "depth" in names[height].lower() else ""
    done = [
        f"{header.skipped} lines of header skipped",
        f"column {height + 1}, '{names[height]}', read as height, positive up{doubt}",
    ]
    pitch = spacing = None
    if distance is not None:
        step, lateral = _spacing(values[:, distance], path), _unit(names[distance])
        done.append(f"distances from column {distance + 1}, '{names[distance]}'")
        pitch = step * UNITS[lateral] if lateral else None
        # without units at all, both columns are taken to have the one that is given
        spacing = step if not lateral and not unit else None
    unused = [name for place, name in enumerate(names) if place not in (height, distance)]
    done += ["not used: " + ", ".join(f"'{name}'" for name in unused)] if unused else []
    return Raw(
        values[:, height].copy(),
        "text of named columns",
        unit=unit,
        scale=UNITS[unit] if unit else None,
        pitch=pitch,
        spacing=spacing,
        done=tuple(done),
    )


def _names(line: str, columns: int) -> list[str]:
    """Names of the columns: the way of splitting that gives as many as there are columns."""
    for split in (r"\t", ";", ",", r"\s{2,}", r"\s+(?![(\[])"):
        names = [name.strip().strip('"') for name in re.split(split, line.strip())]
        if len(names) == columns:
            return names
    return [line.strip()] if columns == 1 else [f"column {n + 1}" for n in range(columns)]


def _found(
    what: str,
    pattern: re.Pattern[str],
    names: list[str],
    header: Header,
    path: Path,
    needed: bool = True,
) -> list[int]:
    """The one column of that name; none at all, if it is not needed."""
    found = [place for place, name in enumerate(names) if pattern.search(name)]
    if len(found) > 1 or (needed and not found):
        raise InputError(
            f"road file must name one column of {what}s (such as '{what} (mm)'), got {path.name} "
            f"with {header.lines[-1][:100]!r}"
        )
    return found


def _unit(name: str) -> str | None:
    found = _UNIT.search(name)
    return re.sub("[µμ\ufffd]", "u", found[1]) if found else None


def _spacing(distance: np.ndarray, path: Path) -> float:
    if len(distance) < 2:
        raise InputError(f"road file must hold at least 2 distances, got {path.name} with 1")
    even = np.linspace(distance[0], distance[-1], len(distance))
    step = (distance[-1] - distance[0]) / (len(distance) - 1)
    worst = np.abs(distance - even).max()
    if not (step > 0 and worst <= _REGULAR * step):
        raise InputError(
            f"distances must grow in equal steps, got {path.name}, where they depart from a mean "
            f"step of {step:.4g} by {worst:.4g}"
        )
    return float(step)
