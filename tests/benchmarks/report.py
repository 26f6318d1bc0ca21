"""From what the benchmarks measured to tables: the lines they are judged by, and all the rest."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

from tests.benchmarks.cases import KERNELS, MANY_LAGS, SIZES

BEGIN, END = "<!-- benchmarks: begin -->", "<!-- benchmarks: end -->"


@dataclass(frozen=True)
class Measured:
    """All that pytest-benchmark has written; what was not measured is NaN."""

    machine: dict[str, Any]
    date: str
    rows: list[dict[str, Any]]

    @classmethod
    def read(cls, written: dict[str, Any]) -> Measured:
        rows = [
            {"test": row["name"], "fastest": row["stats"]["min"], **row["extra_info"]}
            for row in written["benchmarks"]
        ]
        return cls(written["machine_info"], written["datetime"][:10], rows)

    def of(self, case: str, field: str = "seconds", **which: object) -> Any:
        """A field of the row of that case."""
        which["case"] = case
        for row in self.rows:
            if all(row.get(name) == value for name, value in which.items()) and field in row:
                return row[field]
        return math.nan

    def step(self, elements: int, kernel: str, field: str = "seconds") -> float:
        return self.of("step", field, elements=elements, kernel=kernel)

    def direct(self, elements: int, kernel: str) -> float:
        """Seconds of a direct step; measured at 20 x 20, and at least M^2 times as much beyond."""
        return self.of("direct", kernel=kernel) * (elements / 20) ** 4


@dataclass(frozen=True)
class Line:
    """What is asked, what was measured, and whether that will do."""

    what: str
    value: float
    asked: str
    holds: Callable[[float], bool]
    digits: str = ".3g"

    def row(self) -> tuple[str, str, str, str]:
        if math.isnan(self.value):
            return self.what, "not measured", self.asked, ""
        verdict = "yes" if self.holds(self.value) else "**no**"
        return self.what, format(self.value, self.digits), self.asked, verdict


def judged(found: Measured) -> list[Line]:
    """The lines that speed is judged by."""
    step, differences = found.step(20, "passive"), [
        found.of("direct", "difference", kernel=kernel) for kernel in (*KERNELS, "static")
    ]  # fmt: skip
    return [
        Line("20 x 20, passive, 256 lags: times as fast as the direct method",
             found.direct(20, "passive") / step, "150", lambda x: x >= 150, ".0f"),
        Line("20 x 20, passive, 256 lags: steps/s", 1 / step, "1500", lambda x: x >= 1500, ".0f"),
        Line("`default` in 1024 steps, kernel cached, in a new process (its import aside), s",
             found.of("default"), "< 1", lambda x: x < 1),
        Line("the same again in that process, which knows the road, s",
             found.of("default", "fastest"), "< 1", lambda x: x < 1),
        Line("64 x 64: a dynamic step in solves by Tamaas", _in_solves(found, 64), "<= 1.5",
             lambda x: x <= 1.5),
        Line("256 x 256: a dynamic step in solves by Tamaas", _in_solves(found, 256), "<= 1",
             lambda x: x <= 1),
        Line("a step against M log M, from 64 x 64 on: exponent", exponent_of_size(found),
             "<= 1", lambda x: round(x, 2) <= 1, ".2f"),
        Line("a step against the logarithm of the lags: exponent", exponent_of_lags(found),
             "<= 1", lambda x: round(x, 2) <= 1, ".2f"),
        Line("default kernel, cold, s", found.of("kernel"), "< 1.5", lambda x: x < 1.5),
        Line("springs from 2000 x 2000 heights, new process, s", found.of("springs"), "< 0.5",
             lambda x: x < 0.5),
        Line("forces against the direct method, 40 steps of each kernel: largest difference",
             float(np.max(differences)), "1e-9", lambda x: x <= 1e-9, ".1e"),
    ]  # fmt: skip


def exponent_of_size(found: Measured) -> float:
    """p of cost ~ (M log M)^p, from 64 x 64 on: below, what a call costs hides the growth."""
    count = np.array([n**2 for n in SIZES if n >= 64], float)
    cost = [found.step(n, "passive") for n in SIZES if n >= 64]
    return slope(count * np.log(count), cost)


def exponent_of_lags(found: Measured) -> float:
    """p of cost ~ (log lags)^p at 20 x 20."""
    cost = [found.of("lags", lags=lags) for lags in MANY_LAGS]
    return slope(np.log(MANY_LAGS), cost)


def slope(x: np.ndarray, y: Sequence[float]) -> float:
    """Exponent of a power law fitted to those that were measured; NaN for fewer than three."""
    x, cost = np.asarray(x, float), np.asarray(y, float)
    known = np.isfinite(cost)
    if known.sum() < 3:
        return math.nan
    return float(np.polyfit(np.log(x[known]), np.log(cost[known]), 1)[0])


def _in_solves(found: Measured, elements: int) -> float:
    return found.step(elements, "passive") / found.of("tamaas", elements=elements)


def text(found: Measured) -> str:
    """All tables, in markdown."""
    lines = [
        _setting(found),
        table(["judged by", "measured", "asked", ""], [line.row() for line in judged(found)]),
        "A step in the middle of a run, with a full memory: mean over the 256 steps of a window (a "
        "window takes 256 times as long), or over those that fit into 100 s. In brackets: times as "
        "fast as the direct method (measured at 20 x 20; its cost grows at least as M^2). The "
        "band-limited kernel has 65 lags, interpolated to 257 at factor 4, and the thesis' Newton; "
        "it is stable only at a smaller depth on fine lattices. The patch is 20 mm wide: smaller "
        "elements need more iterations. Numbers with numba, but for the second row.",
        table(
            ["elements", "contacts", *KERNELS, "static", "Tamaas, one solve", "peak memory"],
            [
                _size_row(found, 20),
                ["20 x 20 without numba", "", *_plain(found), "", ""],
                *(_size_row(found, n) for n in SIZES[1:]),
            ],
        ),
        table(
            ["lags, at 20 x 20", *map(str, MANY_LAGS)],
            [["a step", *(_time(found.of("lags", lags=lags)) for lags in MANY_LAGS)]],
        ),
        table(["run or part", "time", "steps/s", "times the direct method"], _runs(found)),
    ]
    return "\n\n".join(lines)


def _setting(found: Measured) -> str:
    tamaas = found.of("tamaas", "version")
    versions = [f"Python {found.machine['python_version']}"]
    versions += [f"{name} {_version(name)}" for name in ("numpy", "scipy", "numba", "tyrecontact")]
    versions += [f"Tamaas {tamaas}"] if isinstance(tamaas, str) else []
    processor = found.machine.get("cpu", {}).get("brand_raw", found.machine["machine"])
    return f"{processor}, one thread; {', '.join(versions)}; {found.date}."


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "?"


def _size_row(found: Measured, elements: int) -> list[str]:
    least = "" if elements == 20 else "> "
    times = [
        _time_and_ratio(found.step(elements, kernel), found.direct(elements, kernel), least)
        for kernel in (*KERNELS, "static")
    ]
    share, peak = found.step(elements, "passive", "share"), found.of(
        "memory", "peak", what=f"window-{elements}"
    )  # fmt: skip
    return [
        f"{elements} x {elements}",
        _or_dash(share * 100, "{:.0f} %"),
        *times,
        _time(found.of("tamaas", elements=elements)),
        _or_dash(peak / 1e6, "{:.0f} MB"),
    ]


def _plain(found: Measured) -> list[str]:
    """Steps without numba."""
    return [
        _time_and_ratio(found.of("plain", kernel=kernel), found.direct(20, kernel))
        for kernel in (*KERNELS, "static")
    ]


def _time_and_ratio(seconds: float, direct: float, least: str = "") -> str:
    ratio = direct / seconds
    return _time(seconds) + ("" if math.isnan(ratio) else f" ({least}{float(f'{ratio:.2g}'):g})")


def _runs(found: Measured) -> list[list[str]]:
    loop, steps = found.of("default", "loop"), found.of("default", "steps")
    rows = [
        (
            "the steps of `default`, 1025",
            loop,
            steps / loop,
            found.direct(20, "passive") * steps / loop,
        ),
    ]
    kernels = (
        ("adhesion", "passive"),
        ("thesis-factor-4", "band-limited"),
        ("quasi-static", "static"),
    )
    for name, kernel in kernels:
        seconds, count = found.of("run", preset=name), found.of("run", "steps", preset=name)
        rate, direct = count / seconds, found.direct(20, kernel) * count / seconds
        rows.append((f"`{name}`, {_or_dash(count, '{:.0f}')} steps", seconds, rate, direct))
    rows += [
        ("default kernel", found.of("kernel", "fastest")),
        ("springs from 2000 x 2000 heights", found.of("springs", "fastest")),
        ("`import tyrecontact`", found.of("default", "import")),
    ]
    forms = ("{:.0f}", "about {:.0f}")
    return [
        [name, _time(seconds), *(_or_dash(x, form) for x, form in zip(more, forms, strict=False))]
        + [""] * (2 - len(more))
        for name, seconds, *more in rows
    ]


def _time(seconds: float) -> str:
    unit, factor = ("s", 1.0) if seconds >= 1 else ("ms", 1e3)
    return _or_dash(seconds * factor, f"{{:.3g}} {unit}")


def _or_dash(value: float, form: str) -> str:
    return "–" if math.isnan(value) else form.format(value)


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table in markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def placed(document: str, tables: str) -> str:
    """A document with the tables between its two markers."""
    before, begin, rest = document.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not (begin and end):
        raise ValueError(f"the document must hold the lines {BEGIN} and {END}, got neither or one")
    return f"{before}{begin}\n{tables}\n{end}{after}"
