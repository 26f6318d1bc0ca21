"""The code on show is that of the scenario, and nothing of it is taken for HTML."""

from __future__ import annotations

import panel as pn
import pytest

from app import code
from app.views.code import CodeView
from app.views.style import HALL
from tyrecontact import Scenario, presets


@pytest.fixture
def view() -> CodeView:
    return CodeView()


def panes(view: CodeView) -> list[str]:
    return [pane.object for pane in view.root.select(pn.pane.HTML)]


def test_nothing_is_made_before_it_is_shown(view: CodeView) -> None:
    assert len(view.root) == 0


def test_the_three_blocks_are_those_of_the_scenario(view: CodeView, small: Scenario) -> None:
    view.show_scenario("default", small)
    assert view.texts == {
        "Python": code.python("default", small),
        "Command line": code.command_line("default", small),
        "Scenario file": code.toml("default", small),
    }
    shown = panes(view)
    assert len(shown) == 3
    assert "--set loading.rate=0.1" in shown[1]
    assert all('<pre tabindex="0" role="region" aria-label=' in text for text in shown)


def test_each_block_can_be_copied(view: CodeView, small: Scenario) -> None:
    view.show_scenario("default", small)
    buttons = {str(label) for label in (b.label for b in view.root.select() if hasattr(b, "label"))}
    assert buttons == {
        "Copy: Python", "Copy: Command line", "Copy: Scenario file", "Download the scenario file",
    }  # fmt: skip


def test_another_scenario_takes_the_place_in_the_same_blocks(
    view: CodeView, small: Scenario
) -> None:
    view.show_scenario("default", small)
    before = list(view.root)
    view.show_scenario("adhesion", presets.get("adhesion"), HALL)
    assert list(view.root) == before
    assert 'preset = "adhesion"' in view.texts["Scenario file"]
    assert all(f"--label: {HALL.label}px" in text for text in panes(view))


def test_names_of_files_are_escaped_and_their_folders_not_told(view: CodeView) -> None:
    scenario = Scenario(road={"file": "/tmp/secret/<b>A12<b> & co.npy"})
    view.show_scenario("default", scenario)
    shown = "".join(panes(view))
    assert "secret" not in shown
    assert "<b>" not in shown
    assert "&lt;b&gt;A12&lt;b&gt; &amp; co.npy" in shown


def test_the_file_is_the_last_block(view: CodeView, small: Scenario) -> None:
    view.show_scenario("fig-44/14-N", small)
    name, contents = view.file()
    assert name.startswith("tyrecontact-fig-44-14-N-")
    assert name.endswith(".toml")
    assert contents.decode() == view.texts["Scenario file"]
