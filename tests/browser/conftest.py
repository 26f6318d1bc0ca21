"""A served page and a real browser. Without Chromium these tests are skipped, and say so."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator

import pytest
from playwright.sync_api import (
    Browser,
    BrowserContext,
    Locator,
    Page,
    TimeoutError,
    expect,
    sync_playwright,
)

from tests.browser.chromium import ARGUMENTS, NAMES
from tests.browser.serving import served_by_command

expect.set_options(timeout=30_000)  # a machine may be busy
#: tab -> words in it, or none where plots are all that it shows
TABS: dict[str, str | re.Pattern[str]] = {
    "Stiffness": "", "Release": "", "Energy": "The drive has put in", "Inputs": "",
    "Compare": re.compile("Pin (a|this) run"), "Lessons": "Why the thesis", "Theory": "rrata",
    "Code": "import tyrecontact as tc",
}  # fmt: skip
#: what Panel and Bokeh write when something of the page has failed behind the visitor's back
_FAILURES = re.compile(r"Error (running|thrown|handling)|Callback failed|RuntimeError|app/\w+\.py")
#: whether a plot is to be seen, through all shadow roots
_PLOTS = """() => {
  const seen = (root) => [...root.querySelectorAll("*")].some((one) =>
    (one.matches(".bk-Figure") && one.offsetHeight > 0) || (one.shadowRoot && seen(one.shadowRoot)))
  return seen(document)
}"""
#: where the state of the run is told
_SENTENCE = ".sentence[role=status]"
_BACKGROUND = "getComputedStyle(document.body).backgroundColor"
_FOCUSED = """() => {
  let node = document.activeElement
  while (node?.shadowRoot?.activeElement) node = node.shadowRoot.activeElement
  if (!node) return ""
  const name = node.getAttribute("aria-label") || node.labels?.[0]?.textContent
  if (name) return name.trim()
  const copy = node.cloneNode(true)  // without its icons
  copy.querySelectorAll("[aria-hidden=true]").forEach((icon) => icon.remove())
  return copy.textContent.trim()
}"""


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """The system's Chromium."""
    path = next(filter(None, map(shutil.which, NAMES)), None)
    if path is None:
        if os.environ.get("TYRECONTACT_REQUIRE_BROWSER"):
            pytest.fail("TYRECONTACT_REQUIRE_BROWSER is set, but there is no Chromium on PATH")
        pytest.skip("no Chromium on PATH: install Debian's package chromium to run this test")
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=path, args=ARGUMENTS)
        yield started
        started.close()


