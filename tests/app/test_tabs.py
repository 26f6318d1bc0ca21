"""Tabs: made when first opened, shown what is on show, one at a time."""

from __future__ import annotations

from typing import Any

import panel as pn
import pytest

from app.tabs import Tabs
from app.views.style import DESK, HALL


class _View:
    def __init__(self) -> None:
        self.root = pn.Column()
        self.shown: list[Any] = []
        self.closed = False

    def show(self, run: Any, size: Any = DESK) -> None:
        self.shown.append((run, size))

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def made() -> list[_View]:
    return []


@pytest.fixture
def tabs(made: list[_View]) -> Tabs:
    def make() -> _View:
        made.append(_View())
        return made[-1]

    return Tabs(pn.Column(), {"Energy": make, "Theory": make})


def test_a_view_is_made_when_its_tab_is_first_opened(tabs: Tabs, made: list[_View]) -> None:
    assert made == []
    tabs.open("Energy")
    tabs.open("Watch")
    tabs.open("Energy")
    assert len(made) == 1
    assert tabs.title == "Energy"


def test_only_the_open_tab_is_seen_and_shown_the_run(tabs: Tabs, made: list[_View]) -> None:
    tabs.open("Energy")
    tabs.open("Theory")
    assert [place.visible for place in tabs.root[1:]] == [False, False, True]
    run: Any = object()
    tabs.show(run)
    assert made[1].shown[-1] == (run, DESK)
    assert made[0].shown[-1] == (None, DESK)
    tabs.open("Energy")
    assert made[0].shown[-1] == (run, DESK)


def test_the_size_of_type_reaches_tabs_opened_later(tabs: Tabs, made: list[_View]) -> None:
    tabs.enlarge(HALL)
    tabs.open("Theory")
    assert made[0].shown == [(None, HALL)]


def test_closing_ends_what_views_have_under_way(tabs: Tabs, made: list[_View]) -> None:
    tabs.open("Energy")
    tabs.close()
    assert made[0].closed


def test_a_tab_that_is_none_is_passed_over(tabs: Tabs, made: list[_View]) -> None:
    tabs._choice.active = 99
    tabs.show(None)
    assert not made
    tabs.open("Energy")
    assert len(made) == 1
