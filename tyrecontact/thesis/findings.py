"""What the thesis says, measured: each finding becomes a row of the table, agreed or not."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from tyrecontact.results import Results
from tyrecontact.thesis.wording import signed

#: label -> run, of one figure
Family = Mapping[str, Results]
#: what comes out as text, and whether it agrees; or as numbers
Judge = Callable[[Family], tuple[str, bool]]
Measure = Callable[[Family], Sequence[float]]
#: numbers agree within this share of the thesis'
TOLERANCE = 0.25


@dataclass(frozen=True)
class Row:
    """A finding, judged.

    Attributes
    ----------
    figure : name of the figure.  statement : what is claimed.
    thesis, found : what the thesis says of it, and what comes out, as text with units.
    agrees : whether the rule is met.  rule : in words.  reason : why it is not met, or empty.
    """

    figure: str
    statement: str
    thesis: str
    found: str
    agrees: bool
    rule: str
    reason: str


class Finding(Protocol):
    """A claim of the thesis about one figure."""

    @property
    def figure(self) -> str: ...

    def judged(self, family: Family) -> Row: ...


@dataclass(frozen=True)
class Numbers:
    """Numbers of the thesis, each to be met within 25 %.

    Attributes
    ----------
    expected : of the thesis, in `unit`.  measure : the same numbers of the runs.
    slack : absolute difference [unit] that is always allowed, for numbers near nothing.
    reason : why they are not met, where they are not.
    """

    figure: str
    statement: str
    expected: Sequence[float]
    unit: str
    measure: Measure
    reason: str = ""
    slack: float = 0.0

    def judged(self, family: Family) -> Row:
        found = np.asarray(self.measure(family), float)
        expected = np.asarray(self.expected, float)
        allowed = np.maximum(TOLERANCE * np.abs(expected), self.slack)
        agrees = bool(np.all(np.abs(found - expected) <= allowed))
        pairs = zip(found, expected, strict=True)
        rule = f"each within {100 * TOLERANCE:g} %"
        if self.slack:
            rule += f", or to {self.slack:g} {self.unit}"
        return Row(
            self.figure,
            self.statement,
            f"{', '.join(f'{value:g}' for value in expected)} {self.unit}".strip(),
            f"{', '.join(_with_deviation(*pair) for pair in pairs)} {self.unit}".strip(),
            agrees,
            rule,
            "" if agrees else self.reason,
        )


@dataclass(frozen=True)
class Claim:
    """A statement of the thesis with a rule of its own.

    Attributes
    ----------
    thesis : what it says.  rule : when the runs agree, in words.
    measure : what comes out as text, and whether that is so.
    reason : why it is not so, where it is not.
    """

    figure: str
    statement: str
    thesis: str
    rule: str
    measure: Judge
    reason: str = ""

    def judged(self, family: Family) -> Row:
        found, agrees = self.measure(family)
        reason = "" if agrees else self.reason
        return Row(self.figure, self.statement, self.thesis, found, bool(agrees), self.rule, reason)


def judged(findings: Sequence[Finding], results: Mapping[str, Family]) -> list[Row]:
    """The rows of those findings whose figures were run."""
    return [
        finding.judged(results[finding.figure]) for finding in findings if finding.figure in results
    ]


def _with_deviation(found: float, expected: float) -> str:
    if not np.isfinite(found):
        return "none"
    if not expected:
        return f"{found:.3g}"
    deviation = round(100 * (found / expected - 1))
    return f"{found:.3g} ({signed(deviation, '+d')} %)"
