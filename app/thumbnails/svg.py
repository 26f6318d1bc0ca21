"""A plot, or a map, as an SVG of 150 x 90: what is seen at a glance, and the units."""

from __future__ import annotations

import base64
import io
from html import escape

import numpy as np

from ..views.comparison import Curve, Panel, thinned

WIDTH, HEIGHT = 150, 90
#: where curves are drawn: left, top, right, bottom
_BOX = (6.0, 12.0, 146.0, 79.0)
_POINTS = 110
_QUIET = "fill:none;stroke:currentColor;stroke-opacity:.45"
_TYPE = 'font-size="8.5" fill="currentColor" fill-opacity=".8"'


def plot(panel: Panel) -> str:
    """The curves of a panel in its window, between axes that carry their units."""
    left, top, right, bottom = _BOX
    x_range, y_range = _window(panel)
    zero = bottom - (bottom - top) * (0 - y_range[0]) / (y_range[1] - y_range[0])
    floor = min(max(zero, top), bottom)
    curves = "".join(_curve(curve, x_range, y_range, panel.steps) for curve in panel.curves)
    return _svg(
        f"{panel.y_label} against {panel.x_label}",
        f'<path style="{_QUIET}" d="M{left} {top}V{bottom}M{left} {floor:.1f}H{right}"/>'
        # an inner svg cuts off what leaves the window
        f'<svg x="{left}" y="{top}" width="{right - left}" height="{bottom - top}">{curves}</svg>'
        f'<text x="{left}" y="8" {_TYPE}>{_unit(panel.y_label)}</text>'
        f'<text x="{right}" y="88.5" text-anchor="end" {_TYPE}>{_unit(panel.x_label)}</text>',
    )


def field(values: np.ndarray, meaning: str, side: str, palette: tuple[str, ...]) -> str:
    """A square map; what is not finite is left open.

    Parameters
    ----------
    values : any unit, shape (ny, nx), the first row at the bottom.
    meaning : what is shown.  side : length of a side, with its unit.  palette : low to high.
    """
    data = base64.b64encode(_png(values[::-1], palette)).decode()
    return _svg(
        meaning,
        f'<image x="33" y="3" width="84" height="84" style="image-rendering:pixelated" '
        f'href="data:image/png;base64,{data}"/>'
        f'<rect x="33" y="3" width="84" height="84" style="{_QUIET}"/>'
        f'<text x="121" y="86" {_TYPE}>{escape(side)}</text>',
    )


def _svg(meaning: str, drawn: str) -> str:
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" '
        f'aria-label="{escape(meaning)}" font-family="sans-serif">{drawn}</svg>\n'
    )


def _unit(label: str) -> str:
    """The unit of an axis, "N" of "Force [N]", or what it counts."""
    head, bracket, rest = label.partition("[")
    return escape(rest.partition("]")[0] if bracket else head)


def _window(panel: Panel) -> tuple[tuple[float, float], tuple[float, float]]:
    return (
        panel.x_range or _span([curve.x for curve in panel.curves], 0.0),
        panel.y_range or _span([curve.y for curve in panel.curves], 0.06),
    )


def _span(values: list[np.ndarray], margin: float) -> tuple[float, float]:
    finite = np.concatenate([part[np.isfinite(part)] for part in values])
    low, high = float(finite.min()), float(finite.max())
    return low - margin * (high - low), high + margin * (high - low)


def _curve(
    curve: Curve, x_range: tuple[float, float], y_range: tuple[float, float], steps: bool
) -> str:
    """A line; what lies far outside the window is brought near, so that numbers stay short."""
    left, top, right, bottom = _BOX
    seen = np.isfinite(curve.y) & (curve.x >= x_range[0]) & (curve.x <= x_range[1])
    x, y = thinned(curve.x[seen], curve.y[seen], _POINTS)
    across = (right - left) * (x - x_range[0]) / (x_range[1] - x_range[0])
    down = (bottom - top) * (y_range[1] - y) / (y_range[1] - y_range[0])
    down = np.clip(down, -20.0, bottom - top + 20.0)
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(across, down, strict=True))
    # mixed with the text's colour: darker on white, lighter on black
    color = f"color-mix(in srgb,{curve.style.color} 80%,currentColor)"
    width = 0.75 * curve.style.width + (0.0 if steps else 0.15)
    return (
        f'<polyline style="fill:none;stroke:{color};stroke-width:{width:.2f};'
        f'stroke-opacity:{curve.style.alpha};stroke-linejoin:round" points="{points}"/>'
    )


def _png(values: np.ndarray, palette: tuple[str, ...]) -> bytes:
    from PIL import Image  # comes with Bokeh; only the script needs it

    finite = values[np.isfinite(values)]
    share = (values - finite.min()) / (np.ptp(finite) or 1.0)
    place = np.rint(np.nan_to_num(share) * (len(palette) - 1))
    index = np.where(np.isfinite(values), 1 + place, 0)
    colors = [channel for color in palette for channel in bytes.fromhex(color[1:])]
    image = Image.fromarray(index.astype(np.uint8))
    image.putpalette([0, 0, 0, *colors])
    stream = io.BytesIO()
    image.save(stream, "PNG", transparency=0, optimize=True)
    return stream.getvalue()
