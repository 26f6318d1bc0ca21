"""The theory page: every equation is drawn, every erratum is told, nothing is fetched."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from importlib.resources import files
from xml.etree import ElementTree

import pytest

from app.theory import render

#: elements of MathML Core, which all browsers draw
KNOWN = {
    "math", "mrow", "mi", "mn", "mo", "mtext", "mspace", "mstyle", "mfrac", "msqrt", "msub", "msup",
    "msubsup", "munder", "mover", "munderover", "mtable", "mtr", "mtd",
}  # fmt: skip
#: of physics.md, section 9, in its order: where in the thesis, and a word of what is right
ERRATA = [
    ("Eq. 8, first line", "must Eq. 8"),
    ("Eq. 8, second line", "columns"),
    ("Eq. 5", "present"),
    ("Eq. 7", "entry"),
    ("Eq. 1", "scalar"),
    ("Eq. 2", "thickness"),
    ("25 milliseconds", "5 ms"),
    ("Eq. 3.4", "Eq. 3"),
    ("Fig. 40", "Fig. 41"),
    ("kernel at rest", "time step as a factor"),
    ("changes the statics", "15.0"),
    ("error limit", "residual"),
    ("two rubbers", "10 MPa"),
    ("inertia is negligible", "damping"),
    ("JKR", "fixed"),
    ("not a failure of Newton's method", "passive kernel"),
    ("a rubber that cannot be", "0.354"),
    ("the release force is not", "0.42 N"),
]


class Reader(HTMLParser):
    """Levels of headings, texts, links and what would be fetched."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.levels: list[int] = []
        self.links: list[str] = []
        self.anchors: list[str] = []
        self.fetched: list[str] = []
        self.text = ""
        self.feed(html)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        of = dict(attributes)
        if re.fullmatch(r"h\d", tag):
            self.levels.append(int(tag[1]))
        if of.get("id"):
            self.anchors.append(str(of["id"]))
        if tag == "a":
            self.links.append(str(of["href"]))
        self.fetched += [str(of[name]) for name in ("src", "srcset", "data") if of.get(name)]
        assert tag not in {"script", "style", "link", "img", "iframe", "object"}

    def handle_data(self, data: str) -> None:
        self.text += data


def _page() -> Reader:
    return Reader(render.page())


def _sources() -> Iterator[tuple[str, str]]:
    for entry in files(render.__package__).iterdir():
        if entry.name.endswith(".md"):
            yield entry.name, entry.read_text(encoding="utf-8")


def test_every_equation_becomes_mathml_and_no_tex_is_left() -> None:
    written = 0
    for _, source in _sources():
        display = re.findall(r"\$\$(.+?)\$\$", source, re.DOTALL)
        rest = re.sub(r"\$\$.+?\$\$", "", source, flags=re.DOTALL)
        written += sum(1 + tex.count(r"\qquad") for tex in display)
        written += len(re.findall(r"\$[^$]+\$", rest))
    assert render.page().count("<math ") == written > 150
    assert not re.search(r"[\\$]", _page().text)


def test_what_is_drawn_is_mathml_that_browsers_know() -> None:
    for found in re.findall(r"<math .*?</math>", render.page(), re.DOTALL):
        for element in ElementTree.fromstring(found).iter():
            assert element.tag.partition("}")[2] in KNOWN
            assert "space" not in element.get("width", "")  # lengths with names are not drawn


def test_the_contents_lead_to_every_chapter_and_headings_nest() -> None:
    page = _page()
    jumps = [link.removeprefix("#") for link in page.links if link.startswith("#")]
    assert jumps[: len(render.chapters())] == [part.anchor for part in render.chapters()]
    assert set(jumps) <= set(page.anchors)
    assert len(page.anchors) == len(set(page.anchors))
    assert page.levels[0] == 2
    assert page.levels.count(2) == len(render.chapters()) == 10
    assert set(page.levels) == {2, 3}
    for part in render.chapters():
        assert Reader(part.html).levels[0] == 2


def test_nothing_is_fetched_and_links_go_to_articles() -> None:
    page = _page()
    assert not page.fetched
    elsewhere = [link for link in page.links if not link.startswith("#")]
    assert elsewhere
    assert all(link.startswith("https://doi.org/10.") for link in elsewhere)


@pytest.mark.parametrize(("where", "right"), ERRATA, ids=[where for where, _ in ERRATA])
def test_every_erratum_is_told(where: str, right: str) -> None:
    errata = next(part for part in render.chapters() if "errata" in part.anchor)
    entries = [Reader(part).text for part in errata.html.split("<h3")[1:]]
    (entry,) = (text for text in entries if where in text.partition("\n")[0])
    assert right in " ".join(entry.partition("\n")[2].split())


def test_a_number_and_its_unit_stay_on_one_line() -> None:
    assert "20\N{NO-BREAK SPACE}mm" in render.page()
    assert not re.search(r"\d (mm|ms|MPa|kHz|%)", render.page())
