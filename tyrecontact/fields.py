"""Fields of a run, as many as fit into a budget of memory: of all steps, or of every k-th.

A field is a map of the elements: at 20 x 20 elements a step has 13 kB of them, a run of 82,000
steps a gigabyte. When the budget is full, every second step's fields are dropped, and from then
on those of every second step are kept; and so on. A run of any length, of a length unknown while
it goes on, so keeps the fields of its first step, of its last, and of steps at an even stride
that fill more than half of the budget. The numbers of a step (`SCALARS`) are all kept.

Why not all fields, in a scratch file: nobody looks at 82,000 maps; a gigabyte a run is much where
visitors share a server, whose temporary folder often is memory itself; what is mapped from a file
counts as memory too; and a full disk would end a run that goes well. Who wants every map asks for
more memory (`numerics.field_memory`), or iterates the simulation, which hands out every step.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tyrecontact.steps import FIELDS, Step

#: bytes of the fields of one element in one step
_BYTES = sum(np.dtype(kind).itemsize for *_, kind in FIELDS.values())


@dataclass(frozen=True)
class FieldTable:
    """Fields of the steps 0, stride, 2 stride, ...; a row is written once, before it is read.

    Attributes
    ----------
    columns : name -> array, shape (rows, ny, nx), as in `FIELDS`.
    capacity : rows until it is full; in one that may become full there is one more.
    stride : steps from one row to the next.
    behind : number of the last step of the run, if it has the row behind the others.
    """

    columns: dict[str, np.ndarray]
    capacity: int
    stride: int = 1
    behind: int | None = None

    @classmethod
    def empty(cls, steps: int, shape: tuple[int, int], memory: float) -> FieldTable:
        """For `steps` steps of `shape` elements, or as many as fit into `memory` [B]; 2 always do.

        While rows are thinned, up to twice that is in use for a moment.
        """
        fitting = int(memory // (shape[0] * shape[1] * _BYTES))
        capacity = min(steps, max(fitting, 2))
        whole = (capacity + (capacity < steps), *shape)
        return cls({n: np.zeros(whole, kind) for n, (*_, kind) in FIELDS.items()}, capacity)

    def with_step(self, index: int, step: Step, final: bool) -> FieldTable:
        """This table after step number `index`; where it was full, a new one.

        Who reads meanwhile has the one or the other, both whole. No step comes after a `final`
        one.
        """
        table = self
        while index % table.stride == 0 and index // table.stride >= table.capacity:
            table = table._thinned()
        if index % table.stride and not final:
            return table
        for name, column in table.columns.items():
            column[-(-index // table.stride)] = getattr(step, name)
        return replace(table, behind=index) if index % table.stride else table

    def steps(self, count: int) -> np.ndarray:
        """Numbers of those among the first `count` steps that have a row, shape (rows,)."""
        rows = np.arange(0, count, self.stride)
        return rows if self.behind is None else np.append(rows, self.behind)

    def _thinned(self) -> FieldTable:
        """Every second row, in arrays of the same capacity."""
        columns = {}
        for name, column in self.columns.items():
            # not zeros_like, which would touch all of it: what is not written takes no memory
            columns[name] = np.zeros(column.shape, column.dtype)
            kept = column[: self.capacity : 2]
            columns[name][: len(kept)] = kept
        return FieldTable(columns, self.capacity, 2 * self.stride)


@dataclass(frozen=True)
class Moment:
    """What was recorded at one moment; a recorder replaces it, in one assignment, by the next.

    Attributes
    ----------
    count : steps recorded.  table : their fields.
    last : the last step, whose fields may have no row in the table; None for no step.
    """

    count: int
    table: FieldTable
    last: Step | None = None

    def after(self, step: Step, final: bool) -> Moment:
        return Moment(self.count + 1, self.table.with_step(self.count, step, final), step)

    @property
    def ends_on_row(self) -> bool:
        """Whether the last step, if any, has a row in the table."""
        last = self.count - 1
        return last < 0 or last % self.table.stride == 0 or last == self.table.behind

    def steps(self) -> np.ndarray:
        """Numbers of the steps whose fields are kept, the last one included; shape (rows,)."""
        rows = self.table.steps(self.count)
        return rows if self.ends_on_row else np.append(rows, self.count - 1)

    def columns(self) -> dict[str, np.ndarray]:
        """Name -> array, shape (rows, ny, nx), one row for each of `steps`.

        Views; but copies where the run was left at a step that has no row.
        """
        rows = len(self.table.steps(self.count))
        views = {name: column[:rows] for name, column in self.table.columns.items()}
        if self.ends_on_row:
            return views
        return {n: np.concatenate([v, getattr(self.last, n)[None]]) for n, v in views.items()}

    def history(self, name: str, row: int, column: int) -> tuple[np.ndarray, np.ndarray]:
        """Of one element: numbers of `steps`, and its values there; shape (rows,) each."""
        rows = len(self.table.steps(self.count))
        values = self.table.columns[name][:rows, row, column]
        if not self.ends_on_row:
            values = np.append(values, getattr(self.last, name)[row, column])
        return self.steps(), values

    def near(self, step: int) -> tuple[int, dict[str, np.ndarray]]:
        """Fields of a step, or of the nearest whose fields are kept: its number; name -> map."""
        row, number = nearest(self.steps(), step, self.count)
        if number == self.count - 1 and not self.ends_on_row:
            return number, {name: getattr(self.last, name) for name in FIELDS}
        return number, {name: column[row] for name, column in self.table.columns.items()}


def nearest(kept: np.ndarray, step: int, count: int) -> tuple[int, int]:
    """Row and number of the step nearest to `step` among those kept of `count`; -1 is the last.

    Raises
    ------
    IndexError : there is no such step.
    """
    wanted = range(count)[step]
    row = int(np.abs(kept - wanted).argmin())
    return row, int(kept[row])
