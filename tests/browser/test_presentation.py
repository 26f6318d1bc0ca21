"""In the lecture hall: large type, and all that is watched on one screen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from playwright.sync_api import Locator, expect

if TYPE_CHECKING:
    from tests.browser.conftest import Visit

#: name of the button that turns presentation mode on and off
_PRESENT = "Presentation mode"
_HEIGHT_OF_TYPE = "node => parseFloat(getComputedStyle(node).fontSize)"


def _bottom(locator: Locator) -> float:
    box = locator.bounding_box()
    assert box is not None
    return box["y"] + box["height"]


def _watched(visit: Visit) -> list[Locator]:
    """Sentence, the three plots, the player."""
    plots = visit.tab.locator(".bk-Figure")
    player = visit.tab.get_by_role("group", name="Replay")
    return [visit.tab.locator(".sentence[role=status]"), *(plots.nth(i) for i in range(3)), player]


def test_all_that_is_watched_stands_on_the_screen_in_large_type(visit: Visit) -> None:
    sentence = visit.tab.locator(".sentence[role=status]")
    form = visit.tab.get_by_label("Release criterion [N]", exact=True)
    before = sentence.evaluate(_HEIGHT_OF_TYPE)
    visit.choose_preset("thesis-instability")
    visit.press(_PRESENT)
    expect(form).to_be_hidden()
    visit.press("Run")
    visit.wait_for_sentence("after 10 iterations, residual", 120)
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")
    assert sentence.evaluate(_HEIGHT_OF_TYPE) >= 1.3 * before
    for width, height in ((1440, 900), (1920, 1080)):
        visit.tab.set_viewport_size({"width": width, "height": height})
        visit.tab.wait_for_timeout(700)  # heights follow the window, and the sentence, which grew
        for part in _watched(visit):
            expect(part).to_be_visible()
        assert max(map(_bottom, _watched(visit))) <= height
        assert visit.tab.evaluate("document.documentElement.scrollWidth") <= width
    visit.press(_PRESENT)
    expect(form).to_be_visible()
    assert sentence.evaluate(_HEIGHT_OF_TYPE) == before
