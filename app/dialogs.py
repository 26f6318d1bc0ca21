"""What opens above the page: presets, a link to share, help. One dialog, made when first opened."""

from __future__ import annotations

from collections.abc import Callable

import panel as pn
import panel_material_ui as pmui

from . import links
from .browser import Browser
from .controls import Controls
from .keyboard import HELP
from .runner import Run
from .views.downloads import Downloads
from .views.gallery import Gallery

_ABOUT = """
<p>A block of tyre rubber is pressed onto a patch of rough road. The road is cut into elements, each
with a spring that stands for its small-scale roughness; the rubber is a layered viscoelastic plate.
In every time step Newton's method finds the forces on all elements at once, and adhesion holds
elements back when the two part.</p>
<p><strong>To begin</strong>: press <em>Run</em> and watch the force, the iterations and the map.
Tap an element of the map to follow it. Move a control and run again, or switch on <em>Live</em>.
Pin runs in the tab <em>Compare</em>. The <em>Lessons</em> lead through the thesis, the tab
<em>Theory</em> has the equations.</p>
<p>The model is that of J. Winroth's thesis (Chalmers 2010:8). Nothing you do leaves this server,
and a run stays until you close the tab.</p>"""
_IN_A_LINK = "The link holds the preset and what differs from it, not the run"
_SHARE = "Share and download"
_STYLE = """
:host { font-size: calc(15px * var(--scale, 1)); line-height: 1.5; }
th { text-align: left; padding: 3px 24px 3px 0; white-space: nowrap; }
caption { text-align: left; font-weight: 600; padding: 4px 0; }
p { margin: 0 0 10px; max-width: 70ch; }"""


class Dialogs:
    """Dialogs of one session.

    Parameters
    ----------
    load_preset : called with the name of a preset that was chosen.
    run : gives the run on show, and the preset it began as.

    Attributes
    ----------
    root : the dialog, closed at first.
    """

    def __init__(
        self,
        controls: Controls,
        browser: Browser,
        load_preset: Callable[[str], None],
        run: Callable[[], tuple[str, Run | None]],
    ) -> None:
        self._controls, self._browser, self._load_preset = controls, browser, load_preset
        self._run, self._downloads = run, Downloads()
        self._gallery: Gallery | None = None
        self._sharing = False
        self.root = pmui.Dialog(
            title_variant="h6", close_on_click=True, show_close_button=True, scroll="paper"
        )

    def presets(self) -> None:
        """Choose a preset."""
        if self._gallery is None:
            self._gallery = Gallery(self._chosen)
        self._gallery.show(self._controls.preset)
        self._open("Presets", "lg", self._gallery.root)

    def help(self) -> None:
        """What this is, and the keys."""
        rows = "".join(f"<tr><th scope='row'>{key}</th><td>{does}</td></tr>" for key, does in HELP)
        text = f"{_ABOUT}<table><caption>Keys</caption><tbody>{rows}</tbody></table>"
        self._open("tyrecontact", "md", pn.pane.HTML(text, stylesheets=[_STYLE]))

    def share(self) -> None:
        """What can be taken away: a link to what the form says; the run on show; the plots."""
        controls = self._controls
        link = f"{self._browser.address}?{links.query(controls.preset, controls.scenario)}"
        entry = pmui.TextInput(
            label="Link to this scenario", value=link, sizing_mode="stretch_width", margin=(10, 10)
        )
        note = pmui.Typography(
            ". ".join([*links.unshared(controls.scenario), _IN_A_LINK]), variant="body2",
            margin=(0, 10),
        )  # fmt: skip
        copy = pmui.Button(label="Copy the link", icon="content_copy", variant="contained")
        copy.on_click(lambda _: self._browser.copy(link))

        def copied(worked: bool) -> None:
            note.object = (
                "Copied." if worked else "Not copied: select the link and copy it by hand."
            )

        self._browser.on_copied = copied
        self._offer()
        self._open(_SHARE, "md", entry, copy, note, self._downloads.root)

    def refresh(self) -> None:
        """Follow the run on show, where its files are offered."""
        if self._sharing and self.root.open:
            self._offer()

    def _offer(self) -> None:
        """The files of the run on show; before one, pictures of what the form says."""
        preset, run = self._run()
        self._downloads.show(self._controls.preset if run is None else preset, run)

    def _chosen(self, name: str) -> None:
        self.root.open = False
        self._load_preset(name)

    def _open(self, title: str, width: str, *content: object) -> None:
        self._sharing = title == _SHARE
        self.root.param.update(title=title, width_option=width, objects=list(content), open=True)
