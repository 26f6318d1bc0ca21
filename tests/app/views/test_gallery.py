"""The gallery: a card for each preset, and choosing calls back, the same preset twice included."""

from __future__ import annotations

from app.views.gallery import Gallery, groups
from tyrecontact import presets


def _opened() -> tuple[Gallery, list[str]]:
    heard: list[str] = []
    gallery = Gallery(heard.append)
    gallery.show("default")
    return gallery, heard


def test_every_listed_preset_has_a_card_with_picture_and_caption() -> None:
    start, thesis = groups()
    assert (start["title"], thesis["title"]) == ("Start here", "Thesis figures")
    assert [card["name"] for card in start["presets"]] == list(presets.PRESETS)
    cards = start["presets"] + thesis["presets"]
    assert [card["name"] for card in cards] == presets.names()
    for card in cards:
        assert card["picture"].startswith("<svg")
        assert card["caption"] == presets.caption(card["name"])
        for member in card["members"]:
            assert presets.get(member["name"])
    assert all("chapter" in card["source"] for card in thesis["presets"])


def test_members_of_a_figure_are_offered() -> None:
    (preloads,) = (card for card in groups()[1]["presets"] if card["name"] == "fig-44")
    assert preloads["source"] == "Fig. 44, chapter 5.3"
    assert [member["name"] for member in preloads["members"]] == presets.members("fig-44")
    assert [member["label"] for member in preloads["members"]] == ["14 N", "62 N", "150 N"]


def test_nothing_is_loaded_before_it_opens() -> None:
    gallery = Gallery(lambda name: None)
    assert gallery.root.groups == []
    gallery.show("adhesion")
    assert gallery.root.groups
    assert gallery.root.current == "adhesion"


def test_choosing_calls_back_and_the_same_can_be_chosen_again() -> None:
    gallery, heard = _opened()
    for name in ("fig-44/14-N", "fig-44/14-N", "default"):
        gallery.root.value = name  # as the browser does
        assert gallery.root.current == name
        assert gallery.root.value == ""
    assert heard == ["fig-44/14-N", "fig-44/14-N", "default"]
