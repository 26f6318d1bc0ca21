"""The main job in a real browser: run, watch, stop, run again, and a road that is no road."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from playwright.sync_api import Browser, expect

if TYPE_CHECKING:
    from tests.browser.conftest import Visit

_STEPS_OF_DEFAULT = 342
#: whether the map shows an element that is pulled
_PULLED = """() => Array.from(Bokeh.documents[0].get_model_by_name("map").data.value[0])
  .some((value) => value < 0)"""


def test_force_iterations_and_map_move_before_the_run_ends_and_stop_keeps_them(
    visit: Visit,
) -> None:
    visit.press("Run")
    visit.wait_for_rows(5)
    early_map, early = visit.map_values(), len(visit.column("force", "force"))
    visit.wait_for_rows(early + 20)
    assert visit.sentence().startswith("Step ")
    assert len(visit.column("iterations", "iterations")) >= early
    assert len(visit.column("margin", "margin")) >= early
    assert visit.map_values() != early_map
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")
    kept = visit.steps_said()
    assert early + 20 <= kept < _STEPS_OF_DEFAULT
    assert len(visit.column("force", "force")) == kept


def test_a_second_run_with_another_release_criterion_obeys_it(visit: Visit) -> None:
    visit.choose_preset("adhesion")
    visit.choose_pace("as fast as it can")
    visit.press("Run")
    visit.wait_for_sentence("Complete", 90)
    visit.set("Release criterion [N]", "0.2")
    visit.choose_pace("in about 6 s")  # so that the first run's end is not taken for the second's
    visit.press("Run")
    visit.wait_for_sentence("Step ")
    visit.wait_for_sentence("Complete", 90)
    pulled_most = int(np.argmin(visit.column("force", "force")))
    visit.tab.get_by_label("Step on show").evaluate(
        "(node, step) => { node.value = step; node.dispatchEvent(new Event('input')) }", pulled_most
    )
    visit.tab.wait_for_function(_PULLED)
    values = [value for value in visit.map_values() if value is not None]
    # the map's numbers have seven digits
    assert np.nanmin(values) >= -0.2 * (1 + 1e-6)


def test_the_thesis_run_fails_on_the_page_and_the_page_says_why(visit: Visit) -> None:
    visit.choose_preset("thesis-instability")
    visit.choose_pace("in about 20 s")
    visit.press("Run")
    visit.wait_for_sentence("after 10 iterations, residual", 90)
    sentence = visit.sentence()
    assert "the band-limited kernel is unstable on springs this stiff" in sentence
    assert "worst at row " in sentence
    assert "passive kernel" in sentence
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")


def test_pause_step_and_go_on(visit: Visit) -> None:
    visit.choose_pace("in about 20 s")
    visit.press("Step")
    visit.wait_for_sentence("Paused at step 1 of")
    visit.press("Step")
    visit.wait_for_sentence("Paused at step 2 of")
    visit.press("Go on")
    visit.wait_for_rows(8)
    visit.press("Pause")
    visit.wait_for_sentence("Paused at step")
    assert len(visit.column("force", "force")) == visit.steps_said()
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")


def test_a_bad_road_file_is_refused_in_a_sentence_and_the_page_lives_on(
    visit: Visit, tmp_path: Path
) -> None:
    bad = tmp_path / "road.pdf"
    bad.write_bytes(b"no road at all")
    tab = visit.tab
    tab.get_by_role("button", name="Road and springs").click()
    tab.locator("input[type=file]").first.set_input_files(bad)
    tab.get_by_role("alert").filter(has_text="road file must").first.wait_for(timeout=30_000)
    if tab.get_by_role("dialog").count():
        visit.press("Cancel")
        tab.get_by_role("dialog").wait_for(state="hidden")
    visit.press("Run")
    visit.wait_for_rows(5)
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")


def test_a_link_brings_the_scenario_back_and_of_a_bad_one_what_can_be_had(
    visit: Visit, address: str
) -> None:
    visit.choose_preset("adhesion")
    visit.set("Release criterion [N]", "0.35")
    visit.press("Share")
    tab = visit.tab
    tab.goto(tab.get_by_label("Link to this scenario").input_value())
    entry = tab.get_by_label("Release criterion [N]", exact=True)
    expect(entry).to_have_value("0.35")
    preset = tab.locator("header").get_by_role("button", name="adhesion")
    expect(preset).to_be_visible()
    tab.goto(f"{address}?v=1&p=adhesion&nonsense=7")
    expect(tab.get_by_role("alert").filter(has_text="nonsense")).to_be_visible()
    expect(preset).to_be_visible()


def test_a_phone_gets_the_plots_first_and_no_sideways_scrolling(
    browser: Browser, address: str
) -> None:
    context = browser.new_context(
        viewport={"width": 390, "height": 844}, is_mobile=True, has_touch=True,
        user_agent="Mozilla/5.0 (Linux; Android 14) Chrome/140 Mobile Safari/537.36",
    )  # fmt: skip
    tab = context.new_page()
    tab.goto(address)
    run = tab.get_by_role("button", name="Run", exact=True)
    run.click(timeout=60_000)  # fails where the sidebar covers it
    tab.get_by_role("status").filter(has_text="Step ").wait_for(timeout=60_000)
    assert tab.evaluate("document.documentElement.scrollWidth") <= 390
    boxes = [plot.bounding_box() for plot in tab.locator(".bk-Figure").all()]
    shown = sorted((box["y"], box["height"]) for box in boxes if box and box["height"])
    assert len(shown) >= 3
    for (top, height), (below, _) in itertools.pairwise(shown):
        assert top + height <= below + 1  # no plot lies over another
    tab.get_by_role("button").first.click()
    for name in ("Presets", "Share", "Help"):  # the header has no room for them
        expect(tab.get_by_role("button", name=name, exact=True)).to_be_visible()
    context.close()


def test_everything_that_matters_stands_on_a_desktop_screen_without_scrolling(
    visit: Visit,
) -> None:
    visit.tab.locator(".bk-Figure").nth(2).wait_for(timeout=30_000)
    assert max(_bottoms(visit)) <= 900
    visit.darken()
    assert max(_bottoms(visit)) <= 900


def _bottoms(visit: Visit) -> list[float]:
    """Of the four main controls and the three plots."""
    tab = visit.tab
    labels = (
        "Release criterion [N]", "Loading profile", "Time-resolution factor",
        "Spring exchange [springs]",
    )  # fmt: skip
    controls = [tab.get_by_label(label, exact=True) for label in labels]
    plots = [tab.locator(".bk-Figure").nth(i) for i in range(3)]
    boxes = [part.bounding_box() for part in (*controls, *plots)]
    return [box["y"] + box["height"] for box in boxes if box is not None]
