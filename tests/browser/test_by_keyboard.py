"""The whole way without a mouse: every key is pressed where the focus happens to be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from playwright.sync_api import Locator, expect

from tests.browser.conftest import TABS

if TYPE_CHECKING:
    from tests.browser.conftest import Visit


def _player(visit: Visit) -> Locator:
    """The player: the sentence on the state names a step, too."""
    return visit.tab.get_by_role("group", name="Replay")


def test_a_run_from_the_first_key_to_the_last(visit: Visit) -> None:
    tab = visit.tab
    visit.choose_pace("in about 20 s")
    visit.leave_focus()
    tab.keyboard.press(" ")
    visit.wait_for_rows(5)
    tab.keyboard.press(" ")
    visit.wait_for_sentence("Paused at step")
    rows = visit.steps_said()
    tab.keyboard.press(".")
    visit.wait_for_sentence(f"Paused at step {rows + 1} of")
    player = _player(visit)
    expect(player).to_contain_text(f"step {rows + 1} of")  # counted as in the sentence
    tab.keyboard.press("ArrowLeft")
    expect(player).to_contain_text(f"step {rows} of")
    tab.keyboard.press("Home")
    expect(player).to_contain_text("step 1 of")
    tab.keyboard.press("Shift+ArrowRight")
    expect(player).to_contain_text(f"step {min(11, rows + 1)} of")
    tab.keyboard.press("Escape")
    visit.wait_for_sentence("Stopped at step")


def test_run_preset_and_settings_are_reached_and_used(visit: Visit) -> None:
    tab, key = visit.tab, visit.tab.keyboard
    visit.tab_to("default")
    key.press("Enter")
    tab.get_by_role("dialog").wait_for()
    visit.tab_to("Find a preset")
    key.type("adhesion")
    visit.tab_to("adhesion", part=True)
    key.press("Enter")
    tab.get_by_role("dialog").wait_for(state="hidden")
    tab.locator("header").get_by_role("button", name="adhesion", exact=True).wait_for()
    visit.tab_to("Release criterion [N], slider")
    entry = tab.get_by_label("Release criterion [N]", exact=True)
    before = entry.input_value()
    key.press("ArrowRight")
    expect(entry).not_to_have_value(before)
    key.press("Control+z")  # with the focus on what was changed
    expect(entry).to_have_value(before)
    visit.tab_to("Release criterion [N]")
    key.press("Control+a")
    key.type("0.35")
    key.press("Enter")
    caption = tab.get_by_text("with 1 setting changed")
    expect(caption).to_be_visible()
    visit.tab_to("Loading")
    key.press("Enter")
    visit.tab_to("Rate [mm/s]")
    visit.tab_to("Run", "Shift+Tab")
    key.press("Enter")
    visit.wait_for_rows(5)
    key.press("Escape")
    visit.wait_for_sentence("Stopped at step")


def test_an_element_is_followed_and_every_tab_opened(visit: Visit) -> None:
    tab, key = visit.tab, visit.tab.keyboard
    visit.choose_pace("as fast as it can")
    visit.leave_focus()
    key.press(" ")
    visit.wait_for_sentence("Complete", 90)
    visit.tab_to("Step on show")
    key.press("ArrowLeft")
    expect(_player(visit)).to_contain_text("step 341 of 342")
    visit.tab_to("Choose it by row and column")
    key.press("Enter")
    row = tab.get_by_label("Row", exact=True)
    row.wait_for()
    if not row.evaluate("node => node.matches(':focus')"):
        visit.tab_to("Row")
    key.press("Control+a")
    key.type("7")
    key.press("Enter")
    expect(tab.get_by_text("Element row 7, column 0")).to_be_visible()
    visit.tab_to("Watch", "Shift+Tab")
    for name in TABS:
        key.press("ArrowRight")
        assert visit.focused() == name
        key.press("Enter")
        expect(tab.get_by_role("tab", name=name, exact=True)).to_have_attribute(
            "aria-selected", "true"
        )
    code = tab.locator("pre[tabindex='0']").first
    code.evaluate("node => { node.style.width = '90px' }")  # as in a window that is narrow
    code.focus()
    key.press("ArrowRight")
    key.press("ArrowRight")
    tab.wait_for_function("node => node.scrollLeft > 0", arg=code.element_handle())
