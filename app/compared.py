"""Runs side by side: in what settings they differ, in what figures, and what cannot be compared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .fields import label_of
from .pinned import Pinned
from .plain_words import three_digits
from .setting_words import with_unit

NONE = "–"
#: part of a scenario -> title of its settings
_PARTS = {
    "road": "Road", "springs": "Springs", "tread": "Tread", "loading": "Loading",
    "adhesion": "Adhesion", "numerics": "Numerics",
}  # fmt: skip


@dataclass(frozen=True)
class Row:
    """One line of a table: its name, and a value with its unit for each run."""

    name: str
    values: tuple[str, ...]


def differences(runs: Sequence[Pinned]) -> list[Row]:
    """Settings that are not the same in all runs."""
    found = []
    for settings in zip(*(run.scenario.settings() for run in runs), strict=True):
        path, parameter, first = settings[0]
        if any(value != first for _, _, value in settings):
            values = tuple(with_unit(parameter, value) for _, _, value in settings)
            found.append(Row(_name(path), values))
    return found


def key_figures(runs: Sequence[Pinned]) -> list[Row]:
    """What each run came to; "–" where it has no such figure."""
    columns = [_figures(run) for run in runs]
    names = columns[0] if columns else ()
    return [Row(name, tuple(column[name] for column in columns)) for name in names]


def notes(runs: Sequence[Pinned]) -> list[str]:
    """One sentence on each thing in which runs can be compared only so far."""
    said = [f"“{run.label}”: {run.remark}." for run in runs if run.remark]
    if _differ(runs, "road", ()):
        said.append(
            "The roads differ: so do the contacts, and a force at the same indentation, which "
            "counts from first touch, belongs to other asperities."
        )
    if _differ(runs, "loading", ()):
        said.append(
            "The road is moved in different ways: compare at the same indentation, not at the "
            "same time."
        )
    if _differ(runs, "numerics", ("time_resolution_factor", "sampling_frequency")):
        said.append("The time steps differ: iterations are those of a step, long or short.")
    return said


def _name(path: str) -> str:
    """The label of a setting, behind the title of its part where it does not say that itself."""
    part, label = _PARTS[path.partition(".")[0]], label_of(path)
    return label if label.startswith(part.rstrip("s")) else f"{part}: {label}"


def _differ(runs: Sequence[Pinned], part: str, names: tuple[str, ...]) -> bool:
    """Whether settings of a part, or all of them, are not the same in all runs."""
    found = [run.scenario.to_dict()[part] for run in runs]
    picked = [[found_in[name] for name in names or found_in] for found_in in found]
    return any(values != picked[0] for values in picked)


def _figures(run: Pinned) -> dict[str, str]:
    results = run.results
    found = results.summary()
    # of a run under way the last stiffness is not the final one
    stiffness = found["final_stiffness"] if run.ended else None
    failed = found["failed_at"]
    where = NONE
    if failed is not None:
        where = f"{failed['step'] + 1}, at {three_digits(failed['indentation'] * 1e6)} µm"
    return {
        "Steps": str(run.steps),
        "Peak force": _value(found["max_force"], "N"),
        "Adherence force": _value(found["adherence_force"], "N"),
        "Final stiffness": _value(stiffness, "MN/m", 1e-6),
        "First failed step": where,
        "Most iterations in a step": str(found["iterations_max"]),
        "Iterations a step, on average": three_digits(found["iterations_mean"]),
        "Bonds released": str(found["releases"]),
        "Largest avalanche": f"{found['largest_avalanche']} bonds" if found["releases"] else NONE,
        "Work of the drive": _value(found["energy"]["drive_work"], "mJ", 1e3),
        "Energy released": _value(found["energy"]["released_energy"], "mJ", 1e3),
    }


def _value(number: float | None, unit: str, factor: float = 1.0) -> str:
    return NONE if number is None else f"{three_digits(number * factor)} {unit}"
