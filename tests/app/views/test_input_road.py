"""The road that goes into a run: what is drawn of it, and what is said."""

from __future__ import annotations

import numpy as np
import pytest

from app.views.input_road import MOST, RoadInput
from app.views.style import DESK, HALL
from tyrecontact import Scenario, Simulation
from tyrecontact.road.heights import element_tops


def test_heights_and_tops_are_those_of_the_road(small: Scenario) -> None:
    simulation = Simulation(small)
    road = RoadInput.of(simulation)
    patch = simulation.patch
    assert road.stride == 1
    np.testing.assert_allclose(
        road.heights, (patch.heights - patch.heights.mean()) * 1e6, atol=1e-4
    )
    tops = element_tops(patch, 6)
    np.testing.assert_allclose(road.tops, (tops - tops.max()) * 1e6, atol=1e-4)
    assert road.tops.max() == 0
    assert road.facts["Size"] == "6 × 6 mm"
    assert road.facts["Pitch"] == "50.0 µm"
    assert road.facts["Road"] == "worn, seed 1"
    assert road.facts["Mean profile depth"].endswith("mm over 6 mm")


def test_no_more_is_drawn_than_a_screen_shows(small: Scenario) -> None:
    small.road.pixel = 1e-5
    simulation = Simulation(small)
    road = RoadInput.of(simulation)
    assert (road.shape, road.stride) == ((600, 600), 2)
    assert max(road.heights.shape) <= MOST
    image = road.draw_heights(DESK).object
    assert image.opts.get().kwargs["title"] == "Heights (600 × 600, every 2nd drawn)"
    assert "and below" in image.opts.get().kwargs["clabel"]


@pytest.mark.parametrize("size", [DESK, HALL])
def test_a_map_is_square_with_the_elements_upon_it(small: Scenario, size: object) -> None:
    road = RoadInput.of(Simulation(small))
    for plot in (road.draw_heights(size), road.draw_tops(size)):
        fig = plot.get_root().children[0]
        assert (fig.sizing_mode, fig.aspect_ratio) == ("scale_width", 0.84)
        assert (fig.x_range.end, fig.y_range.end) == (6, 6)
        np.testing.assert_allclose(fig.xgrid[0].ticker.ticks, range(7))
        assert fig.xgrid[0].visible
        assert fig.title.text_font_size == f"{size.title}px"
    # the first row of elements is below
    drawn = fig.renderers[0].data_source.data["image"][0]
    np.testing.assert_array_equal(drawn, road.tops)
