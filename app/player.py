"""Scrub and replay: which step of a run is on show, during and after it. It knows no clock."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import param

from .plain_words import three_digits
from .told import Told

#: a run is replayed in so many seconds at speed 1
DURATION = 8.0
SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0)
_STYLE = """
.bar { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 8px;
  font-size: calc(14px * var(--scale, 1)); }
input { flex: 1 1 120px; min-width: 80px; height: calc(32px * var(--scale, 1));
  margin: 0; accent-color: #3A8FC2; }
button, select { height: calc(32px * var(--scale, 1)); min-width: 40px; padding: 0 8px;
  font: inherit; color: inherit;
  background: color-mix(in srgb, currentColor 6%, transparent); border-radius: 6px;
  border: 1px solid color-mix(in srgb, currentColor 35%, transparent); cursor: pointer; }
option { color: black; background: white; }
button[aria-pressed="true"] { background: color-mix(in srgb, currentColor 20%, transparent);
  font-weight: 600; }
:disabled { opacity: 0.5; cursor: default; }
:focus-visible { outline: 2px solid #3A8FC2; outline-offset: 2px; }
.label { flex: 0 1 auto; min-width: calc(252px * var(--scale, 1));
  font-variant-numeric: tabular-nums; }
"""


class PlayerBar(Told):
    """What the browser shows, in one piece: each would be a message of its own.

    `state` has count, step (-1 where the newest is followed), playing, speed and label.
    """

    state = param.Dict(
        default={"count": 0, "step": -1, "playing": False, "speed": 1.0, "label": ""}
    )

    _esm = Path(__file__).parent / "player.js"
    _stylesheets = [_STYLE]  # noqa: RUF012

    def __init__(self, asked: Callable[[Any], None], **params: Any) -> None:
        self._asked = asked
        super().__init__(**params)

    def _handle_msg(self, msg: Any) -> None:
        self._asked(msg)


class Player:
    """Which step is on show.

    Attributes
    ----------
    root : one row to look at.
    step : on show, or None for the newest.
    playing : the run is being replayed; then the page's clock calls `tick`.
    on_change : is called when another step is to be shown, or playing begins or ends.
    """

    def __init__(self) -> None:
        self.on_change: Callable[[], None] = lambda: None
        self.root = PlayerBar(self._obey, sizing_mode="stretch_width", margin=(4, 10))
        self.reset()

    @property
    def step(self) -> int | None:
        return None if self._place is None else int(self._place)

    @property
    def playing(self) -> bool:
        return bool(self.root.state["playing"])

    @property
    def speed(self) -> float:
        return float(self.root.state["speed"])

    def reset(self) -> None:
        """Follow a run that has not begun."""
        self._count = self._total = 0
        self._columns: Mapping[str, np.ndarray] | None = None
        self._place: float | None = None
        self._tell(playing=False)

    def update(
        self, count: int, total: int, columns: Mapping[str, np.ndarray] | None = None
    ) -> None:
        """So many steps of so many are there; `columns` of the record tell time and indentation."""
        self._count, self._total, self._columns = count, total, columns
        if self._place is not None and self._place >= count:
            self._place = None  # another run, a shorter one
        self._tell()

    def scrub(self, step: int) -> None:
        """Show a step and stay there; the newest is followed."""
        self._go(step, playing=False)

    def move(self, by: int) -> None:
        """Show the step so many further on, or back."""
        if self._count:
            self.scrub((self._newest if self.step is None else self.step) + by)

    def follow(self) -> None:
        """Show the newest step, and go on with it."""
        self._go(self._count, playing=False)

    def play(self) -> None:
        """Replay from the step on show, from the first one where that is the newest; or pause."""
        if self._count < 2:
            return
        start = 0.0 if self._place is None else self._place
        self._go(start, playing=not self.playing)

    def hasten(self, speed: float) -> None:
        """Replay at a speed, of `SPEEDS`; others are not taken."""
        if speed in SPEEDS:
            self._tell(speed=speed)

    def tick(self, seconds: float) -> None:
        """Go on by so much of wall-clock time [s] where a run is being replayed."""
        if not self.playing:
            return
        before, place = self.step, self._place or 0.0
        place += seconds * self.speed * max(self._total, self._count) / DURATION
        if place >= self._newest:
            self.follow()  # there it ends, or goes on live
            return
        self._place = place
        if self.step != before:
            self._tell()
            self.on_change()

    @property
    def _newest(self) -> int:
        return self._count - 1

    def _go(self, place: float, playing: bool) -> None:
        self._place = None if place >= self._newest else max(place, 0.0)
        self._tell(playing=playing)
        self.on_change()

    def _tell(self, **state: Any) -> None:
        """What the browser shows, in one message; none where nothing has changed."""
        step = -1 if self.step is None else self.step
        now = {"count": self._count, "step": step, "label": self._label()}
        told = {**self.root.state, **now, **state}
        self.root.tell(told)

    def _label(self) -> str:
        if not self._count:
            return "no step yet"
        step = self._newest if self.step is None else self.step
        text = f"step {step + 1} of {self._total}"  # as everywhere on the page, from 1
        if self._columns is not None:
            time, depth = (float(self._columns[name][step]) for name in ("time", "indentation"))
            text += f", {three_digits(time * 1e3)} ms, {three_digits(depth * 1e6)} µm"
        return text

    def _obey(self, asked: Any) -> None:
        """Do what the visitor asks for; a message that makes no sense is passed over."""
        match asked:
            case {"do": "scrub", "step": int(step)}:
                self.scrub(step)
            case {"do": "move", "by": int(by)}:
                self.move(by)
            case {"do": "play"}:
                self.play()
            case {"do": "newest"}:
                self.follow()
            case {"do": "speed", "speed": float(speed) | int(speed)}:
                self.hasten(speed)
