"""The code that gives the run which the form stands for: to copy, and as a file."""

from __future__ import annotations

from html import escape
from pathlib import Path

import panel as pn
import panel_material_ui as pmui

from tyrecontact import Scenario

from .. import code, exports
from .file_button import file_button
from .style import DESK, Size

_COPY = (Path(__file__).parent / "copy_code.js").read_text(encoding="utf-8")
#: title -> what it is for, and what makes it
_BLOCKS = {
    "Python": ("A script: it runs this scenario and keeps the run as run.nc.", code.python),
    "Command line": ("The same in a terminal (Linux, macOS).", code.command_line),
    "Scenario file": (
        "For tyrecontact run FILE.toml, and to keep.",
        code.toml,
    ),
}
_STYLE = """
h3 { margin: 0 0 2px; font-size: var(--title); font-weight: 500; }
p { margin: 0 0 6px; font-size: var(--label);
    color: color-mix(in srgb, currentColor 75%, transparent); }
pre { margin: 0; padding: 10px 12px; overflow-x: auto; border-radius: 8px; line-height: 1.5;
      font: var(--label) ui-monospace, SFMono-Regular, Menlo, Consolas, monospace;
      border: 1px solid color-mix(in srgb, currentColor 18%, transparent);
      background: color-mix(in srgb, currentColor 5%, transparent); }
pre:focus-visible { outline: 2px solid currentColor; outline-offset: 1px; }
"""


class CodeView:
    """Attributes: `root` a column; `texts` title of a block -> its code, as shown."""

    def __init__(self) -> None:
        self.root = pn.Column(sizing_mode="stretch_width")
        self.texts: dict[str, str] = {}
        self._blocks: dict[str, pn.pane.HTML] = {}
        self._preset = "default"
        self._shown: tuple[str, dict, Size] | None = None

    def show_scenario(self, preset: str, scenario: Scenario, size: Size = DESK) -> None:
        """Show the code of a scenario.

        Parameters
        ----------
        preset, scenario : that the form says now.
        size : of the type.
        """
        bare = code.without_folders(scenario)
        wanted = (preset, bare.to_dict(), size)
        if wanted == self._shown:
            return
        self._preset, self._shown = preset, wanted
        if not self._blocks:
            self._build()
        for title, (purpose, make) in _BLOCKS.items():
            self.texts[title] = make(preset, bare)
            self._blocks[title].object = _html(title, purpose, self.texts[title], size)

    def file(self) -> tuple[str, bytes]:
        """Name and contents of the scenario file."""
        return exports.file_name(self._preset, "toml"), self.texts["Scenario file"].encode()

    def _build(self) -> None:
        for title in _BLOCKS:
            block = pn.pane.HTML("", stylesheets=[_STYLE], sizing_mode="stretch_width")
            label = f"Copy: {title}"
            button = pmui.Button(label=label, tags=[label], size="small", variant="outlined")
            button.js_on_click(args={"block": block, "button": button}, code=_COPY)
            self._blocks[title] = block
            self.root.extend([block, button])
        last = self.root.pop(-1)
        self.root.append(pn.FlexBox(last, file_button("Download the scenario file", self.file)))


def _html(title: str, purpose: str, text: str, size: Size) -> str:
    """A block; the code can be scrolled by keyboard."""
    return (
        f'<div style="--title: {size.title}px; --label: {size.label}px">'
        f"<h3>{escape(title)}</h3><p>{escape(purpose)}</p>"
        f'<pre tabindex="0" role="region" aria-label="{escape(title)}">{escape(text)}</pre></div>'
    )
