"""The page of one visitor: where things stand."""

from __future__ import annotations

from functools import partial
from typing import Any

import panel as pn
import panel_material_ui as pmui

from .limits import sessions
from .painting import Painting
from .session import Session

_PARTS = {
    "MuiAppBar": {"styleOverrides": {"root": {"backgroundColor": "#0B3F5E", "color": "#fff"}}},
    # the tip of a button stands over its neighbour, which is to be pressed all the same
    "MuiTooltip": {"styleOverrides": {"popper": {"pointerEvents": "none !important"}}},
    # Panel does not send that `busy_indicator` is None: a bar without a name would stay in the page
    "MuiLinearProgress": {"styleOverrides": {"root": {"display": "none"}}},
}
_THEME = {
    "light": {"palette": {"primary": {"main": "#0B5C8A"}}, "components": _PARTS},
    "dark": {"palette": {"primary": {"main": "#6CB8E6"}}, "components": _PARTS},
}
#: below this width [px] the sidebar would cover the page
_PHONE = 600


def build() -> pmui.Page | pn.Column:
    """The page, wired; it starts no thread until Run is pressed. Or, where the server has as many
    visitors as it takes, a word about that.
    """
    pn.config.respect_explicit_sizing = True
    visitor, visitors = object(), sessions()
    if not visitors.enter(visitor):
        return _full(len(visitors))
    pn.state.on_session_destroyed(lambda _: visitors.leave(visitor))
    return lay_out(Session())


def _full(visitors: int) -> pn.Column:
    """A page that says to come back."""
    return pn.Column(
        pmui.Typography("tyrecontact is busy", variant="h5"),
        pmui.Typography(
            f"Visitors at once on this server: {visitors}, and that many are here. "
            "Please reload in a few minutes.", variant="body1",
        ),
        margin=40,
    )  # fmt: skip


def lay_out(session: Session) -> pmui.Page:
    """A session's parts on a page."""
    before, phone = _busy_watchers(), _on_a_phone()
    page = pmui.Page(
        title="",  # a phone has no room for it: the header brings its own
        meta_title="tyrecontact",
        header=session.header.root,
        sidebar=_sidebar(session, phone),
        main=[
            pn.Column(
                session.headline.root, session.teaching.card.root, session.tabs.root,
                session.browser, Painting(), session.dialogs.root,
                session.controls.road_file.dialog,
                sizing_mode="stretch_width", margin=0,
                # as high as its contents: else no higher than the screen, and parts overlap
                styles={"max-height": "none"},
            )
        ],
        sidebar_open=not phone,
        theme_config=_THEME,
        busy_indicator=None,
        sidebar_resizable=False,  # its handle has no name for who cannot see it
    )  # fmt: skip
    page.param.watch(lambda event: session.live.darken(event.new), "dark_theme")
    session.browser.on_width = lambda width: pn.state.onload(
        partial(_make_room, page, session, width)
    )
    session.on_present = partial(_present, page)
    # the page would follow the server's being busy, at a redraw each, and never be freed
    for watcher in _busy_watchers():
        if watcher not in before:
            pn.state.param.unwatch(watcher)
    return page


def _present(page: pmui.Page, large: bool) -> None:
    page.sidebar_open = not large


def _make_room(page: pmui.Page, session: Session, width: int) -> None:
    """In a narrow window the plots first, as on a phone that said so when it asked."""
    session.browser.on_width = lambda _: None  # once: a window that is resized keeps its sidebar
    if width < _PHONE and not _on_a_phone():
        page.param.update(sidebar_open=False, sidebar=_sidebar(session, phone=True))


def _sidebar(session: Session, phone: bool) -> list[Any]:
    """The settings; on a phone after what its header has no room for."""
    extra = [session.header.for_phones()] if phone else []
    return [*extra, *session.whatif.root]


def _busy_watchers() -> list[Any]:
    return list(pn.state.param.watchers.get("busy", {}).get("value", []))


def _on_a_phone() -> bool:
    """Whether the visitor's browser says that it is one."""
    headers = pn.state.headers or {}
    return "Mobi" in headers.get("User-Agent", "")
