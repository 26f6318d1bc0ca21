"""Copying, files and pictures are the browser's work: here it does it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import panel as pn
import panel_material_ui as pmui
import pytest
from playwright.sync_api import Browser, Download, Page

from app.runner import Run
from app.views.code import CodeView
from app.views.downloads import Downloads
from app.views.force import ForceView
from tests.browser.serving import served
from tyrecontact import Scenario

_SMALL = Scenario(
    road={"elements": 6, "size": 6e-3, "pixel": 5e-5},
    loading={"max_indentation": 100e-6, "rate": 0.1},
    numerics={"lags": 32},
)
_PNG = b"\x89PNG"


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """A dark page with a plot, the downloads and the code."""
    run = Run(_SMALL)
    run.start()
    assert run.join(120)

    def build() -> pmui.Page:
        force, files, code = ForceView(), Downloads(), CodeView()
        files.show("fig-44/14-N", run)
        code.show_scenario("default", _SMALL)
        plot = pn.pane.Bokeh(force.root, sizing_mode="stretch_width")
        return pmui.Page(main=[plot, files.root, code.root], dark_theme=True)

    with served(build) as address:
        yield address


@pytest.fixture(scope="module")
def page(browser: Browser, address: str) -> Iterator[Page]:
    context = browser.new_context(permissions=["clipboard-read", "clipboard-write"])
    opened = context.new_page()
    opened.goto(address)
    opened.get_by_role("button", name="Download the scenario file").wait_for(timeout=60_000)
    yield opened
    context.close()


def pressed(page: Page, button: str) -> Download:
    with page.expect_download(timeout=30_000) as saved:
        page.get_by_role("button", name=button).click()
    return saved.value


def test_code_is_copied_as_it_is_shown(page: Page) -> None:
    page.get_by_role("button", name="Copy: Command line").click()
    page.get_by_role("button", name="Copied").wait_for()
    copied = page.evaluate("navigator.clipboard.readText()")
    assert copied.startswith("tyrecontact run default \\\n  --set road.size=0.006 \\\n")
    page.get_by_role("button", name="Copy: Command line").wait_for()


def test_a_file_can_be_saved_twice(page: Page, tmp_path: Path) -> None:
    for number in range(2):
        saved = pressed(page, "TOML: its scenario")
        saved.save_as(tmp_path / f"{number}.toml")
        assert saved.suggested_filename.startswith("tyrecontact-fig-44-14-N-2")
    assert (tmp_path / "0.toml").read_bytes() == (tmp_path / "1.toml").read_bytes()


def test_a_plot_is_saved_on_its_own_ground(page: Page, tmp_path: Path) -> None:
    saved = pressed(page, "Plots as PNG")
    saved.save_as(tmp_path / "plot.png")
    assert "contact-force" in saved.suggested_filename
    assert (tmp_path / "plot.png").read_bytes().startswith(_PNG)
    pressed(page, "Plots as SVG").save_as(tmp_path / "plot.svg")
    drawn = ElementTree.parse(tmp_path / "plot.svg").getroot()
    ground = drawn[0]
    assert ground.tag.endswith("}rect")
    assert ground.get("fill") not in {None, "rgb(255, 255, 255)"}
    assert "Contact force" in {text.text for text in drawn.iter("{http://www.w3.org/2000/svg}text")}
