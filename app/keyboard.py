"""Keys: what each of them does."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .session import Session

#: keys and what they do, for people
HELP = (
    ("Space", "run, pause, go on"), ("Esc", "stop"), (".", "one time step"),
    ("← →", "one step back or forth; with Shift ten"), ("Home, End", "first step, newest step"),
    ("Ctrl+Z, Ctrl+Shift+Z", "undo, redo"), ("P", "presentation mode"), ("?", "help"),
)  # fmt: skip
_FIRST = 10**9


def actions(session: Session) -> dict[str, Callable[[], None]]:
    """Name of a key -> what it does."""
    player = session.live.player
    return {
        "Space": session.toggle,
        "Escape": session.stop,
        ".": session.step,
        "ArrowLeft": lambda: player.move(-1),
        "ArrowRight": lambda: player.move(1),
        "Shift+ArrowLeft": lambda: player.move(-10),
        "Shift+ArrowRight": lambda: player.move(10),
        "Home": lambda: player.move(-_FIRST),
        "End": lambda: player.move(_FIRST),
        "Undo": session.controls.undo,
        "Redo": session.controls.redo,
        "p": session.present,
        "?": session.dialogs.help,
    }
