"""The lessons to choose from: what each is about, where in the thesis, and how long."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import param
from panel.custom import JSComponent

from ..lessons import lessons
from ..runner import Run
from .style import DESK, Size

_HERE = Path(__file__).parent


class LessonCards(JSComponent):
    """Plain buttons in a grid; `chosen` is told the name of the one that was pressed."""

    lessons = param.List(default=[])
    type_size = param.Integer(default=DESK.title)
    chosen: Callable[[Any], None] | None = None

    _esm = _HERE / "lesson_list.js"
    _stylesheets: ClassVar = [(_HERE / "lesson_list.css").read_text(encoding="utf-8")]

    def _handle_msg(self, msg: Any) -> None:
        if self.chosen is not None:
            self.chosen(msg)


class LessonList:
    """Tab view. Attributes: `root` the cards; `start` is called with the name of a lesson."""

    def __init__(self, start: Callable[[str], None]) -> None:
        self._start = start
        self.root = LessonCards(
            lessons=[
                {
                    "name": lesson.name,
                    "title": f"{lesson.number}. {lesson.title}",
                    "aim": lesson.aim,
                    "where": lesson.where,
                    "minutes": lesson.minutes,
                }
                for lesson in lessons().values()
            ],
            sizing_mode="stretch_width",
            margin=(6, 8),
        )
        self.root.chosen = self._chosen

    def show(self, _run: Run | None, size: Size = DESK) -> None:
        """Type for a desk or for a hall; no lesson depends on a run."""
        self.root.type_size = size.title

    def _chosen(self, name: Any) -> None:
        if isinstance(name, str) and name in lessons():  # a browser may send anything
            self._start(name)
