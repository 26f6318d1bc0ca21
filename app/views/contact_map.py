"""Where road and tread touch: one quantity of all elements as a map, live or at a step on show."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from bokeh.events import Press, Tap

from tyrecontact.contact.bonds import ElementState
from tyrecontact.errors import unknown_name
from tyrecontact.results import Record

from .headline import three_digits
from .map_figure import NO_FRAME, NO_MARKS, MapFigure, no_image
from .map_modes import MODES, STATE_COLORS, STATES, Fields
from .map_scale import Scale
from .style import DESK, HALL, Size

_MARKERS = {ElementState.TENSION: "inverted_triangle", ElementState.RELEASED: "circle_x"}


class ContactMapView:
    """A square map, row 0 at the bottom, with its scale below.

    Attributes
    ----------
    root : a Bokeh figure; `drawing` its parts.
    on_tap : is called with row and column of an element that was tapped or clicked.
    mode : name of what is shown, of `MODES`.
    scale : of that mode; the limits of a run only grow.
    """

    def __init__(self) -> None:
        self.on_tap: Callable[[int, int], None] = lambda _row, _column: None
        self.mode = "force"
        self.drawing = MapFigure()
        self.root: Any = self.drawing.root
        self._elements, self._spacing = 20, 1e-3
        self._followed: tuple[int, int] | None = None
        self._settled, self._large = True, False
        self.clear()
        self.enlarge(DESK)
        # while a busy browser draws a run, it takes a tap for a long press
        for kind in (Tap, Press):
            self.root.on_event(kind, self._tapped)

    @property
    def scale(self) -> Scale:
        return self._scales.get(self.mode, Scale())

    def clear(self) -> None:
        """An empty map."""
        self._on_show: tuple[Record, int] | None = None
        self._drawn: tuple[Any, ...] = ()
        self._scales: dict[str, Scale] = {}
        self.drawing.image.data = no_image(self._elements * self._spacing * 1e3)
        self.drawing.marks.data = NO_MARKS
        self._rescale()
        self._more: tuple[str, ...] = ()
        self._entitle()

    def reset(self, side: float, elements: int, peak_force: float | None) -> None:
        """An empty map of a patch of a side [m], whose forces are expected up to a peak [N]."""
        self._elements, self._spacing = elements, side / elements
        self.clear()
        self.drawing.mark_for(elements)
        self._frame()
        if peak_force is not None:
            self.expect(peak_force)

    def expect(self, peak_force: float) -> None:
        """Fix the scale of the forces a little above a force [N], which may come late."""
        grown = self._scales.get("force", Scale()).holding(0.0, 1.05 * peak_force, room=1.0)
        self._scales["force"] = Scale(grown.low, grown.high, fixed=peak_force > 0)
        self._rescale()
        self._draw()

    def show_mode(self, name: str) -> None:
        """Show another quantity, of `MODES`. InputError : there is none of that name."""
        if name not in MODES:
            raise unknown_name("mode of the contact map", name, MODES)
        self.mode = name
        if self._on_show is not None:
            # all of the run so far, so that the limits stay when it is replayed
            self._fit(MODES[name].values(self._on_show[0].maps(), self._spacing**2), room=1.0)
        self._rescale()
        self._entitle()
        self._draw()

    def show(self, record: Record, step: int, spacing: float, settled: bool = True) -> None:
        """Show a step of the record, or the nearest whose fields are kept.

        Parameters
        ----------
        spacing : side of an element [m].
        settled : the step stays on show, and the title names it.
        """
        self._on_show, self._spacing, self._settled = (record, step), spacing, settled
        self._draw()

    def follow(self, row: int, column: int) -> None:
        """Draw a frame around an element."""
        self._followed = row, column
        self._frame()

    def forget(self) -> None:
        """Take the frame away."""
        self._followed = None
        self._frame()

    def enlarge(self, size: Size) -> None:
        """Set the type; the map stays square. Where the type is large its title has two lines."""
        self._large = size == HALL
        self.drawing.enlarge(size, lines=2 if self._large else 1)
        self._entitle()

    def _draw(self) -> None:
        """One update of the image; nothing where it would be the same."""
        if self._on_show is None:
            return
        record, step = self._on_show
        number, fields = record.fields(step)
        if self._drawn == (record, number, self.mode, self.scale, self._settled):
            return
        mode = MODES[self.mode]
        values = mode.values(fields, self._spacing**2)
        self._fit(values)
        categorical = self.mode == "state"
        self.drawing.image.data = {
            "shown": [values.astype(np.float32) if categorical else self.scale.place(values)],
            "value": [np.full_like(values, np.nan) if categorical else values.astype(np.float32)],
            "state": [fields["state"]],
            "side": [len(values) * self._spacing * 1e3],
            "corner": [0.0],
        }
        self._mark(fields if mode.marks else None)
        self._more = (*self._when(record, number), *self._beyond(values))
        self._entitle()
        self._drawn = (record, number, self.mode, self.scale, self._settled)

    def _entitle(self) -> None:
        title, more = MODES[self.mode].title, ", ".join(self._more)
        said = f"{title}\n{more or ' '}" if self._large else ", ".join((title, *self._more))
        if self.root.title.text != said:
            self.root.title.text = said

    def _beyond(self, values: np.ndarray) -> list[str]:
        beyond = np.count_nonzero(values > self.scale.high) if self.scale.fixed else 0
        return [f"{beyond} beyond scale"] if beyond else []

    def _when(self, record: Record, number: int) -> list[str]:
        """Of a step that stays on show: for another title the plot is laid out anew."""
        if not self._settled:
            return []
        time = three_digits(float(record.columns["time"][number]) * 1e3)
        return [f"step {number + 1}, {time} ms"]

    def _fit(self, values: np.ndarray, room: float = 1.5) -> None:
        """Limits that hold these values, too."""
        known = values[np.isfinite(values)]
        grown = self.scale.holding(known.min(initial=0.0), known.max(initial=0.0), room)
        if self.mode != "state" and grown != self.scale:
            self._scales[self.mode] = grown
            self._rescale()

    def _rescale(self) -> None:
        """Colours and their bar, after a change of mode or limits."""
        if self.mode == "state":
            self.drawing.colour(STATE_COLORS, -0.5, len(STATES) - 0.5)
            self.drawing.label(dict(enumerate(STATES)))
        else:
            self.drawing.colour(self.scale.palette, -1.0 if self.scale.low else 0.0, 1.0)
            self.drawing.label(self.scale.ticks)
        self.drawing.unit = MODES[self.mode].unit

    def _mark(self, fields: Fields | None) -> None:
        """Elements in tension and released ones carry a mark: colour alone says too little."""
        marked: dict[str, list[Any]] = {name: [] for name in NO_MARKS}
        for state, marker in _MARKERS.items() if fields else ():
            assert fields is not None
            rows, columns = np.nonzero(fields["state"] == state)
            marked["x"] += ((columns + 0.5) * self._spacing * 1e3).tolist()
            marked["y"] += ((rows + 0.5) * self._spacing * 1e3).tolist()
            marked["marker"] += [marker] * rows.size
        if marked != self.drawing.marks.data:
            self.drawing.marks.data = marked

    def _frame(self) -> None:
        if self._followed is None or max(self._followed) >= self._elements:
            self.drawing.frame.data = NO_FRAME
            return
        row, column = self._followed
        side = self._spacing * 1e3
        self.drawing.frame.data = {
            "x": [(column + 0.5) * side], "y": [(row + 0.5) * side], "side": [side]
        }  # fmt: skip

    def _tapped(self, event: Any) -> None:
        known = all(isinstance(at, float | int) and math.isfinite(at) for at in (event.x, event.y))
        if self._on_show is None or not known:
            return
        row, column = (math.floor(place * 1e-3 / self._spacing) for place in (event.y, event.x))
        if 0 <= row < self._elements and 0 <= column < self._elements:
            self.on_tap(row, column)
