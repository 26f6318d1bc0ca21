"""How the road is moved into the tread: indentation, or force, against time (physics, 7)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path as FilePath
from stat import S_ISREG

import numpy as np

from tyrecontact.errors import InputError

#: more steps than this are refused: a slip of a unit, not a study
MAX_STEPS = 500_000
#: a table with more bytes than this is refused before it is read
MAX_TABLE_BYTES = 64_000_000
#: a table that goes beyond these [s], [m or N] is refused: a slip of a unit, and overflow ahead
_LATEST, _FARTHEST = 1e9, 1e6
#: a hold of more than so many memories of the kernel goes on at rest after the second
_LONG, _SETTLING = 20, 2
#: steps at rest in a decade of time
_STEPS_A_DECADE = 12


@dataclass(frozen=True)
class Schedule:
    """All steps of a run.

    Attributes
    ----------
    time [s], drive [m or N] : shape (steps,).
    at_rest : steps at whose end the tread has come to rest: those of a long hold, boolean.
    """

    time: np.ndarray
    drive: np.ndarray
    at_rest: np.ndarray


def straight(share: np.ndarray) -> np.ndarray:
    """Along a straight line from knot to knot."""
    return share


def accelerated(share: np.ndarray) -> np.ndarray:
    """From rest at a constant acceleration."""
    return share**2


def swinging(share: np.ndarray) -> np.ndarray:
    """Half a period of a cosine."""
    return (1 - np.cos(np.pi * share)) / 2


@dataclass(frozen=True)
class Path:
    """What the drive does, from knot to knot.

    Attributes
    ----------
    time, drive : knots [s] and [m or N], shape (knots,), time increasing from 0.
    course : share of a leg's way against share of its time, both from 0 to 1.
    on_grid : knots are moved to the nearest step, of those that meet the nearest is taken;
        otherwise each leg takes a whole number of steps, at least one, so that no knot is lost.
    """

    time: np.ndarray
    drive: np.ndarray
    course: Callable[[np.ndarray], np.ndarray] = straight
    on_grid: bool = False

    def sampled(self, time_step: float) -> tuple[np.ndarray, np.ndarray]:
        """Times [s] and drive [m or N] of all steps of one length, from rest to the end.

        No step is cut short, which would be a jump of the rate.

        Raises
        ------
        InputError : the path takes more than `MAX_STEPS` steps, or fewer than three.
        """
        schedule = self.schedule(time_step, np.inf)
        return schedule.time, schedule.drive

    def schedule(self, time_step: float, memory: float) -> Schedule:
        """All steps, where the tread forgets after a `memory` [s].

        A hold of more than 20 memories is followed step by step for two. By then the tread is
        at rest under its forces; the remainder is taken in steps at rest that grow with the time
        held, so that minutes cost a few dozen.

        Raises
        ------
        InputError : the schedule has more than `MAX_STEPS` steps, or fewer than three.
        """
        legs, drive = self._legs(time_step)
        settling = np.inf if np.isinf(memory) else np.ceil(_SETTLING * memory / time_step)
        long = (np.diff(drive) == 0) & (legs * time_step > _LONG * memory)
        count = np.where(long, settling, legs).sum() + 1
        if not 3 <= count <= MAX_STEPS:
            raise InputError(
                f"loading must take 3 to {MAX_STEPS} steps, got {count:.0f} "
                f"({legs.sum() * time_step:.4g} s in steps of {time_step:.4g} s)"
            )
        parts, rests = [np.zeros(1)], [np.zeros(1, bool)]
        begin = 0.0
        for leg, is_long in zip(legs, long, strict=True):
            steps = _held(leg, settling) if is_long else np.arange(1, leg + 1)
            parts.append(begin + steps)
            rests.append(steps > settling if is_long else np.zeros(steps.size, bool))
            begin += leg
        step = np.concatenate(parts)
        knots = np.concatenate([[0.0], np.cumsum(legs)])
        place = np.interp(step, knots, np.arange(knots.size))
        whole = np.floor(place)
        along = np.interp(whole + self.course(place - whole), np.arange(knots.size), drive)
        return Schedule(step * time_step, along, np.concatenate(rests))

    def _legs(self, time_step: float) -> tuple[np.ndarray, np.ndarray]:
        """Number of steps of each leg, and the drive at the knots.

        A hold is one leg, however many rows of a table it is written in.
        """
        if self.on_grid:
            step = np.rint(self.time / time_step)
            distance = np.abs(self.time / time_step - step)
            distance[[0, -1]] = -1  # both ends are met whatever they are near to
            order = np.lexsort((distance, step))
            step, first = np.unique(step[order], return_index=True)
            drive = self.drive[order[first]]
        else:
            legs = np.maximum(np.rint(np.diff(self.time) / time_step), 1)
            step, drive = np.append(0.0, np.cumsum(legs)), self.drive
        held = np.diff(drive) == 0
        inside = np.zeros(drive.size, bool)
        inside[1:-1] = held[1:] & held[:-1]
        return np.diff(step[~inside]), drive[~inside]


def _held(leg: float, settling: float) -> np.ndarray:
    """Steps of a long hold, in units of a step: every one, then ever fewer."""
    decades = np.log10(leg / settling)
    growing = settling * np.logspace(0, decades, int(np.ceil(decades * _STEPS_A_DECADE)) + 1)
    growing[-1] = leg
    return np.concatenate([np.arange(1, settling + 1), growing[1:]])


def linear(largest: float, rate: float) -> Path:
    """At a constant rate to the largest indentation [m] or force [N]; rate per second."""
    return Path(np.array([0, largest / rate]), np.array([0, largest]))


def quadratic(max_indentation: float, acceleration: float) -> Path:
    """At a constant acceleration [m/s2] from rest; the thesis' C is half of it."""
    duration = np.sqrt(2 * max_indentation / acceleration)
    return Path(np.array([0, duration]), np.array([0, max_indentation]), accelerated)


