"""A curve of a run of any length: no more points than a plot can show, the extremes among them."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from bokeh.models import ColumnDataSource

#: points of a curve at most: about two a pixel of a plot's width; each costs the browser time
POINTS = 1200


def extremes(values: np.ndarray, stretch: int) -> np.ndarray:
    """Places of the least and the largest in each stretch of so many values, increasing."""
    if stretch <= 2:
        return np.arange(values.size)
    whole, found = values.size // stretch * stretch, []
    # what is no number, in a run that is lost, hides neither
    for least, unknown in ((np.argmin, np.inf), (np.argmax, -np.inf)):
        known = np.where(np.isnan(values), unknown, values)
        places = least(known[:whole].reshape(-1, stretch), axis=1)
        found.append(np.arange(0, whole, stretch) + places)
        if whole < values.size:
            found.append(np.array([whole + least(known[whole:])]))
    return np.unique(np.concatenate(found))


def _stretch(rows: float) -> int:
    """Steps for two points so that a curve of so many steps has room, and a tenth is left for ends
    of stretches that were drawn early; 1 for a point a step.
    """
    return 1 if rows <= POINTS else math.ceil(2.2 * rows / POINTS)


def _expected(columns: Mapping[str, np.ndarray], rows: np.ndarray) -> float:
    """Steps that will be drawn: all of the run if all were so far, else some more than now."""
    every = rows.size > 0 and rows.size == rows[-1] + 1
    return columns["time"].size if every else rows.size / 0.6


class Trace:
    """Points of a run: time, indentation and a value.

    A point for each step where all of them have room in `POINTS`. Of a longer run there is soon
    one for the least and the largest of each stretch of steps, so long that the whole run has room.
    Of a run that has ended `look` shows a part in full.

    Attributes
    ----------
    source : what is drawn, columns `time_ms`, `indentation_um` and `name`.
    """

    def __init__(self, name: str, column: str, title: str | None = None) -> None:
        self._name, self._column = name, column
        self.source = ColumnDataSource(name=title)
        self.clear()

    def clear(self) -> None:
        self.source.data = {"time_ms": [], "indentation_um": [], self._name: []}
        self._stretch, self._done, self._last = 1, 0, -1
        self._whole_run: tuple[Mapping[str, np.ndarray], np.ndarray] | None = None

    def update(
        self, columns: Mapping[str, np.ndarray], rows: np.ndarray, ended: bool, still: bool = False
    ) -> None:
        """Follow a run whose steps to be drawn are now `rows`, increasing and so far the same.

        The points of a stretch come when it is whole; those of the last one where the run stands
        `still` for a while, or has `ended`. After its end nothing comes.
        """
        if self._whole_run is not None:
            return
        chosen = self._chosen(columns, rows, ended or still)
        size = len(self.source.data["time_ms"]) + chosen.size
        stretch = max(self._stretch, _stretch(_expected(columns, rows)))
        if ended:  # now it is known
            stretch = _stretch(rows.size)
        full = POINTS if stretch == self._stretch else POINTS // 4  # early where it must be anyway
        if size > full or (ended and stretch < self._stretch):
            self._stretch, self._done, still = stretch, 0, True
            chosen = np.union1d(rows[:1], self._chosen(columns, rows, True))
            self.source.data = self._points(columns, chosen)
        elif chosen.size:
            # as text: each array would be two messages of its own
            points = self._points(columns, chosen)
            self.source.stream({name: column.tolist() for name, column in points.items()})
        self._done = max(self._done, self._whole(rows, ended or still))
        if chosen.size:
            self._last = int(chosen[-1])
        if ended:
            needed = ("time", "indentation", self._column)  # not the maps, which are large
            self._whole_run = {name: columns[name] for name in needed}, rows

    def look(self, axis: str, low: float, high: float) -> None:
        """Of a run that has ended: every step from `low` to `high` on an axis, a column of the
        source; or the extremes of stretches that are as short as there is room.
        """
        if self._whole_run is None or self._stretch == 1:
            return
        columns, rows = self._whole_run
        place = self._points(columns, rows)[axis]
        near = rows[(low <= place) & (place <= high)]
        stretch = 1 if near.size <= POINTS else -(-2 * near.size // POINTS)
        detail = near[extremes(columns[self._column][near], stretch)]
        around = rows[extremes(columns[self._column][rows], self._stretch)]
        ends = rows[[0, -1]]
        shown = np.unique(np.concatenate([ends, around, detail]))
        self.source.data = self._points(columns, shown)

    def _whole(self, rows: np.ndarray, all_of_it: bool) -> int:
        return rows.size if all_of_it else rows.size // self._stretch * self._stretch

    def _chosen(
        self, columns: Mapping[str, np.ndarray], rows: np.ndarray, all_of_it: bool
    ) -> np.ndarray:
        """Steps among those of `rows` not looked at yet; where all are meant the last one, too."""
        new = rows[self._done : self._whole(rows, all_of_it)]
        chosen = new[extremes(columns[self._column][new], self._stretch)]
        if all_of_it and rows.size and rows[-1] != (chosen[-1] if chosen.size else self._last):
            chosen = np.append(chosen, rows[-1])
        return chosen

    def _points(
        self, columns: Mapping[str, np.ndarray], chosen: np.ndarray
    ) -> dict[str, np.ndarray]:
        return {
            "time_ms": columns["time"][chosen] * 1e3,
            "indentation_um": columns["indentation"][chosen] * 1e6,
            self._name: columns[self._column][chosen],
        }
