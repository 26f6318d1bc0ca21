"""The table of all findings, in Markdown for people and in JSON for programs."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from tyrecontact import figures
from tyrecontact.figures import Figure
from tyrecontact.thesis.findings import Row
from tyrecontact.writing import write_whole

_MARK = {True: "✓", False: "✗"}
_HEAD = ("", "figure", "what", "the thesis", "what comes out", "agrees if")


def write_tables(
    rows: Sequence[Row],
    selected: Sequence[Figure],
    files: Mapping[str, Mapping[str, str]],
    folder: Path,
) -> None:
    """Write folder/thesis.md and folder/thesis.json.

    `files` is figure -> label -> file, as `campaign.files` has it.

    Raises
    ------
    TyreContactError : a folder that cannot be written.
    """
    text, data = markdown(rows), json.dumps(record(rows, selected, files), indent=1)
    write_whole(folder / "thesis.md", lambda path: path.write_text(text, encoding="utf-8"))
    write_whole(folder / "thesis.json", lambda path: path.write_text(data, encoding="utf-8"))


def record(
    rows: Sequence[Row], selected: Sequence[Figure], files: Mapping[str, Mapping[str, str]]
) -> dict[str, Any]:
    """Rows, and the figures with their runs, as plain values."""
    return {
        "agree": sum(row.agrees for row in rows),
        "of": len(rows),
        "rows": [asdict(row) for row in rows],
        "figures": [
            {"name": figure.name, "caption": figure.caption, "runs": files[figure.name]}
            for figure in selected
        ],
    }


def markdown(rows: Sequence[Row]) -> str:
    """The table, and below it the reason of each row that does not agree."""
    agreed = sum(row.agrees for row in rows)
    lines = [
        "# The thesis, and what comes out",
        "",
        "J. Winroth, *Implementation of adhesion and non-linear contact stiffness in a numerical "
        "model for dynamic tyre/road contact*, Chalmers 2010:8. Its road scan is not public; this "
        "is the made default road. Numbers agree within 25 %, statements by the rule of their row.",
        "",
        f"**{agreed} of {len(rows)} rows agree.**",
        "",
        _line(_HEAD),
        _line(["---"] * len(_HEAD)),
    ]
    for row in rows:
        name = figure_title(row.figure)
        lines.append(
            _line([_MARK[row.agrees], name, row.statement, row.thesis, row.found, row.rule])
        )
    missed = [row for row in rows if not row.agrees]
    if missed:
        lines += ["", "## Why the others do not", ""]
        lines += [f"- {figure_title(r.figure)}, {r.statement}: {r.reason}." for r in missed]
    return "\n".join(lines) + "\n"


def figure_title(name: str) -> str:
    """How a figure is called in a text: "Fig. 19", "Figs. 24–26", or "beside" for those added."""
    numbers = figures.find(name).numbers
    if not numbers:
        return "beside"
    if len(numbers) == 1:
        return f"Fig. {numbers[0]}"
    return f"Figs. {numbers[0]}–{numbers[-1]}"


def _line(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"
