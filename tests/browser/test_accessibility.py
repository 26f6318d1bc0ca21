"""Without a mouse, and with a screen reader: axe-core's findings, and the whole way by keyboard."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect

if TYPE_CHECKING:
    from tests.browser.conftest import Visit

_GRAVE = ("critical", "serious")


def _findings(visit: Visit) -> list[str]:
    """Grave findings: rule and place."""
    found = Axe().run(visit.tab).response["violations"]
    return [
        f"{finding['id']}: {node['target']} {node['html'][:160]}"
        for finding in found
        if finding["impact"] in _GRAVE
        for node in finding["nodes"]
    ]


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_nothing_grave_at_rest_and_after_a_run(visit: Visit, theme: str) -> None:
    if theme == "dark":
        visit.tab.get_by_role("button", name="Toggle theme").click()
    assert _findings(visit) == []
    visit.choose_pace("as fast as it can")
    visit.press("Run")
    visit.wait_for_sentence("Complete", 90)
    assert _findings(visit) == []


def test_axe_finds_nothing_grave_in_tabs_and_dialogs(visit: Visit) -> None:
    visit.choose_pace("as fast as it can")
    visit.press("Run")
    visit.wait_for_sentence("Complete", 90)
    for name in (
        "Stiffness", "Release", "Energy", "Inputs", "Compare", "Lessons", "Theory", "Code",
    ):  # fmt: skip
        visit.open(name)
        visit.tab.wait_for_timeout(1500)
        assert _findings(visit) == [], name
    for name in ("Share", "Help", "default"):
        visit.press(name)
        visit.tab.get_by_role("dialog").wait_for()
        visit.tab.wait_for_timeout(800)
        assert _findings(visit) == [], name
        visit.tab.keyboard.press("Escape")
        visit.tab.get_by_role("dialog").wait_for(state="hidden")
    for name in ("Loading", "Adhesion", "Road and springs", "Tread", "Numerics"):
        visit.tab.get_by_role("button", name=name, exact=True).click()
        visit.tab.wait_for_timeout(800)
        assert _findings(visit) == [], name


def test_a_run_from_the_first_key_to_the_last(visit: Visit) -> None:
    tab = visit.tab
    visit.choose_pace("in about 20 s")
    tab.locator("body").click(position={"x": 720, "y": 160})
    tab.keyboard.press(" ")
    visit.wait_for_rows(5)
    tab.keyboard.press(" ")
    visit.wait_for_sentence("Paused at step")
    rows = len(visit.column("force", "force"))
    tab.keyboard.press(".")
    visit.wait_for_rows(rows + 1)
    tab.keyboard.press("ArrowLeft")
    tab.keyboard.press("ArrowLeft")
    expect(tab.get_by_text(f"step {rows - 2} of")).to_be_visible()
    tab.keyboard.press("Escape")
    visit.wait_for_sentence("Stopped at step")


def test_every_control_is_reached_by_tabulator_and_moved_by_keys(visit: Visit) -> None:
    tab = visit.tab
    tab.get_by_label("Release criterion [N], slider").focus()
    tab.keyboard.press("ArrowRight")
    expect(tab.get_by_label("Release criterion [N]", exact=True)).to_have_value("0.65")
    tab.keyboard.press("Tab")
    assert _focused(visit) == "Release criterion [N]"
    reached = []
    for _ in range(14):
        tab.keyboard.press("Tab")
        reached.append(_focused(visit))
    for name in ("Loading profile", "Time-resolution factor", "Spring exchange [springs]"):
        assert name in reached, reached


def _focused(visit: Visit) -> str:
    """Name of what has the focus, through all shadow roots."""
    return visit.tab.evaluate("""() => {
      let node = document.activeElement
      while (node?.shadowRoot?.activeElement) node = node.shadowRoot.activeElement
      if (!node) return ""
      return node.getAttribute("aria-label") || node.labels?.[0]?.textContent || node.textContent
    }""")
