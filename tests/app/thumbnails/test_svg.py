"""Plots and maps at a glance: curves in their window, units, open places."""

from __future__ import annotations

import base64
import io
import re
from xml.etree import ElementTree

import numpy as np
from PIL import Image

from app.thumbnails import svg
from app.views.comparison import Curve, Panel, Style


def _points(drawn: str) -> np.ndarray:
    (points,) = re.findall(r'points="([^"]*)"', drawn)
    return np.array([pair.split(",") for pair in points.split()], float)


def _panel(y: np.ndarray, **kwargs: object) -> Panel:
    curve = Curve("run", np.linspace(0, 100, y.size), y, Style("#0072B2"))
    return Panel("Contact force", "Indentation [µm]", "Force [N]", [curve], **kwargs)


def test_a_curve_fills_its_window_and_axes_have_units() -> None:
    drawn = svg.plot(_panel(np.linspace(0, 50, 5), y_range=(0, 50)))
    assert drawn.count("<text") == 2
    root = ElementTree.fromstring(drawn)
    assert [text.text for text in root.iter("{http://www.w3.org/2000/svg}text")] == ["N", "µm"]
    assert root.get("aria-label") == "Force [N] against Indentation [µm]"
    inner = root.find("{http://www.w3.org/2000/svg}svg")
    width, height = float(inner.get("width")), float(inner.get("height"))
    points = _points(drawn)
    np.testing.assert_allclose(points[0], [0, height])
    np.testing.assert_allclose(points[-1], [width, 0])


def test_long_and_wild_curves_stay_small() -> None:
    wild = np.random.default_rng(1).standard_normal(20_000) * 1e4
    wild[7] = np.nan
    drawn = svg.plot(_panel(wild, y_range=(0, 50)))
    assert len(drawn) < 3000
    assert np.isfinite(_points(drawn)).all()


def test_a_map_stands_upright_and_leaves_open_what_is_apart() -> None:
    values = np.array([[0.0, 1.0], [np.nan, 2.0]])
    drawn = svg.field(values, "Force", "20 mm", ("#000000", "#808080", "#ffffff"))
    (data,) = re.findall(r"base64,([^\"]*)", drawn)
    image = Image.open(io.BytesIO(base64.b64decode(data))).convert("RGBA")
    pixels = np.asarray(image)
    assert pixels[0, 0, 3] == 0  # the first row of values is at the bottom
    assert list(pixels[1, 0]) == [0, 0, 0, 255]
    assert list(pixels[0, 1, :3]) == [255, 255, 255]
