"""Frames of a session, called by hand."""

from __future__ import annotations

import time

from app.session import Session


def frame(session: Session) -> None:
    session.browser.shown = session.browser.frame  # a browser that keeps up
    session.frame()


def frames_until_the_end(session: Session) -> None:
    limit = time.monotonic() + 60
    while not session.run.phase.ended:
        frame(session)
        time.sleep(0.01)
        assert time.monotonic() < limit
    frame(session)


def frames_until_step(session: Session, count: int) -> None:
    wait_for_step(session, count)
    frame(session)


def wait_for_step(session: Session, count: int) -> None:
    limit = time.monotonic() + 60
    while session.run.record is None or session.run.record.count < count:
        time.sleep(0.005)
        assert time.monotonic() < limit
