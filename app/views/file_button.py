"""A button that makes a file when it is pressed, and keeps nothing of it."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

import panel as pn
import panel_material_ui as pmui


def file_button(
    label: str, make: Callable[[], tuple[str, bytes]], **looks: Any
) -> pmui.FileDownload:
    """The button.

    Parameters
    ----------
    label : on it.
    make : gives name and contents of the file.
    looks : of the button, such as `width`.
    """

    def content() -> io.BytesIO:
        button.filename, contents = make()
        return io.BytesIO(contents)

    def forget() -> None:
        button.data = None

    def sent(event: Any) -> None:
        # the same file again would be no change, and not be saved; and a run can be 50 MB
        if event.new is not None and pn.state.curdoc is not None:
            pn.state.curdoc.add_next_tick_callback(forget)

    button = pmui.FileDownload(
        callback=content, auto=True, filename="file", label=label, size="small", **looks
    )
    button.variant = "outlined"  # given above, it would be called deprecated
    button.param.watch(sent, "data")
    return button
