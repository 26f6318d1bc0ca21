"""Make the README's pictures: `python -m tests.browser.screenshots` serves the page, shoots it."""

from __future__ import annotations

import re
import shutil
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import Page, sync_playwright

from tests.browser.chromium import ARGUMENTS, NAMES
from tests.browser.serving import served_by_command

ASSETS = Path(__file__).parents[2] / "assets"
DESKTOP = {"width": 1440, "height": 900}


def main(names: list[str]) -> None:
    chromium = next(filter(None, map(shutil.which, NAMES)))
    with (
        TemporaryDirectory() as folder,
        served_by_command(Path(folder) / "log") as address,
        sync_playwright() as playwright,
    ):
        browser = playwright.chromium.launch(executable_path=chromium, args=ARGUMENTS)
        for name in names or SHOTS:
            dark, prepare = SHOTS[name]
            tab = browser.new_page(viewport=DESKTOP)
            tab.set_default_timeout(120_000)
            tab.goto(address)
            tab.get_by_text("Press Run").wait_for()
            if dark:
                tab.get_by_role("button", name="Toggle theme").click()
            prepare(tab)
            time.sleep(1.5)
            tab.screenshot(path=ASSETS / name)
            tab.close()
        browser.close()


def _choose(tab: Page, preset: str) -> None:
    tab.get_by_role("button", name=re.compile("^(default|quasi|thesis|adhesion)")).first.click()
    tab.get_by_role("button", name=re.compile(f"^{preset}\\b")).first.click()
    tab.locator("header").get_by_role("button", name=preset, exact=True).wait_for()
    time.sleep(1.0)


def _run(tab: Page, until: str = "Complete") -> None:
    tab.get_by_role("button", name="Run", exact=True).click()
    time.sleep(1.0)
    tab.get_by_role("status").filter(has_text=re.compile(until)).wait_for()


def _rows(tab: Page, count: int) -> None:
    script = "n => Bokeh.documents[0].get_model_by_name('force').data.force.length >= n"
    tab.wait_for_function(script, arg=count)


def _pause_at(tab: Page, count: int) -> None:
    """A busy machine would take the picture of a later step."""
    _rows(tab, count)
    tab.get_by_role("button", name=re.compile("^Pause")).click()
    tab.get_by_role("status").filter(has_text="Paused at step").wait_for()
    tab.mouse.move(640, 160)  # a tip would cover what stands beside


def _tap_map(tab: Page, x: float, y: float) -> None:
    box = tab.locator(".bk-Figure").nth(2).bounding_box()
    assert box is not None
    tab.mouse.click(box["x"] + x * box["width"], box["y"] + y * box["height"])


def _instability(tab: Page) -> None:
    _choose(tab, "thesis-instability")
    tab.get_by_role("button", name="Run", exact=True).click()
    _rows(tab, 335)


def _adhesion(tab: Page) -> None:
    _choose(tab, "adhesion")
    tab.get_by_role("button", name="Run", exact=True).click()
    _pause_at(tab, 420)


def _element(tab: Page) -> None:
    _choose(tab, "adhesion")
    tab.get_by_role("button", name="Run", exact=True).click()
    _pause_at(tab, 400)
    _tap_map(tab, 0.55, 0.3)
    time.sleep(2.0)
    tab.mouse.move(700, 600)
    tab.mouse.wheel(0, 2000)


def _compare(tab: Page) -> None:
    tab.get_by_role("combobox", name="Pace of a run").click()
    tab.get_by_role("menuitem", name="as fast as it can").click()
    for preset in ("quasi-static", "thesis-factor-2", "thesis-factor-4"):
        _choose(tab, preset)
        _run(tab)
        tab.get_by_role("button", name=re.compile("^Pin")).first.click()
        time.sleep(1.0)
    tab.get_by_role("tab", name="Compare").click()
    time.sleep(3.0)


def _lesson(tab: Page) -> None:
    tab.get_by_role("tab", name="Lessons").click()
    tab.get_by_role("button", name=re.compile("Why the thesis")).click()
    time.sleep(1.0)
    tab.get_by_role("button", name="It jumps from step to step").click()
    _run(tab)


def _theory(tab: Page) -> None:
    tab.get_by_role("tab", name="Theory").click()
    time.sleep(2.0)
    tab.get_by_role("link", name=re.compile("blows up")).first.click()


#: file -> whether dark, and what is to be seen
SHOTS: dict[str, tuple[bool, Callable[[Page], None]]] = {
    "instability.png": (False, _instability),
    "adhesion.png": (True, _adhesion),
    "element.png": (False, _element),
    "compare.png": (False, _compare),
    "lesson.png": (False, _lesson),
    "theory.png": (True, _theory),
}


if __name__ == "__main__":
    main(sys.argv[1:])