@pytest.fixture(scope="session")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Address of the page, served as the README says."""
    log = tmp_path_factory.mktemp("server") / "log"
    with served_by_command(log) as url:
        yield url
    text = log.read_text()
    assert _FAILURES.search(text) is None, text


class Visit:
    """A tab on the page, and all that it asked for and complained about."""

    def __init__(self, context: BrowserContext, address: str) -> None:
        self.tab: Page = context.new_page()
        self.requests: list[str] = []
        self.complaints: list[str] = []
        self.tab.on("request", lambda request: self.requests.append(request.url))
        self.tab.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.tab.on("console", self._listen)
        self.tab.goto(address)
        self.tab.get_by_role("button", name="Run", exact=True).wait_for(timeout=60_000)
        self.tab.wait_for_function("() => window.Bokeh && Bokeh.documents.length > 0")
        self.tab.get_by_text("Press Run").wait_for(timeout=60_000)

    def _listen(self, message: object) -> None:
        if message.type == "error":  # type: ignore[attr-defined]
            self.complaints.append(message.text)  # type: ignore[attr-defined]

    def button(self, name: str) -> Locator:
        """A button by the beginning of its name: "Stop" is "Stop (Esc)"."""
        return self.tab.get_by_role("button", name=re.compile(f"^{name}( |$)"))

    def press(self, name: str) -> None:
        self.button(name).first.click()

    def choose_preset(self, name: str) -> None:
        self.tab.locator("header").get_by_role("button", name="default", exact=True).click()
        self.tab.get_by_role("button", name=re.compile(f"^{name}\\b")).first.click()
        self.tab.locator("header").get_by_role("button", name=name, exact=True).wait_for()

    def open(self, tab: str) -> None:
        """Open a tab, and wait for what it shows."""
        chosen = self.tab.get_by_role("tab", name=tab, exact=True)
        chosen.click()
        expect(chosen).to_have_attribute("aria-selected", "true")
        if words := TABS[tab]:
            self.tab.locator("main").get_by_text(words).first.wait_for()
        else:
            self.tab.wait_for_function(_PLOTS)

    def focused(self) -> str:
        """Name of what has the focus, through all shadow roots."""
        return self.tab.evaluate(_FOCUSED)

    def leave_focus(self) -> None:
        """Nothing has the focus, as when the page was just opened."""
        self.tab.evaluate("document.activeElement.blur()")

    def tab_to(self, name: str, key: str = "Tab", part: bool = False) -> None:
        """Go on by keyboard until what has that name has the focus."""
        passed = []
        for _ in range(90):
            self.tab.keyboard.press(key)
            passed.append(self.focused())
            if passed[-1] == name or (part and passed[-1].startswith(name)):
                return
        pytest.fail(f"{name!r} is not reached: {passed}")

    def set(self, label: str, value: str) -> None:
        """Write a number into the entry of a setting, or choose."""
        field = self.tab.get_by_label(label, exact=True)
        if field.evaluate("node => node.tagName") == "SELECT":
            field.select_option(value)
        else:
            field.fill(value)
            field.press("Enter")

    def darken(self) -> None:
        """Choose the dark theme, and wait until it is there."""
        before = self.tab.evaluate(_BACKGROUND)
        self.tab.get_by_role("button", name="Toggle theme").click()
        self.tab.wait_for_function(f"was => {_BACKGROUND} !== was", arg=before)

    def choose_pace(self, name: str) -> None:
        self.tab.get_by_role("combobox", name="Pace of a run").click()
        item = self.tab.get_by_role("menuitem", name=name, exact=True)
        item.click()
        try:
            item.wait_for(state="hidden", timeout=5000)
        except TimeoutError:  # the menu was still unfolding, or drawn anew under the pointer
            item.click()
            item.wait_for(state="hidden")
        self.tab.wait_for_function(f"name => ({_FOCUSED})() === name", arg=name)  # it is back

    def sentence(self) -> str:
        return self.tab.locator(_SENTENCE).inner_text()

    def steps_said(self) -> int:
        """Number of the step in the sentence on the state."""
        found = re.search(r"step (\d+)", self.sentence(), re.IGNORECASE)
        assert found, self.sentence()
        return int(found[1])

    def column(self, source: str, name: str) -> list:
        """A column of a Bokeh source as the browser holds it."""
        script = "([s, c]) => Array.from(Bokeh.documents[0].get_model_by_name(s).data[c])"
        return self.tab.evaluate(script, [source, name])

    def map_values(self) -> list[float | None]:
        """The image of the contact map, flat; None where nothing is to be seen."""
        script = """() => {
            const image = Bokeh.documents[0].get_model_by_name('map').data.value[0]
            return image === undefined ? [] : Array.from(image.flat ? image.flat() : image)
        }"""
        return self.tab.evaluate(script)

    def wait_for_rows(self, count: int, seconds: float = 60) -> None:
        script = "n => Bokeh.documents[0].get_model_by_name('force').data.force.length >= n"
        self.tab.wait_for_function(script, arg=count, timeout=seconds * 1000)

    def wait_for_sentence(self, part: str, seconds: float = 60) -> None:
        """Until the sentence on the state holds these words; a failure tells what it said."""
        expect(self.tab.locator(_SENTENCE)).to_contain_text(part, timeout=seconds * 1000)


@pytest.fixture(scope="session")
def desktop(browser: Browser) -> Iterator[BrowserContext]:
    """A browser on a desktop screen that loads the page's scripts once."""
    context = browser.new_context(viewport={"width": 1440, "height": 900})
    yield context
    context.close()


@pytest.fixture
def visit(desktop: BrowserContext, address: str) -> Iterator[Visit]:
    """A visit on a desktop screen; whatever it complains about fails the test."""
    made = Visit(desktop, address)
    yield made
    made.tab.evaluate("localStorage.clear()")
    made.tab.close()
    own = address.rpartition("/")[0]
    foreign = [url for url in made.requests if not url.startswith((own, "data:", "blob:"))]
    assert foreign == []
    assert made.complaints == []
