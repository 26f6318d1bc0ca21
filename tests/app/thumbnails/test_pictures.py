"""A picture for each preset that is listed, small, drawn in the colours around it."""

from __future__ import annotations

from importlib.resources import files
from xml.etree import ElementTree

import pytest

import app.thumbnails
from app.thumbnails import picture
from tyrecontact import presets


def test_pictures_are_those_of_the_presets_and_small() -> None:
    found = [entry for entry in files(app.thumbnails).iterdir() if entry.name.endswith(".svg")]
    assert {entry.name.removesuffix(".svg") for entry in found} == set(presets.names())
    assert sum(len(entry.read_bytes()) for entry in found) < 300_000


@pytest.mark.parametrize("name", presets.names())
def test_a_picture_says_what_it_shows_and_fetches_nothing(name: str) -> None:
    drawn = ElementTree.fromstring(picture(name))
    assert drawn.get("viewBox") == "0 0 150 90"
    assert drawn.get("aria-label")
    text = picture(name)
    assert "currentColor" in text
    assert text.count("http") == 1  # the namespace
    assert "<script" not in text
    assert "nan" not in text


def test_a_preset_without_a_picture_is_told_by_its_name() -> None:
    with pytest.raises(FileNotFoundError, match="fig-23"):
        picture("fig-23")
