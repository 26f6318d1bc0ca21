"""What `tyrecontact thesis` has written, drawn as one page that needs nothing from outside.

`python -m app.report DIR` reads DIR/thesis.json and DIR/runs and writes DIR/report.html.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any

import xarray as xr
from bokeh.embed import components
from bokeh.util.paths import bokehjs_path

from tyrecontact import figures
from tyrecontact.errors import InputError, TyreContactError
from tyrecontact.thesis import runs
from tyrecontact.thesis.table import figure_title
from tyrecontact.writing import write_whole

from .figure_panels import PANELS, kernel_panels, spring_panels
from .views.comparison import Panel, draw

_STYLE = (Path(__file__).parent / "report.css").read_text(encoding="utf-8")
_CURVES = {"fig-22": kernel_panels, "fig-39": spring_panels}


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry of `python -m app.report`; returns the exit code (2: a folder that cannot be used)."""
    parser = argparse.ArgumentParser(prog="python -m app.report", description=__doc__)
    parser.add_argument("folder", type=Path, metavar="DIR", help="written by tyrecontact thesis")
    folder = parser.parse_args(arguments).folder
    try:
        page = report(folder)
        target = folder / "report.html"
        write_whole(target, lambda path: path.write_text(page, encoding="utf-8"))
    except TyreContactError as error:
        print(f"app.report: {error}", file=sys.stderr)
        return 2
    print(target)
    return 0


def report(folder: Path) -> str:
    """The page.

    Raises
    ------
    InputError : a folder that `tyrecontact thesis` has not written, or not completely.
    """
    try:
        record = json.loads((folder / "thesis.json").read_text(encoding="utf-8"))
        families = {entry["name"]: panels_of(folder, entry) for entry in record["figures"]}
    except (OSError, ValueError, KeyError) as error:
        raise InputError(
            f"DIR must be a folder written by `tyrecontact thesis --output DIR`, got {folder}: "
            f"{str(error).splitlines()[0]}"
        ) from None
    plots = {
        f"{name}-{number}": draw(panel)
        for name, panels in families.items()
        for number, panel in enumerate(panels)
    }
    script, places = components(plots) if plots else ("", {})
    sections = [
        _section(entry, record["rows"], families[entry["name"]], places)
        for entry in record["figures"]
    ]
    return _page(record, "\n".join(sections), script)


def panels_of(folder: Path, entry: Mapping[str, Any]) -> list[Panel]:
    """What is drawn of a figure, an entry of thesis.json, from its runs in a folder."""
    name = entry["name"]
    if name in _CURVES:
        with xr.open_dataset(folder / entry["runs"][""]) as dataset:
            return _CURVES[name](dataset)
    family = {label: runs.read(folder / file) for label, file in entry["runs"].items()}
    return [panel(family) for panel in PANELS.get(name, ())] if family else []


def _section(
    entry: Mapping[str, Any],
    rows: Sequence[Mapping[str, Any]],
    panels: Sequence[Panel],
    places: Mapping[str, str],
) -> str:
    name = entry["name"]
    found = [row for row in rows if row["figure"] == name]
    plots = "".join(
        f'<div class="plot">{places[f"{name}-{number}"]}</div>' for number in range(len(panels))
    )
    return (
        f'<section id="{escape(name)}"><h2>{escape(_heading(name))}</h2>'
        f"<p>{escape(entry['caption'])}</p>{_legend(panels, list(entry['runs']))}"
        f'<div class="plots">{plots}</div><ul class="found">{"".join(map(_finding, found))}</ul>'
        "</section>"
    )


def _heading(name: str) -> str:
    return figure_title(name) if figures.find(name).numbers else name.replace("-", " ").capitalize()


def _legend(panels: Sequence[Panel], labels: Sequence[str]) -> str:
    """One legend for all plots of a figure, in the order of its family."""
    looks = {curve.label: curve.style for panel in panels for curve in panel.curves}
    looks = {label: looks[label] for label in [*labels, *looks] if label in looks}
    entries = "".join(
        f'<li><span class="line" style="background:{style.color};opacity:{style.alpha};'
        f'height:{max(style.width, 2):g}px"></span>{escape(label)}</li>'
        for label, style in looks.items()
    )
    return f'<ul class="legend">{entries}</ul>'


def _finding(row: Mapping[str, Any]) -> str:
    reason = f" Why not: {escape(row['reason'])}." if row["reason"] else ""
    return f"<li>{_mark(row)} {escape(row['statement'])}: {escape(row['found'])}.{reason}</li>"


def _mark(row: Mapping[str, Any]) -> str:
    kind, word = ("yes", "agrees") if row["agrees"] else ("no", "differs")
    return f'<span class="mark {kind}">{word}</span>'


def _table(rows: Sequence[Mapping[str, Any]]) -> str:
    heads = ("", "Figure", "What", "The thesis", "What comes out", "Agrees if")
    body = []
    for row in rows:
        link = f'<a href="#{escape(row["figure"])}">{escape(figure_title(row["figure"]))}</a>'
        reason = f'<div class="why">{escape(row["reason"])}</div>' if row["reason"] else ""
        cells = (
            _mark(row), link, escape(row["statement"]) + reason, escape(row["thesis"]),
            escape(row["found"]), escape(row["rule"]),
        )  # fmt: skip
        body.append(
            "<tr>"
            + "".join(
                f'<td data-head="{head}">{cell}</td>'
                for head, cell in zip(heads, cells, strict=True)
            )
            + "</tr>"
        )
    head = "".join(f'<th scope="col">{name}</th>' for name in heads)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(body)}</tbody></table>"


def _page(record: Mapping[str, Any], sections: str, script: str) -> str:
    # not `Resources.render_js`: it adds what other imported packages would load from a server
    library = bokehjs_path() / "js" / "bokeh.min.js"
    links = "".join(
        f'<a href="#{escape(entry["name"])}">{escape(_heading(entry["name"]))}</a>'
        for entry in record["figures"]
    )
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>The thesis, and what comes out</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,"><style>{_STYLE}</style></head>
<body><header><h1>The thesis, and what comes out</h1>
<p>J. Winroth, <cite>Implementation of adhesion and non-linear contact stiffness in a numerical
model for dynamic tyre/road contact</cite>, Chalmers 2010:8, run anew by tyrecontact on its made
default road; the thesis' own scan is not public. Numbers agree within 25 %, statements by the rule
of their row.</p>
<p class="sum"><strong>{record["agree"]} of {record["of"]}</strong> findings agree.</p></header>
<main><section id="table"><h2>Table</h2>{_table(record["rows"])}</section>
<nav aria-label="Figures">{links}</nav>{sections}</main>
<script>{library.read_text(encoding="utf-8")}</script>{script}</body></html>
"""


if __name__ == "__main__":
    sys.exit(main())
