"""Undo and redo: what the form has said before."""

from __future__ import annotations

from app.history import History, Past


def _state(rate: float) -> Past:
    return Past("default", {"loading": {"rate": rate}})


def test_undo_and_redo_go_through_the_states_in_order() -> None:
    history = History(_state(0))
    for number in (1, 2, 3):
        history.add(_state(number), "loading.rate", now=10.0 * number)
    assert [history.undo(), history.undo()] == [_state(2), _state(1)]
    assert history.redo() == _state(2)
    assert history.can_undo
    assert history.can_redo


def test_ends_of_the_history_answer_nothing() -> None:
    history = History(_state(0))
    assert history.undo() is None
    assert history.redo() is None
    history.add(_state(1), "loading.rate", now=0.0)
    history.undo()
    assert history.undo() is None


def test_a_drag_is_one_change() -> None:
    history = History(_state(0))
    for number in range(1, 20):
        history.add(_state(number), "loading.rate", now=0.05 * number)
    assert history.undo() == _state(0)
    assert history.redo() == _state(19)


def test_a_drag_does_not_swallow_what_was_changed_before_it() -> None:
    history = History(_state(0))
    history.add(_state(1), "loading.rate", now=0.0)
    history.add(_state(2), "tread.density", now=0.1)
    assert history.undo() == _state(1)


def test_a_change_after_undo_forgets_what_could_have_been_redone() -> None:
    history = History(_state(0))
    history.add(_state(1), "loading.rate", now=0.0)
    history.undo()
    history.add(_state(5), "loading.rate", now=0.1)
    assert history.redo() is None
    assert history.undo() == _state(0)


def test_the_same_again_is_no_change() -> None:
    history = History(_state(0))
    history.add(_state(0), "loading.rate", now=0.0)
    assert not history.can_undo


def test_presets_that_follow_each_other_fast_are_changes_of_their_own() -> None:
    history = History(_state(0))
    history.add(_state(1), "", now=0.0)
    history.add(_state(2), "", now=0.1)
    assert [history.undo(), history.undo()] == [_state(1), _state(0)]


def test_changes_made_as_one_are_undone_at_once() -> None:
    history = History(_state(0))
    history.add(_state(1), "loading.rate", now=0.0)
    with history.as_one():
        history.add(_state(2), "", now=0.1)
        history.add(_state(3), "loading.rate", now=0.2)
    history.add(_state(4), "loading.rate", now=0.3)
    assert [history.undo(), history.undo(), history.undo()] == [_state(3), _state(1), _state(0)]
