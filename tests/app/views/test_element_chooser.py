"""An element chosen without a pointer, before a run or in one."""

from __future__ import annotations

from app.runner import Run
from app.views.element import ElementView


def test_an_element_chosen_before_the_first_run_is_followed_in_it(finished: Run) -> None:
    view, followed = ElementView(), []
    view.on_follow = lambda row, column: followed.append((row, column))
    view.open()
    view.chooser.row.value = 2
    view.chooser.column.value = 3
    assert view.sentence.startswith("Element row 2, column 3 is followed in the next run")
    view.prepare(finished)
    view.update(finished, finished.record.count - 1, ended=True)
    assert followed == [(2, 3)]
    assert view.sentence.startswith("Element row 2, column 3: ")


def test_an_element_that_the_run_has_not_is_not_followed(finished: Run) -> None:
    view = ElementView()
    view.open()
    view.chooser.row.value = 40
    view.prepare(finished)
    assert view.element is None
    assert view.chooser.row.value == 5


def test_who_has_no_pointer_is_offered_a_choice(finished: Run) -> None:
    view = ElementView()
    view.prepare(finished)
    view.offer.clicks += 1
    assert view.offer not in list(view.root)
    view.chooser.row.value = 4
    assert view.element == (4, 0)
