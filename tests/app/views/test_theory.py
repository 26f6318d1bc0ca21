"""The theory page is made when it is first shown, and follows the size of type."""

from __future__ import annotations

from app.theory import render
from app.views.style import DESK, HALL
from app.views.theory import TheoryView


def test_the_text_is_there_when_it_is_shown_and_not_before() -> None:
    view = TheoryView()
    assert view.root.text == ""
    view.show(None)
    assert view.root.text == render.page()
    assert view.root.type_size == DESK.title


def test_in_the_hall_it_is_large() -> None:
    view = TheoryView()
    view.show(None, HALL)
    assert view.root.type_size == HALL.title > DESK.title
