"""Two tabs at once do not mix, and a run that is superseded never draws over the new one."""

from __future__ import annotations

import numpy as np
from playwright.sync_api import BrowserContext

from tests.browser.conftest import Visit


def test_two_tabs_run_what_each_of_them_says(
    visit: Visit, desktop: BrowserContext, address: str
) -> None:
    first, second = visit, Visit(desktop, address)
    second.choose_preset("quasi-static")
    for each in (first, second):
        each.choose_pace("in about 6 s")
        each.press("Run")
    for each in (first, second):
        each.wait_for_sentence("Complete", 120)
    dynamic, still = (np.array(each.column("force", "force")) for each in (first, second))
    assert len(dynamic) == len(still) == 342
    # the moving tread resists more, everywhere but at the very first touch
    assert (dynamic[50:] > still[50:]).all()
    assert second.complaints == []
    second.tab.close()


def test_in_live_mode_only_the_last_run_is_on_the_screen(visit: Visit) -> None:
    visit.choose_pace("in about 6 s")
    visit.press("Run")
    visit.wait_for_rows(40)
    visit.tab.get_by_role("switch", name="Live").click()
    for rate in ("40", "50", "60", "300"):
        visit.tab.get_by_label("Release criterion [N], slider").press("ArrowRight")
        visit.tab.get_by_role("button", name="Loading", exact=True).wait_for()
        _set_rate(visit, rate)
    visit.wait_for_sentence("Complete", 120)
    time = np.array(visit.column("force", "time_ms"))
    depth = np.array(visit.column("force", "indentation_um"))
    assert (np.diff(time) > 0).all()
    np.testing.assert_allclose(depth, 300.0 * time, atol=2.0)


def _set_rate(visit: Visit, value: str) -> None:
    entry = visit.tab.get_by_label("Rate [mm/s]", exact=True)
    if not entry.count():
        visit.tab.get_by_role("button", name="Loading", exact=True).click()
    entry.fill(value)
    entry.press("Enter")
