"""The main job in a real browser: run, watch, stop, run again, and a road that is no road."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.browser.conftest import Visit

_STEPS_OF_DEFAULT = 342


def test_force_iterations_and_map_move_before_the_run_ends_and_stop_keeps_them(
    visit: Visit,
) -> None:
    visit.press("Run")
    visit.wait_for_rows(5)
    early_map, early = visit.map_forces(), len(visit.column("force", "force"))
    visit.wait_for_rows(early + 20)
    assert visit.sentence().startswith("Step ")
    assert len(visit.column("iterations", "iterations")) >= early + 20
    assert visit.map_forces() != early_map
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")
    kept = visit.column("force", "force")
    assert early + 20 <= len(kept) < _STEPS_OF_DEFAULT
    time.sleep(0.5)
    assert visit.column("force", "force") == kept


def test_a_second_run_with_another_release_criterion_obeys_it(visit: Visit) -> None:
    visit.choose_preset("adhesion")
    visit.press("Run")
    visit.wait_for_rows(40)
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")
    criterion = visit.tab.get_by_role("slider", name="Release criterion [N]")
    for _ in range(8):  # from 0.6 N in steps of 0.05 N
        criterion.press("ArrowLeft")
    visit.press("Run")
    # some bond comes close to the new limit, and none beyond it
    script = """() => Array.from(
        Bokeh.documents[0].get_model_by_name('tension').data.force).some(f => f > 0.15)"""
    visit.tab.wait_for_function(script, timeout=90_000)
    assert max(visit.column("tension", "force")) <= 0.2 * (1 + 1e-9)
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")


def test_the_thesis_run_fails_on_the_page_and_the_page_says_why(visit: Visit) -> None:
    visit.choose_preset("thesis-instability")
    visit.press("Run")
    visit.wait_for_sentence("after 10 iterations, residual", 90)
    sentence = visit.sentence()
    assert "the band-limited kernel is unstable on stiff springs" in sentence
    assert sentence.startswith("Step ")
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")


def test_a_bad_road_file_is_refused_in_a_sentence_and_the_page_lives_on(
    visit: Visit, tmp_path: Path
) -> None:
    bad = tmp_path / "bad.npy"
    bad.write_bytes(b"no road at all")
    tab = visit.tab
    tab.get_by_role("button", name="Road and springs").click()
    pitch = tab.get_by_label("Pitch of the file [µm]")
    pitch.fill("25")
    pitch.press("Enter")
    tab.get_by_role("combobox", name="Unit of its heights").click()
    tab.get_by_role("menuitem", name="mm", exact=True).click()
    tab.locator("input[type=file]").set_input_files(bad)
    visit.wait_for_sentence("Not accepted: road file must hold a matrix of numbers, got bad.npy")
    visit.press("Run")
    visit.wait_for_rows(5)
    visit.press("Stop")
    visit.wait_for_sentence("Stopped at step")


def test_a_phone_gets_the_plots_first_and_no_sideways_scrolling(
    browser: object, address: str
) -> None:
    context = browser.new_context(  # type: ignore[attr-defined]
        viewport={"width": 390, "height": 844}, is_mobile=True, has_touch=True,
        user_agent="Mozilla/5.0 (Linux; Android 14) Chrome/140 Mobile Safari/537.36",
    )  # fmt: skip
    tab = context.new_page()
    tab.goto(address)
    run = tab.get_by_role("button", name="Run", exact=True)
    run.click(timeout=60_000)  # fails where the sidebar covers it
    tab.get_by_role("status").filter(has_text="Step ").wait_for(timeout=60_000)
    assert tab.evaluate("document.documentElement.scrollWidth") <= 390
    context.close()


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_everything_that_matters_stands_on_a_desktop_screen_without_scrolling(
    visit: Visit, theme: str
) -> None:
    tab = visit.tab
    if theme == "dark":
        before = _background(visit)
        tab.get_by_role("button", name="Toggle theme").click()
        tab.wait_for_function(
            "was => getComputedStyle(document.body).backgroundColor !== was", arg=before
        )
    for label in ("Loading profile", "Time-resolution factor"):
        assert _bottom(tab.get_by_role("combobox", name=label)) < 900
    for label in ("Release criterion [N]", "Spring exchange [springs]"):
        assert _bottom(tab.get_by_text(label).first) < 900
    plots = tab.locator(".bk-Figure")
    plots.nth(2).wait_for(timeout=30_000)
    assert plots.count() == 3
    assert all(_bottom(plots.nth(i)) <= 900 for i in range(3))


def _background(visit: Visit) -> str:
    return visit.tab.evaluate("getComputedStyle(document.body).backgroundColor")


def _bottom(locator: object) -> float:
    box = locator.bounding_box()  # type: ignore[attr-defined]
    return box["y"] + box["height"]
