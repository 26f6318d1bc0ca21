"""The figures that matter now, and one sentence on the state of the run."""

from __future__ import annotations

from html import escape

import panel as pn

from tyrecontact.key_figures import first_unstable

from ..runner import Phase, Run

_STYLE = """
:host { --muted: color-mix(in srgb, currentColor 62%, transparent); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(104px, 1fr)); gap: 8px; }
.figure { border: 1px solid color-mix(in srgb, currentColor 18%, transparent);
          border-radius: 8px; padding: 6px 10px; min-width: 0; }
.label { font-size: 12px; color: var(--muted); white-space: nowrap; overflow: hidden;
         text-overflow: ellipsis; }
.value { font-size: 18px; font-variant-numeric: tabular-nums; white-space: nowrap; }
.unit { font-size: 12px; color: var(--muted); margin-left: 3px; }
.state { margin: 10px 2px 0; min-height: 40px; font-size: 14px; line-height: 20px; }
.bad { color: #D55E00; font-weight: 600; }
"""


class HeadlineView:
    """Attributes: `root` a pane; `figures` name -> (value, unit) shown; `sentence` the state;
    `notice` what was not accepted, if anything."""

    def __init__(self) -> None:
        self.figures: dict[str, tuple[str, str]] = {}
        self.sentence = ""
        self.notice = ""
        self.root = pn.pane.HTML(
            "", stylesheets=[_STYLE], sizing_mode="stretch_width", margin=(4, 8)
        )
        self.rest()

    def rest(self) -> None:
        """Before the first run."""
        self._show(_figures(None), "Press Run: a rubber tread block is pressed onto a rough road.")

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
        self._show(_figures(run), sentence, bad)

    def _show(self, figures: dict[str, tuple[str, str]], sentence: str, bad: bool = False) -> None:
        self.figures, self.sentence, self._bad = figures, sentence, bad
        self._draw()

    def _draw(self) -> None:
        cells = "".join(
            f'<div class="figure"><div class="label">{escape(name)}</div>'
            f'<div class="value">{escape(value)}<span class="unit">{escape(unit)}</span></div>'
            "</div>"
            for name, (value, unit) in self.figures.items()
        )
        kind = "state bad" if self._bad else "state"
        notice = f'<div class="bad" role="alert">{escape(self.notice)}</div>' if self.notice else ""
        # a screen reader would read every step aloud: the sentence is there to be looked up
        self.root.object = (
            f'<div class="figures">{cells}</div><div class="{kind}" role="status" aria-live="off">'
            f"{notice}{escape(self.sentence)}</div>"
        )


def _figures(run: Run | None) -> dict[str, tuple[str, str]]:
    names = {"Indentation": "µm", "Force": "N", "Contacts": "", "Iterations": "",
             "Peak force": "N", "Adherence": "N", "Final stiffness": "MN/m"}  # fmt: skip
    shown = {name: ("–", unit) for name, unit in names.items()}
    if run is None or run.record is None or run.record.count == 0:
        return shown
    columns, last = run.record.columns, run.record.count - 1
    force = columns["contact_force"]
    shown["Indentation"] = (f"{columns['indentation'][last] * 1e6:.1f}", "µm")
    shown["Force"] = (three_digits(force[last]), "N")
    shown["Contacts"] = (str(columns["contacts"][last]), "")
    shown["Iterations"] = (str(columns["iterations"][last]), "")
    shown["Peak force"] = (three_digits(force[: last + 1].max()), "N")
    results = run.results() if run.phase.ended else None
    if results is not None and results.adherence_force is not None:
        shown["Adherence"] = (three_digits(results.adherence_force), "N")
    if results is not None and results.final_stiffness is not None:
        shown["Final stiffness"] = (three_digits(results.final_stiffness / 1e6), "MN/m")
    return shown


def three_digits(value: float) -> str:
    """A number to three significant digits, without an exponent where it can be helped."""
    if value == 0:
        return "0"
    if not 1e-3 <= abs(value) < 1e5:
        return f"{value:.2e}"
    digits = f"{value:#.3g}"
    return f"{float(digits):.0f}" if "e" in digits else digits.rstrip(".")


def describe(run: Run) -> tuple[str, bool]:
    """One sentence on a run in plain words, and whether it is bad news."""
    if run.phase is Phase.REFUSED:
        return f"Not run: {run.message}.", True
    if run.record is None or run.simulation is None:
        return _before_the_first_step(run), False
    count, total = run.record.count, len(run.simulation)
    failure = _failure(run, count)
    if run.phase is Phase.FAILED:
        return f"Failed after step {count}; what was computed stays: {run.message}.", True
    if run.phase is not Phase.STOPPED and run.record.stop_reason:
        reason = run.record.stop_reason
        return f"{reason[:1].upper()}{reason[1:]}.", True
    so_far = {
        Phase.STOPPED: f"Stopped at step {count} of {total}; what was computed stays",
        Phase.FINISHED: f"Complete, {total} steps",
    }.get(run.phase, f"Step {count} of {total}")
    return f"{so_far}: {failure or _warning(run, count) or 'all converged.'}", bool(failure)


def _before_the_first_step(run: Run) -> str:
    if run.phase is Phase.STOPPED:
        return "Stopped before the first step."
    return "Stopping …" if run.stopping else "Preparing road, springs and kernel …"


def _warning(run: Run, count: int) -> str:
    """What is coming, before it comes."""
    assert run.record is not None
    columns = {name: column[:count] for name, column in run.record.columns.items()}
    step = first_unstable(columns)
    if step is None:
        return ""
    return (
        f"all converged; from {columns['indentation'][step] * 1e6:.1f} µm on the springs are too "
        "stiff for the band-limited kernel (stability margin below 0), and it may blow up."
    )


def _failure(run: Run, count: int) -> str:
    assert run.record is not None
    bad = (run.record.columns["converged"][:count] == 0).nonzero()[0]
    if bad.size == 0:
        return ""
    first = int(bad[0])
    columns = run.record.columns
    advice = "try a smaller time step or more iterations"
    if run.scenario.numerics.kernel == "band-limited":
        advice = (
            "the band-limited kernel is unstable on stiff springs; try time-resolution factor 4, "
            "or the passive kernel"
        )
    return (
        f"{bad.size} not converged, the first at step {first} and "
        f"{columns['indentation'][first] * 1e6:.1f} µm after {columns['iterations'][first]} "
        f"iterations, residual {columns['residual'][first]:.1e} m; {advice}."
    )
