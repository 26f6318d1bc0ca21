"""A file is made at each press, under a name of its own."""

from __future__ import annotations

from base64 import b64decode

from app.views.file_button import file_button


def test_a_file_is_made_at_each_press_and_not_before() -> None:
    made: list[str] = []

    def make() -> tuple[str, bytes]:
        made.append(f"{len(made)}.csv")
        return made[-1], b"1,2"

    button = file_button("Numbers", make, width=120)
    assert (made, button.label, button.width) == ([], "Numbers", 120)
    for number in range(2):
        button.param.trigger("_clicks")
        assert button.filename == f"{number}.csv"
        assert b64decode(button.data.partition(",")[2]) == b"1,2"
