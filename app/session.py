"""What one visitor sees and does: the form, the run on show, the views, and the only clock."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from itertools import cycle
from typing import Any

import panel as pn

from tyrecontact.errors import InputError

from . import keyboard, links
from .answering import pressing, weakly
from .browser import Browser
from .controls import Controls
from .dialogs import Dialogs
from .header import Header
from .limits import limits, slots
from .live import Live, Turn
from .phase import Phase
from .runner import Run
from .shelf import Shelf
from .tabs import Tabs, makers
from .teaching import Teaching
from .views.headline import HeadlineView
from .views.style import DESK, HALL
from .whatif import WhatIf

#: milliseconds between two looks at what the solver has left
FRAME = 60
#: frames from one to the next drawing of a tab at rest while a run goes on
_TAB_PERIOD = 30
#: least time from one run to the next where every change is run [s]
_LIVE_PAUSE = 0.15


class Session:
    """One visitor.

    Attributes
    ----------
    run : the run on show, or None before the first.
    controls, whatif, header, headline, live, tabs, shelf, browser : the parts.
    """

    def __init__(self) -> None:
        self._document = pn.state.curdoc  # None where there is no browser, as in tests
        self.run: Run | None = None
        self._ran = "default"  # the preset that it began as
        self._clock: Any = None
        self._ticks, self._waiting, self._live_due = 0, False, 0.0
        self._turns, self._told = cycle(Turn), Phase.WAITING
        self._large = False
        self.on_present: Callable[[bool], None] = lambda _: None
        self.browser, self.shelf = Browser(), Shelf()
        self.headline, self.header = HeadlineView(), Header()
        self.controls = Controls(self.headline.refuse, self._changed)
        self.whatif = WhatIf(self.controls, self._paced)
        self.live = Live(self.shelf, self._redraw)
        self.teaching = Teaching(self)
        self.tabs = Tabs(self.live.root, makers(self.controls, self.shelf, self.teaching.begin))
        self.dialogs = Dialogs(
            self.controls, self.browser, self.load_preset, lambda: (self._ran, self.run)
        )
        self._wire()
        self._open_link()
        pn.state.on_session_destroyed(lambda _: self.close())

    def start(self, paused: bool = False, live: bool = False) -> None:
        """Run the scenario of the form; it supersedes a run that is under way."""
        before, self._ran = self.run, self.controls.preset
        self.run = Run(
            self.controls.scenario, self.whatif.duration, after=before, paused=paused,
            baseline_first=not live, limits=limits(), slots=slots(),
        )  # fmt: skip
        self.live.begin(self.run, keep_scale=live)
        self.run.start()
        self.headline.accept()
        self.headline.update(self.run)
        self.header.update(self.run)
        self._start_clock()

    def toggle(self) -> None:
        """Run, pause, go on: whichever comes next."""
        if self.run is None or self.run.phase.ended:
            self.start()
        else:
            self.pause()

    def pause(self) -> None:
        """Pause the run, or let it go on."""
        if self.run is not None and not self.run.phase.ended:
            (self.run.resume if self.run.paused else self.run.pause)()

    def step(self) -> None:
        """One time step: of the run that is paused, or of a new one."""
        if self.run is None or self.run.phase.ended:
            self.start(paused=True)
        assert self.run is not None
        self.run.step()

    def stop(self) -> None:
        """End the run before its next step; what was computed stays."""
        if self.run is not None:
            self.run.stop()

    def run_live(self) -> None:
        """Run after a change: at once, but not more often than can be seen."""
        wait = self._live_due - time.monotonic()
        if self._document is None or (wait <= 0 and not self._waiting):
            self._run_now()
        elif not self._waiting:
            self._waiting = True
            self._document.add_timeout_callback(
                weakly(self._run_now), round(1e3 * max(wait, 0.0)) + 1
            )

    def load_preset(self, name: str) -> None:
        """Put a preset into the form."""
        self.controls.load(name)
        self.live.suit(self.controls.scenario.loading.profile)

    def close(self) -> None:
        """The visitor has left, and the document with all its callbacks is gone already."""
        self._clock = self._document = None
        self.stop()
        self.run = None
        self.tabs.close()
        self.controls.close()

    def frame(self) -> None:
        """Show what the solver has left since the last frame, if the browser keeps up."""
        run = self.run
        if run is None or not self.browser.is_ready:
            return
        try:
            with pn.io.unlocked():
                self._show(run)
                self.browser.send_frame()
        except Exception:
            self._stop_clock()
            self.stop()
            self.headline.refuse("this run could not be drawn to its end")
            raise

    def _show(self, run: Run) -> None:
        self._ticks += 1
        ended = run.phase.ended  # read before the rows: then no row comes after it
        if self.live.player.playing:
            self.live.player.tick(FRAME / 1e3)
        phase = run.phase
        # all of it where the visitor, or the run, has done something
        turn = None if ended or run.paused or phase is not self._told else next(self._turns)
        self.live.draw(run, ended, turn)
        if turn in (Turn.WORDS, None):
            self.headline.update(run)
            self.header.update(run)
            self.dialogs.refresh()
        self._told = phase
        if ended or self._ticks % _TAB_PERIOD == 0:
            self.tabs.show(run)
        if ended and not self.live.player.playing:
            self._stop_clock()

    def _run_now(self) -> None:
        self._waiting, self._live_due = False, time.monotonic() + _LIVE_PAUSE
        self.start(live=True)

    def _open_link(self) -> None:
        """Put into the form what the address asks for; what it asks for in vain is said."""
        location = pn.state.location
        search = "" if location is None else location.search
        if not search:
            return
        link = links.parse(search)
        self.controls.load(link.preset, link.scenario)
        self.live.suit(self.controls.scenario.loading.profile)
        if link.problems:
            self.headline.refuse("; ".join(link.problems))

    def _changed(self, paths: Iterable[str]) -> None:
        """The form says something else."""
        self.headline.accept()
        self.whatif.update()
        self.header.preset.label = self.controls.preset
        self.tabs.show(self.run)
        if self.whatif.live.value:
            self.run_live()

    def _redraw(self) -> None:
        """Another step is to be shown; while a run goes on, or is replayed, the clock does it."""
        if self.run is None:
            return
        if self.live.player.playing:
            self._start_clock()
        if self._clock is None:
            self.live.draw(self.run, True)

    def _start_clock(self) -> None:
        # Bokeh's own: Panel's counts every tick as the page being busy, and tells the page
        if self._clock is None and self._document is not None:
            self._clock = self._document.add_periodic_callback(weakly(self.frame), FRAME)

    def _stop_clock(self) -> None:
        if self._clock is not None and self._document is not None:
            self._document.remove_periodic_callback(self._clock)
            self._clock = None

    def present(self) -> None:
        """Presentation mode: large type, and nothing beside the plots; or back."""
        self._large = not self._large
        size = HALL if self._large else DESK
        self.browser.set_style(scale=f"{size.tick / DESK.tick:.2f}")
        self.live.enlarge(size)
        self.tabs.enlarge(size)
        self.teaching.enlarge(size)
        self.on_present(self._large)

    def pin(self, label: str | None = None) -> None:
        """Keep the run on show for comparison."""
        if self.run is None:
            return
        try:
            self.shelf.pin(self.run, label)
        except InputError as error:
            self.headline.refuse(str(error))

    def _paced(self, duration: float) -> None:
        if self.run is not None:
            self.run.duration = duration

    def _pressed(self, key: str) -> None:
        action = keyboard.actions(self).get(key)
        if action is not None:
            pn.state.onload(action)

    def _wire(self) -> None:
        for button, action in (
            (self.header.run, self.start), (self.header.pause, self.pause),
            (self.header.step, self.step), (self.header.stop, self.stop),
            (self.header.preset, self.dialogs.presets), (self.header.share, self.dialogs.share),
            (self.header.present, self.present), (self.header.help, self.dialogs.help),
            (self.live.pin, self.pin),
        ):  # fmt: skip
            button.on_click(pressing(action))
        self.browser.on_key = self._pressed
        self.header.preset.label = self.controls.preset
