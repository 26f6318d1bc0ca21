"""Make the README's pictures: `python tests/browser/screenshots.py` serves the page, shoots it."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

ROOT = Path(__file__).parents[2]
PORT = 5077
DESKTOP = {"width": 1440, "height": 900}
#: file -> colour scheme, preset, sentence to wait for, steps to wait for
SHOTS = {
    "instability.png": ("light", "thesis-instability", "Step ", 335),
    "adhesion.png": ("dark", "adhesion", "Step ", 420),
}


def main() -> None:
    command = [sys.executable, "-m", "panel", "serve", "app", "--port", str(PORT), "--liveness"]
    server = subprocess.Popen(command, cwd=ROOT)
    try:
        _wait_until_alive()
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(
                executable_path=shutil.which("chromium"), args=["--headless", "--no-sandbox"]
            )
            for name, (scheme, preset, sentence, rows) in SHOTS.items():
                tab = browser.new_page(viewport=DESKTOP, color_scheme=scheme)
                _shoot(tab, scheme, preset, sentence, rows)
                tab.screenshot(path=ROOT / "assets" / name)
                tab.close()
            browser.close()
    finally:
        server.terminate()


def _wait_until_alive() -> None:
    for _ in range(100):
        try:
            with urllib.request.urlopen(f"http://localhost:{PORT}/liveness", timeout=1):
                return
        except OSError:
            time.sleep(0.2)
    raise SystemExit("the server did not answer")


def _shoot(tab: Page, scheme: str, preset: str, sentence: str, rows: int) -> None:
    tab.goto(f"http://localhost:{PORT}/app")
    tab.get_by_text("Press Run").wait_for(timeout=60_000)
    if scheme == "dark":
        tab.get_by_role("button", name="Toggle theme").click()
    tab.get_by_role("combobox", name="Preset").click()
    tab.get_by_role("menuitem", name=preset, exact=True).click()
    tab.get_by_role("button", name="Run", exact=True).click()
    tab.get_by_role("status").filter(has_text=sentence).wait_for(timeout=60_000)
    script = "n => Bokeh.documents[0].get_model_by_name('force').data.force.length >= n"
    tab.wait_for_function(script, arg=rows, timeout=120_000)
    time.sleep(0.5)


if __name__ == "__main__":
    main()
