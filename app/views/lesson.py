"""A lesson above the plots: text, question, choices, what comes out, and the way on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, ClassVar

import param
from panel.custom import JSComponent

from ..lessons import PLACES, Lesson, Step, get
from .style import DESK, Size

#: places that are on the page while a run goes on, and may be pointed at before it
_LIVE = ("force", "iterations", "map")
_HERE = Path(__file__).parent


class LessonStrip(JSComponent):
    """One component for all of it: `state` is what is drawn, `pressed` is told what was."""

    state = param.Dict(default={})
    pressed: Callable[[dict[str, Any]], None] | None = None

    _esm = _HERE / "lesson.js"
    _stylesheets: ClassVar = [(_HERE / "lesson.css").read_text(encoding="utf-8")]

    def _handle_msg(self, msg: Any) -> None:
        if isinstance(msg, dict) and self.pressed is not None:
            self.pressed(msg)


class LessonCard:
    """The lesson that is on, if any.

    Parameters
    ----------
    apply : called with a preset and settings (path -> value, SI) where a step chooses them.
    point : called with a place of `lessons.PLACES` that is to be shown.
    pin : called with a label when the run on show is to be kept for comparison.
    leave : called when the lesson is over.

    Attributes
    ----------
    root : the strip, invisible without a lesson.
    lesson, index, chosen : what is on show; None, 0 and -1 without.
    """

    def __init__(
        self,
        apply: Callable[[str | None, dict[str, Any]], None],
        point: Callable[[str], None],
        pin: Callable[[str], None],
        leave: Callable[[], None],
    ) -> None:
        self._apply, self._point, self._pin, self._leave = apply, point, pin, leave
        self.lesson: Lesson | None = None
        self.index, self.chosen = 0, -1
        self._applied: tuple[str, Mapping[str, Any]] | None = None
        self._size = DESK
        self.root = LessonStrip(visible=False, sizing_mode="stretch_width", margin=(4, 8))
        self.root.pressed = self._pressed

    @property
    def step(self) -> Step | None:
        """The step on show."""
        return self.lesson.steps[self.index] if self.lesson else None

    def start(self, name: str) -> None:
        """Begin a lesson, from whatever there was. InputError : no lesson has that name."""
        self.lesson, self._applied = get(name), None
        self._go(0)

    def leave(self) -> None:
        """End the lesson; what it set stays."""
        if self.lesson is None:
            return
        self.lesson, self.index, self.chosen = None, 0, -1
        self._draw()
        self._leave()

    def size(self, size: Size) -> None:
        """Type for a desk or for a hall."""
        self._size = size
        self._draw()

    def _pressed(self, message: dict[str, Any]) -> None:
        step = self.step
        if self.lesson is None or step is None:  # a late click
            return
        what, index = message.get("do"), message.get("index")
        if what == "choose" and isinstance(index, int) and 0 <= index < len(step.choices):
            self.chosen = index
            self._draw()
        elif what == "show":
            self._point(step.look)
        elif what == "back" and self.index > 0:
            self._go(self.index - 1)
        elif what == "next":
            self._next(self.lesson, step)
        elif what == "leave":
            self.leave()

    def _next(self, lesson: Lesson, step: Step) -> None:
        if step.pin:
            self._pin(step.pin)
        if self.index + 1 < len(lesson.steps):
            self._go(self.index + 1)
        else:
            self.leave()

    def _go(self, index: int) -> None:
        """Show a step, and choose its scenario where that is another than the last one chosen."""
        assert self.lesson is not None
        self.index, self.chosen = index, -1
        self._draw()
        wanted = self.lesson.scenario(index)
        if wanted != self._applied:
            self._applied = wanted
            self._apply(wanted[0], dict(wanted[1]))
        look = self.lesson.steps[index].look
        if look in _LIVE:
            self._point(look)

    def _draw(self) -> None:
        lesson, step = self.lesson, self.step
        if lesson is None or step is None:
            self.root.param.update(state={}, visible=False)
            return
        answer = step.choices[self.chosen] if self.chosen >= 0 else None
        state = {
            "title": f"{lesson.number}. {lesson.title}",
            "step": self.index + 1,
            "steps": len(lesson.steps),
            "text": step.text,
            "question": step.question,
            "choices": [choice.label for choice in step.choices],
            "chosen": self.chosen,
            "feedback": answer.feedback if answer else "",
            "right": answer.right if answer else False,
            "seen": step.seen,
            "look": PLACES[step.look],
            "size": self._size.title,
        }
        self.root.param.update(state=state, visible=True)