def sinusoidal(largest: float, lowest: float, period: float, first: float | None = None) -> Path:
    """One period [s] of a cosine from `lowest` to `largest` and back (thesis, Fig. 49).

    [m] or [N]; it begins at `first` instead of `lowest` where that is given.
    """
    begin = lowest if first is None else first
    return Path(np.array([0, 0.5, 1]) * period, np.array([begin, largest, lowest]), swinging)


def load_hold_unload(
    largest: float, rate: float, hold_time: float, unloading_rate: float, retraction: float
) -> Path:
    """In straight lines to the largest indentation [m] or force [N], held [s], and back.

    Rates are per second. The road ends `retraction` beyond where it first touched, so that every
    bond can part.
    """
    legs = np.array([0, largest / rate, hold_time, (largest + retraction) / unloading_rate])
    knots = np.array([0, largest, largest, -retraction])
    kept = np.concatenate([[True], legs[1:] > 0])
    return Path(np.cumsum(legs)[kept], knots[kept])


def table(time: np.ndarray, drive: np.ndarray) -> Path:
    """The user's own: straight lines between times [s] and indentations [m] or forces [N].

    Raises
    ------
    InputError : times that do not increase from 0, or numbers that are not finite.
    """
    if not (np.all(np.isfinite(time)) and np.all(np.isfinite(drive))):
        raise InputError("loading.table must hold finite numbers, got some that are not")
    for what, column, most in (("times", time, _LATEST), ("values", drive, _FARTHEST)):
        found = np.abs(column).max(initial=0.0)
        if not found <= most:
            raise InputError(f"loading.table must hold {what} up to {most:g}, got {found:g}")
    if time.size < 2:
        raise InputError(f"loading.table must have at least 2 rows, got {time.size}")
    if not time[0] >= 0:
        raise InputError(f"loading.table must begin at a time of 0 s or later, got {time[0]:g} s")
    back = np.flatnonzero(np.diff(time) <= 0)
    if back.size:
        row = int(back[0])
        raise InputError(
            f"loading.table must increase in time, got {time[row]:g} s and then "
            f"{time[row + 1]:g} s in row {row + 2}"
        )
    if time[0] > 0:
        time, drive = np.append(0.0, time), np.append(drive[0], drive)
    return Path(time, drive, on_grid=True)


def read_table(path: str | FilePath) -> Path:
    """A table from a text file of two columns: time [s], indentation [m] or force [N].

    White space, comma or semicolon between the numbers, # for comments.

    Raises
    ------
    InputError : a file that is absent, too large or not of that kind, and as `table`.
    """
    try:
        path = FilePath(path).expanduser()
        text = _read_text(path)
    except InputError:
        raise
    except (OSError, ValueError, RuntimeError) as error:  # no such file, name or home
        name, reason = FilePath(path).name, getattr(error, "strerror", None) or error
        raise InputError(f"loading.table must be readable, got {name}: {reason}") from None
    try:
        rows = [line.partition("#")[0].split() for line in text.splitlines()]
        columns = np.array([row for row in rows if row], float)
    except ValueError:
        columns = np.empty(0)
    if columns.ndim != 2 or columns.shape[1] != 2:
        raise InputError(f"loading.table must hold two columns of numbers, got {path.name}")
    return table(columns[:, 0], columns[:, 1])


def _read_text(path: FilePath) -> str:
    """Contents of a file, separators as spaces; bytes that are no text become question marks."""
    found = path.stat()
    if not S_ISREG(found.st_mode):  # a device or a pipe may never end
        raise InputError(f"loading.table must be a file, got {path.name}, which is none")
    if found.st_size > MAX_TABLE_BYTES:
        raise InputError(
            f"loading.table must have at most {MAX_TABLE_BYTES / 1e6:g} MB, "
            f"got {found.st_size / 1e6:.3g} MB"
        )
    text = path.read_text(encoding="utf-8-sig", errors="replace")
    return text.translate(str.maketrans(",;", "  "))
