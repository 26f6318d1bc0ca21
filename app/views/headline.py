"""The figures that matter now, progress, and one sentence on the state of the run."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar

from ..plain_words import describe, duration, three_digits, true_minus
from ..runner import Run
from ..told import Told

_REST = "Press Run: a rubber tread block is pressed onto a rough road, element by element."
#: name -> unit of a figure before there is one
_NAMES = {"Indentation": "µm", "Force": "N", "Contacts": "", "Iterations": "",
          "Peak force": "N", "Adherence force": "N", "Final stiffness": "MN/m"}  # fmt: skip


class Headline(Told):
    """Figures, progress and sentence; `state` is a dictionary of plain values."""

    _esm = Path(__file__).parent / "headline.js"
    _stylesheets: ClassVar[list[Any]] = [Path(__file__).parent / "headline.css"]


class HeadlineView:
    """Attributes: `root` a component; `figures` name -> (value, unit) shown; `sentence` the state;
    `notice` what was not accepted, if anything."""

    def __init__(self) -> None:
        self.figures: dict[str, tuple[str, str]] = {}
        self.sentence = self.notice = ""
        self._state: dict[str, Any] = {}
        self.root = Headline(sizing_mode="stretch_width", margin=(6, 10, 0, 10))
        self.rest()

    def rest(self) -> None:
        """Before the first run."""
        self._show(_figures(None), _REST)

    def refuse(self, sentence: str) -> None:
        """Say why something was not accepted; it stays until `accept`."""
        self.notice = f"Not accepted: {sentence}."
        self._draw()

    def accept(self) -> None:
        """Take back what was said of something not accepted."""
        if self.notice:
            self.notice = ""
            self._draw()

    def update(self, run: Run) -> None:
        """Show a run as far as it has come."""
        sentence, bad = describe(run)
        left = run.time_left
        self._show(
            _figures(run), sentence, bad=bad, progress=round(run.progress, 3),
            left="" if left is None else f"{duration(left)} left", ended=run.phase.ended,
        )  # fmt: skip

    def _show(self, figures: dict[str, tuple[str, str]], sentence: str, **state: Any) -> None:
        self.figures, self.sentence, self._state = figures, sentence, state
        self._draw()

    def _draw(self) -> None:
        figures = [[name, value, unit] for name, (value, unit) in self.figures.items()]
        state = {"figures": figures, "sentence": self.sentence, "notice": self.notice}
        self.root.tell({**state, **self._state})


def _figures(run: Run | None) -> dict[str, tuple[str, str]]:
    shown = {name: ("–", unit) for name, unit in _NAMES.items()}
    if run is None or run.record is None or run.record.count == 0:
        return shown
    record = run.record
    columns, last = record.columns, record.count - 1
    force = columns["contact_force"]
    shown["Indentation"] = (true_minus(f"{columns['indentation'][last] * 1e6:.1f}"), "µm")
    shown["Force"] = (three_digits(force[last]), "N")
    elements = record.fields(last)[1]["state"].size
    shown["Contacts"] = (str(columns["contacts"][last]), f"of {elements}")
    most = run.scenario.numerics.max_iterations
    shown["Iterations"] = (str(columns["iterations"][last]), f"of {most}")
    shown["Peak force"] = (three_digits(force[: last + 1].max()), "N")
    results = run.results() if run.phase.ended else None
    if results is not None and results.adherence_force is not None:
        shown["Adherence force"] = (three_digits(results.adherence_force), "N")
    if results is not None and results.final_stiffness is not None:
        shown["Final stiffness"] = (three_digits(results.final_stiffness / 1e6), "MN/m")
    return shown
