"""The page in a real browser, measured: `python -m tests.benchmarks.page`.

What a first visitor waits for, frames that reach the screen, what a page costs the solver, how
soon a click is answered, how soon a changed control draws its first frame. Prints a table; every
ratio is against the same in the same process without a page. Needs Debian's `chromium`.
"""

from __future__ import annotations

import shutil
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import panel as pn
import panel_material_ui as pmui
from playwright.sync_api import Browser, Locator, Page, sync_playwright

from app.page import lay_out
from app.runner import Phase, Run
from app.session import Session
from tests.browser.chromium import ARGUMENTS, NAMES
from tests.browser.serving import served, served_by_command
from tyrecontact import Scenario, presets

#: of `default` in Live mode; a run long enough to be measured is pressed in ten times as slowly
_SLOWLY = 0.003
_REPEATS = 9
_sessions: list[Session] = []

_COUNT_FRAMES = """() => {
  window.__frames = []
  document.addEventListener("tyrecontact-frame", () => window.__frames.push(performance.now()))
}"""

_MOVES = "() => Bokeh.documents[0].get_model_by_name('force').data.force.length > 2"


def main() -> int:
    sys.setswitchinterval(0.001)  # as app/main.py does
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=next(filter(None, map(shutil.which, NAMES))), args=ARGUMENTS
        )
        rows = _first_visit(browser)
        _solve_alone()  # loads and compiles
        with served(_build) as address:
            tab = browser.new_page(viewport={"width": 1440, "height": 900})
            tab.goto(address)
            tab.get_by_text("Press Run").wait_for(timeout=60_000)
            rows += [*_stream(tab), *_clicks(tab), *_live(tab)]
            browser.close()
    print("| on the page | measured | asked |\n| --- | --- | --- |")
    for what, value, asked in rows:
        print(f"| {what} | {value} | {asked} |")
    return 0


def _scenario() -> Scenario:
    scenario = presets.get("default")
    scenario.set("loading.rate", _SLOWLY)
    return scenario


def _solve_alone() -> float:
    """Seconds from the first step of a run to its last, without a page."""
    run = Run(_scenario())
    run.start()
    return _solving(run)


def _solving(run: Run) -> float:
    """Looks seldom: each look takes the interpreter from the solver."""
    while run.record is None or run.record.count == 0:
        time.sleep(0.01)
    began = time.perf_counter()
    while run.record.count < len(run.simulation):  # type: ignore[arg-type]
        time.sleep(0.02)
    return time.perf_counter() - began


def _build() -> pmui.Page:
    """The page, in this process, so that its runs can be timed."""
    pn.config.respect_explicit_sizing = True
    _sessions.append(Session())
    return lay_out(_sessions[-1])


def _first_visit(browser: Browser) -> list[tuple[str, str, str]]:
    """The first of all visits to a server that has just begun, and the first run."""
    with TemporaryDirectory() as folder, served_by_command(Path(folder) / "log") as address:
        tab = browser.new_page(viewport={"width": 1440, "height": 900})
        began = time.perf_counter()
        tab.goto(address)
        tab.get_by_text("Press Run").wait_for(timeout=60_000)
        seen = time.perf_counter() - began
        tab.get_by_role("button", name="Run", exact=True).click()
        tab.wait_for_function(_MOVES)
        moving = time.perf_counter() - began
        tab.close()
    return [
        ("first visit to a new server: the page with its word to visitors", f"{seen:.1f} s",
         "<= 10 s"),
        ("and until, after one click, the curve grows", f"{moving:.1f} s", ""),
    ]  # fmt: skip


def _do(action: Callable[[], None]) -> None:
    """Something on the session's own thread, as a visitor's click would be."""
    document = _sessions[-1]._document
    assert document is not None
    document.add_next_tick_callback(action)


