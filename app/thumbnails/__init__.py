"""Small pictures of what the presets show, made from our own runs by `python -m app.thumbnails`."""

from __future__ import annotations

from functools import cache
from importlib.resources import files


@cache
def picture(name: str) -> str:
    """SVG of a preset, drawn in the colour of the text around it.

    Raises
    ------
    FileNotFoundError : no picture was made of that preset.
    """
    return (files(__package__) / f"{name}.svg").read_text(encoding="utf-8")
