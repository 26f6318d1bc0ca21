"""The chapters as HTML: Markdown by markdown-it, equations as MathML.

Browsers draw MathML themselves, in fonts that they have: no script and no font is fetched.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any

from latex2mathml.converter import convert
from markdown_it import MarkdownIt
from markdown_it.token import Token
from mdit_py_plugins.anchors import anchors_plugin
from mdit_py_plugins.dollarmath import dollarmath_plugin

#: between a number and its unit no line breaks
_UNIT = re.compile(r"(?<=\d) (?=(?:[µkMmG]?(?:m|N|s|Hz|Pa)|kg|J|GB)\b|%)")
_BACK = '<p class="back"><a href="#contents">Back to the chapters</a></p>'


@dataclass(frozen=True)
class Chapter:
    """A chapter: `anchor` by which it is jumped to, `title` and body in `html`."""

    anchor: str
    title: str
    html: str


@cache
def chapters() -> tuple[Chapter, ...]:
    """All chapters, in the order of their files' names."""
    found = sorted(entry.name for entry in files(__package__).iterdir())
    texts = (files(__package__) / name for name in found if name.endswith(".md"))
    return tuple(chapter(text.read_text(encoding="utf-8")) for text in texts)


def chapter(text: str) -> Chapter:
    """A chapter from its Markdown, which begins with its only heading of the second level."""
    parser = _parser()
    tokens = parser.parse(text)
    title, name = tokens[1].content, str(tokens[0].attrGet("id"))
    html = parser.renderer.render(tokens, parser.options, {})
    return Chapter(name, title, _UNIT.sub("\N{NO-BREAK SPACE}", html))


@cache
def page() -> str:
    """The whole text: contents, then the chapters."""
    entries = "".join(
        f'<li><a href="#{part.anchor}">{escape(part.title)}</a></li>' for part in chapters()
    )
    contents = f'<nav id="contents" aria-label="Chapters"><ol>{entries}</ol></nav>'
    sections = "".join(f"<section>{part.html}{_BACK}</section>" for part in chapters())
    return contents + sections


@cache
def _parser() -> MarkdownIt:
    parser = MarkdownIt("commonmark", {"html": False}).enable("table")
    parser.use(dollarmath_plugin, renderer=_mathml, allow_labels=False, allow_space=False)
    parser.use(anchors_plugin, min_level=2, max_level=3)
    # what may be wider than a phone scrolls in itself
    parser.add_render_rule("math_block", _equation)
    parser.add_render_rule("table_open", _table_open)
    parser.add_render_rule("table_close", _table_close)
    return parser


def _mathml(tex: str, how: Mapping[str, Any]) -> str:
    """An equation, display or inline, as an element of MathML."""
    return convert(tex, display="block" if how["display_mode"] else "inline")


def _equation(_self: Any, tokens: Sequence[Token], place: int, *_: Any) -> str:
    """Parts that are far apart may stand on lines of their own."""
    parts = tokens[place].content.strip().split(r"\qquad")
    drawn = "".join(_mathml(part, {"display_mode": True}) for part in parts)
    return f'<div class="equation"><div class="parts" data-scrolls="Equation">{drawn}</div></div>'


def _table_open(_self: Any, _tokens: Sequence[Token], _place: int, *_: Any) -> str:
    return '<div class="table" data-scrolls="Table"><table>'


def _table_close(_self: Any, _tokens: Sequence[Token], _place: int, *_: Any) -> str:
    return "</table></div>"
