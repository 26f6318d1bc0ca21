"""How a finding is judged, and how the table tells it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tyrecontact import figures
from tyrecontact.thesis import FINDINGS, findings, table
from tyrecontact.thesis.findings import Claim, Numbers, Row


def numbers(*found: float, expected: tuple[float, ...] = (10, 20), slack: float = 0.0) -> Row:
    finding = Numbers("fig-44", "Loads", expected, "N", lambda _: found, "the road", slack)
    return finding.judged({})


def test_numbers_agree_within_a_quarter() -> None:
    row = numbers(12.5, 15)
    assert row.agrees
    assert (row.thesis, row.found) == ("10, 20 N", "12.5 (+25 %), 15 (−25 %) N")
    assert (row.rule, row.reason) == ("each within 25 %", "")


@pytest.mark.parametrize("found", [(12.6, 20), (10, 14.9), (np.nan, 20), (10, np.inf)])
def test_one_number_that_does_not_makes_the_row_disagree(found: tuple[float, float]) -> None:
    row = numbers(*found)
    assert not row.agrees
    assert row.reason == "the road"


def test_small_numbers_have_a_slack() -> None:
    assert numbers(1.9, 20, expected=(1, 20), slack=1.0).agrees
    assert not numbers(1.9, 20, expected=(1, 20)).agrees


def test_a_claim_tells_its_reason_only_where_it_disagrees() -> None:
    for agrees, reason in ((True, ""), (False, "because")):
        claim = Claim("fig-43", "It grows", "yes", "it does", lambda _: ("so", agrees), "because")  # noqa: B023
        row = claim.judged({})
        assert (row.agrees, row.reason) == (agrees, reason)


def test_only_figures_that_were_run_are_judged() -> None:
    claims = [Claim(name, "", "", "", lambda _: ("", True)) for name in ("fig-43", "fig-44")]
    assert [row.figure for row in findings.judged(claims, {"fig-44": {}})] == ["fig-44"]


def test_every_finding_belongs_to_a_figure_and_can_say_why_not() -> None:
    for finding in FINDINGS:
        assert finding.figure in figures.FIGURES
    silent = [finding.statement for finding in FINDINGS if not finding.reason]
    # these two hold by construction
    assert silent == [
        "Quasi-statically, two solvers give one curve",
        "Time step at factors 1, 2 and 4",
    ]


def test_every_row_of_the_specification_is_there() -> None:
    """Section 10 of the specification, row by row."""
    said = {(f.figure, getattr(f, "expected", None) and tuple(f.expected)) for f in FINDINGS}
    for row in [
        ("fig-30-34", (30, 40, 80, 270)), ("fig-35-38", (40, 60, 120, 390)),
        ("fig-44", (14, 62, 150)), ("fig-44", (16, 23, 28)), ("fig-46", (1.7, 2.4, 3.7, 7.2, 24)),
        ("fig-19", None), ("fig-27-29", None), ("fig-21", None), ("fig-45", None),
        ("fig-46", None), ("fig-49", None), ("fig-30-34", None), ("fig-35-38", None),
    ]:  # fmt: skip
        assert row in said


def test_the_tables_hold_every_row_and_why_some_do_not_agree(tmp_path: Path) -> None:
    rows = [numbers(10, 20), numbers(10, 50)]
    selected = [figures.find("44"), figures.find("cause")]
    files = {"fig-44": {"14 N": "runs/a.nc"}, "cause": {}}
    table.write_tables(rows, selected, files, tmp_path)
    text = (tmp_path / "thesis.md").read_text(encoding="utf-8")
    assert "**1 of 2 rows agree.**" in text
    assert "| ✓ | Fig. 44 | Loads | 10, 20 N | 10 (+0 %), 20 (+0 %) N | each within 25 % |" in text
    assert "| ✗ | Fig. 44 | Loads |" in text
    assert text.endswith("- Fig. 44, Loads: the road.\n")
    record = json.loads((tmp_path / "thesis.json").read_text(encoding="utf-8"))
    assert (record["agree"], record["of"]) == (1, 2)
    assert record["rows"][1]["reason"] == "the road"
    assert record["figures"][0]["runs"] == files["fig-44"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["thesis.json", "thesis.md"]


def test_a_bar_in_a_cell_does_not_break_the_table() -> None:
    row = Row("fig-44", "a | b", "", "", True, "", "")
    assert "a \\| b" in table.markdown([row])
