"""Lessons on the page: what they run, where they point, what they keep for comparison."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .views.lesson import LessonCard
from .views.style import Size

if TYPE_CHECKING:
    from .session import Session

#: of a lesson's strip: the plots below make room for it
_HEIGHT = "140px"


class Teaching:
    """The lesson of one session.

    Attributes
    ----------
    card : the strip above the plots; its `root` is invisible without a lesson.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._wanted: dict[str, Any] = {}  # the scenario of the step
        self.card = LessonCard(self._apply, self._point, self._pin, self._over)

    def begin(self, name: str) -> None:
        """Start a lesson, at the live plots."""
        self._session.tabs.open("Watch")
        self._session.browser.set_style(taken=_HEIGHT)
        self.card.start(name)

    def enlarge(self, size: Size) -> None:
        self.card.size(size)

    def _apply(self, preset: str | None, settings: dict[str, Any]) -> None:
        """Put into the form what is to be run: one change, however much it takes."""
        with self._session.controls.history.as_one():
            if preset is not None:
                # what a lesson says is true of the made road
                self._session.controls.load(preset, keep_road=False)
            self._session.controls.change_all(settings)
        self._wanted = self._session.controls.scenario.to_dict()
        self._session.live.suit(self._session.controls.scenario.loading.profile)

    def _point(self, place: str) -> None:
        """Show what is spoken of."""
        tabs, title = self._session.tabs, place.capitalize()
        tabs.open(title if title in tabs.titles else "Watch")
        self._session.live.point_at(place)

    def _pin(self, label: str) -> None:
        """Keep the run of this step; another one must not stand under its label."""
        run = self._session.run
        if run is not None and run.scenario.to_dict() == self._wanted:
            self._session.pin(label)

    def _over(self) -> None:
        self._session.live.point_at("")
        self._session.browser.set_style(taken="0px")
