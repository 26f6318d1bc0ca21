"""Where the live plots stand: they fill a screen, in two columns or, on a phone, in one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import panel as pn

if TYPE_CHECKING:
    from .live import Live

#: heights that fill a screen and no more: what stands above and below is taken off
_LEFT = "(100vh - 132px - 200px * var(--scale, 1) - var(--taken, 0px))"
_FORCE = f"clamp(230px, calc({_LEFT} * 0.6), 640px)"
_ITERATIONS = f"clamp(190px, calc({_LEFT} * 0.4), 420px)"
#: the map is square, and so no wider than there is height
_MAP = f"max(330px, calc({_LEFT} * 0.87))"

#: one column on a phone
_TWO_COLUMNS = """
:host { display: grid; grid-template-columns: minmax(0, 7fr) minmax(0, 5fr); }
@media (max-width: 900px) {
  :host { grid-template-columns: minmax(0, 1fr); grid-auto-rows: max-content; }
}"""
#: on a phone the legend gets a line of its own
_WRAP = "@media (max-width: 600px) { :host { flex-wrap: wrap; } }"


def arrange(live: Live) -> pn.Column:
    """Plots, player and element of a visitor, in their places."""

    def plot(root: Any, height: str) -> pn.Column:
        filled = pn.pane.Bokeh(root, sizing_mode="stretch_both", margin=0)
        return pn.Column(filled, sizing_mode="stretch_width", margin=0, styles={"height": height})

    top = pn.Row(
        live.axis, live.pin, live.legend.root,
        sizing_mode="stretch_width", margin=0, stylesheets=[_WRAP],
    )  # fmt: skip
    curves = pn.Column(
        top, plot(live.force.root, _FORCE), plot(live.iterations.root, _ITERATIONS),
        sizing_mode="stretch_width", margin=0,
    )  # fmt: skip
    touching = pn.Column(
        live.mode, pn.pane.Bokeh(live.contact_map.root, sizing_mode="scale_width"),
        sizing_mode="stretch_width", margin=0, styles={"max-width": _MAP},
    )  # fmt: skip
    both = pn.Row(
        curves, touching, sizing_mode="stretch_width", margin=0, stylesheets=[_TWO_COLUMNS]
    )
    return pn.Column(
        both, live.player.root, live.element.root, sizing_mode="stretch_width", margin=0
    )
