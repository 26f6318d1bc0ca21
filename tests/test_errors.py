"""Errors: one sentence that says what was wrong and what would be right."""

from __future__ import annotations

import pytest

from tyrecontact.errors import InputError, TyreContactError, unknown_name

NAMES = ("passive", "static", "band-limited")


def test_an_input_error_is_caught_as_ours_and_as_a_value_error() -> None:
    with pytest.raises(TyreContactError):
        raise InputError("rate must be positive")
    with pytest.raises(ValueError, match="rate must be positive"):
        raise InputError("rate must be positive")


def test_an_unknown_name_lists_the_right_ones_sorted_and_says_what_was_got() -> None:
    message = str(unknown_name("kernel", "dynamic", NAMES))
    assert message.startswith("kernel must be one of band-limited, passive, static, got 'dynamic'")


@pytest.mark.parametrize(
    ("wrong", "nearest"),
    [("pasive", "passive"), ("statik", "static"), ("band_limited", "band-limited")],
)
def test_the_nearest_name_is_offered(wrong: str, nearest: str) -> None:
    assert str(unknown_name("kernel", wrong, NAMES)).endswith(f"(did you mean {nearest!r}?)")


@pytest.mark.parametrize("wrong", ["", "xyz", "42"])
def test_no_name_is_offered_where_none_is_near(wrong: str) -> None:
    assert "did you mean" not in str(unknown_name("kernel", wrong, NAMES))


@pytest.mark.parametrize("wrong", [None, 3, ["passive"], {"kernel": "static"}])
def test_what_is_no_text_is_named_as_it_is(wrong: object) -> None:
    assert f"got {wrong!r}" in str(unknown_name("kernel", wrong, NAMES))


def test_names_may_come_from_an_iterator() -> None:
    message = str(unknown_name("kernel", "statik", (name for name in NAMES)))
    assert "band-limited, passive, static" in message
    assert "did you mean 'static'" in message


def test_the_message_stays_on_one_line() -> None:
    assert "\n" not in str(unknown_name("kernel", "two\nlines", NAMES))