def _stream(tab: Page) -> list[tuple[str, str, str]]:
    session = _sessions[-1]
    tab.evaluate(_COUNT_FRAMES)
    _do(lambda: session.controls.change("loading.rate", _SLOWLY))
    _do(lambda: session.whatif.pace.param.update(value="as fast as it can"))
    rates, seconds, alone = [], [], []
    for _ in range(_REPEATS):
        alone.append(_solve_alone())  # each time anew: the machine may be busier than a while ago
        before = session.run
        tab.evaluate("() => { window.__frames.length = 0 }")
        tab.get_by_role("button", name="Run", exact=True).click()
        while session.run is before or session.run is None:
            time.sleep(0.001)
        seconds.append(_solving(session.run))
        frames = tab.evaluate("() => window.__frames")
        rates.append((len(frames) - 1) / (frames[-1] - frames[0]) * 1e3)
        time.sleep(1.5)
    steps = len(session.run.simulation)  # type: ignore[union-attr, arg-type]
    slower = 100 * (statistics.median(s / a for s, a in zip(seconds, alone, strict=True)) - 1)
    return [
        (f"frames on the screen a second, `default` at 3 mm/s, {steps} steps, as fast as it can",
         f"{statistics.median(rates):.0f}", ">= 15"),
        ("its solver slower than without a page, median of 9 pairs",
         f"{slower:.0f} % ({statistics.median(alone):.2f} s alone)", "< 30 %"),
    ]  # fmt: skip


def _clicks(tab: Page) -> list[tuple[str, str, str]]:
    """From a click during a run to what it changes on the screen."""
    session = _sessions[-1]
    _do(lambda: session.whatif.pace.param.update(value="in about 20 s"))
    time.sleep(0.5)
    tab.get_by_role("button", name="Run", exact=True).click()
    tab.get_by_role("status").filter(has_text="Step ").wait_for()
    time.sleep(1.0)
    took, late = [], []
    for _ in range(11):
        took.append(_answer(tab.get_by_role("button", name="Pause"), tab, "Paused at"))
        took.append(_answer(tab.get_by_role("button", name="Go on"), tab, "Step "))
    assert session.run is not None
    for _ in range(5):
        while session.run.phase is not Phase.RUNNING:
            time.sleep(0.005)
        time.sleep(0.5)
        count = session.run.record.count  # type: ignore[union-attr]
        session.run.stop()
        session.run.join()
        late.append(session.run.record.count - count)  # type: ignore[union-attr]
        time.sleep(0.5)
        tab.get_by_role("button", name="Run", exact=True).click()
        time.sleep(1.0)
    return [
        ("a click on Pause or Go on during a run answered on the screen, median of 22",
         f"{1e3 * statistics.median(took):.0f} ms", "<= 150 ms"),
        ("steps after Stop, most of 5", str(max(late)), "<= 1"),
    ]  # fmt: skip


def _answer(button: Locator, tab: Page, sentence: str) -> float:
    button.wait_for()
    script = """([start]) => new Promise((done) => {
      const words = (root) => {
        for (const node of root.querySelectorAll("*")) {
          if (node.getAttribute("role") === "status") return node
          if (node.shadowRoot) { const found = words(node.shadowRoot); if (found) return found }
        }
        return null
      }
      const status = words(document), began = performance.now()
      window.__answer = new Promise((answered) => {
        const look = () => status.innerText.includes(start)
          ? answered((performance.now() - window.__clicked) / 1e3) : setTimeout(look, 2)
        document.addEventListener("click", () => { window.__clicked = performance.now(); look() },
                                  {once: true, capture: true})
      })
      done(true)
    })"""
    tab.evaluate(script, [sentence])
    button.click()
    return tab.evaluate("() => window.__answer")


def _live(tab: Page) -> list[tuple[str, str, str]]:
    """From a moved slider to the first frame of the run it starts."""
    session = _sessions[-1]
    _do(lambda: session.controls.load("default"))
    tab.get_by_role("switch", name="Live").click()
    time.sleep(1.0)
    slider = tab.get_by_label("Release criterion [N], slider")
    took = []
    for _ in range(12):
        before = session.run
        tab.evaluate("""() => {
          document.addEventListener("keydown", () => { window.__clicked = performance.now() },
                                    {once: true, capture: true})
        }""")
        slider.press("ArrowRight")
        while session.run is before or session.run.record is None or not session.run.record.count:  # type: ignore[union-attr]
            time.sleep(0.001)
        frame = session.browser.frame
        while session.browser.shown <= frame:
            time.sleep(0.001)
        took.append(tab.evaluate("() => window.__frames.at(-1) - window.__clicked") / 1e3)
        time.sleep(0.8)
    return [
        ("Live: from a moved slider to the first frame of its run, median of 12",
         f"{1e3 * statistics.median(took):.0f} ms", "<= 300 ms"),
    ]  # fmt: skip


if __name__ == "__main__":
    sys.exit(main())
