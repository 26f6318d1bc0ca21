"""With a screen reader: axe-core finds nothing grave, wherever a visitor may go."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect

from tests.browser.conftest import TABS

if TYPE_CHECKING:
    from tests.browser.conftest import Visit

_GRAVE = ("critical", "serious")
#: what another theme may spoil
_OF_COLOUR = ["color-contrast", "link-in-text-block"]
_GROUPS = ("Loading", "Adhesion", "Road and springs", "Tread", "Numerics")


def _findings(visit: Visit, *without: str, **options: object) -> list[str]:
    """Grave findings, rule and place, but for parts of the frame that were looked at before.

    What fades in, or from one theme to the other, is of little contrast for a moment: only what
    is found again and again counts.
    """
    found: list[str] = []
    for _ in range(4):
        found = _scan(visit, *without, **options)
        if not found:
            break
        visit.tab.wait_for_timeout(700)
    return found


def _scan(visit: Visit, *without: str, **options: object) -> list[str]:
    frame = ".bk-panel-models-esm-ReactComponent"
    # what passes is not told, nor where: thousands of nodes
    options = {"resultTypes": ["violations"], "selectors": False, **options}
    context = {"exclude": [{"fromShadowDom": [frame, part]} for part in without]}
    result = Axe().run(visit.tab, context=context if without else None, options=options)
    found = result.response["violations"]
    return [
        f"{finding['id']}: {node['html'][:300]}"
        for finding in found
        if finding["impact"] in _GRAVE
        for node in finding["nodes"]
    ]


def test_axe_finds_nothing_grave_in_either_theme(visit: Visit) -> None:
    assert _findings(visit) == []
    # what axe would load for it are the style sheets once more, and they are those of the page
    look = partial(_findings, visit, preload=False)
    _look_into_groups(visit, look)
    _run_and_follow(visit)
    _look_around(visit, look)
    visit.tab.get_by_role("tab", name="Watch", exact=True).click()
    visit.darken()
    look = partial(_findings, visit, runOnly=_OF_COLOUR)
    _look_into_groups(visit, look)
    _look_around(visit, look)


def _run_and_follow(visit: Visit) -> None:
    visit.choose_preset("adhesion")
    visit.choose_pace("as fast as it can")
    visit.press("Run")
    visit.wait_for_sentence("Complete", 90)
    visit.press("Choose it by row and column")
    visit.tab.get_by_role("button", name="Hardest pressed").click()
    expect(visit.tab.get_by_text("Element row ")).to_be_visible(timeout=20_000)
    visit.press("Pin")


def _look_around(visit: Visit, look: Callable[..., list[str]]) -> None:
    """At what is watched, the other tabs, which all show something, and the dialogs."""
    assert look("nav") == []
    for name in TABS:
        visit.open(name)
        assert look("nav", "header") == [], name
    _look_into_dialogs(visit, look)


def _look_into_groups(visit: Visit, look: Callable[..., list[str]]) -> None:
    for name in _GROUPS:
        group = visit.tab.get_by_role("button", name=name, exact=True)
        group.click()
        expect(group).to_have_attribute("aria-expanded", "true")
        visit.tab.locator(".MuiAccordion-root.Mui-expanded input").first.wait_for()
        assert look("main", "header") == [], name
    group.click()
    expect(group).to_have_attribute("aria-expanded", "false")


def _look_into_dialogs(visit: Visit, look: Callable[..., list[str]]) -> None:
    for name in ("Share", "Help", "adhesion"):
        visit.press(name)
        dialog = visit.tab.get_by_role("dialog")
        dialog.get_by_role("heading").first.wait_for()
        assert look("main", "nav", "header") == [], name
        visit.tab.keyboard.press("Escape")
        dialog.wait_for(state="hidden")
