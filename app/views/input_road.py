"""The road that goes into a run: all its heights beside the tops of its elements."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import holoviews as hv
import numpy as np
from bokeh.models import FixedTicker

from tyrecontact import Simulation
from tyrecontact.parts.road import Road
from tyrecontact.road.heights import Patch, element_tops
from tyrecontact.road.profile_depth import ProfileDepth, mean_profile_depth

from . import rest
from .headline import three_digits
from .input_sheet import SQUARE, Sheet, square
from .style import Size

#: heights along a side that are drawn at most; a screen shows no more
MOST = 400
#: more elements a side than this are drawn without their lattice: it would hide the road
_LATTICE_UP_TO = 40
#: colours begin where all but this share [%] of the heights lie above: valleys are deep and few
_DEEPEST = 5.0
#: width over height of a map with title, axes and colour bar
_ASPECT = 0.84
_CAPTION = (
    "The road under the patch, and what the contact keeps of it: of each element the highest "
    "point, which touches first, and all its heights, from which its spring is read "
    "(thesis, chapters 3.1 and 3.2)."
)


@dataclass(frozen=True)
class RoadInput:
    """What is drawn of a road.

    Attributes
    ----------
    heights : [µm] about their mean, every `stride`-th of each direction.
    tops : of the elements [µm] below the highest, shape (elements, elements), at most 0.
    side : of the patch [mm].
    shape : of all heights.
    facts : name -> value with unit.
    """

    heights: np.ndarray
    stride: int
    tops: np.ndarray
    side: float
    shape: tuple[int, int]
    facts: dict[str, str]

    @classmethod
    def of(cls, simulation: Simulation) -> RoadInput:
        """Raises InputError for a road file that cannot be used; takes up to a second."""
        patch, road = simulation.patch, simulation.scenario.road
        stride = -(-max(patch.heights.shape) // MOST)
        thinned = (patch.heights[::stride, ::stride] - patch.heights.mean()) * 1e6
        tops = element_tops(patch, road.elements)
        ny, nx = patch.heights.shape
        return cls(
            heights=thinned.astype(np.float32),
            stride=stride,
            tops=((tops - tops.max()) * 1e6).astype(np.float32),
            side=road.size * 1e3,
            shape=(ny, nx),
            facts=_facts(patch, road, tops),
        )

    def sheet(self) -> Sheet:
        """Facts, caption and the two maps."""
        return Sheet(self.facts, _CAPTION, (self.draw_heights, self.draw_tops))

    def draw_heights(self, size: Size) -> Any:
        """All heights as a map, the elements' lattice faintly on it."""
        ny, nx = self.shape
        drawn = "" if self.stride == 1 else f", every {_nth(self.stride)} drawn"
        title = f"Heights ({ny} × {nx}{drawn})"
        return self._map(self.heights, title, "Height about the mean [µm]", "heights", size)

    def draw_tops(self, size: Size) -> Any:
        """The highest point of each element as a map."""
        rows, columns = self.tops.shape
        title = f"Tops of the elements ({rows} × {columns})"
        return self._map(self.tops, title, "Below the highest point [µm]", "tops", size)

    def _map(self, values: np.ndarray, title: str, label: str, name: str, size: Size) -> Any:
        """A square map; colours tell apart what lies above the deepest valleys."""
        low, high = float(np.percentile(values, _DEEPEST)), float(values.max())
        if not high > low:
            low, high = high - 1, high + 1
        image = hv.Image(
            values[::-1],  # HoloViews counts rows from above
            ["x [mm]", "y [mm]"], hv.Dimension(name, label=label),
            bounds=(0, 0, self.side, self.side),
        ).opts(
            cmap="cividis", clim=(low, high), colorbar=True, colorbar_position="bottom",
            clabel=f"{label}; darkest: {three_digits(low)} and below",
            colorbar_opts={"title_text_font_style": "normal", "height": 12, "width": "auto",
                           "background_fill_alpha": 0},
            tools=["hover"], title=title, backend_opts=self._square_with_lattice(),
        )  # fmt: skip
        return square(rest.pane(image, size, SQUARE), size)

    def _square_with_lattice(self) -> dict[str, Any]:
        """What Bokeh is to be told: the borders of the elements are a grid upon the map."""
        told: dict[str, Any] = {"plot.sizing_mode": "scale_width", "plot.aspect_ratio": _ASPECT}
        elements = len(self.tops)
        borders = FixedTicker(ticks=list(np.linspace(0, self.side, elements + 1)))
        for grid in ("xgrid", "ygrid"):
            told |= {
                f"{grid}.visible": elements <= _LATTICE_UP_TO, f"{grid}.ticker": borders,
                f"{grid}.level": "overlay", f"{grid}.grid_line_color": "#FFFFFF",
                f"{grid}.grid_line_alpha": 0.16,
            }  # fmt: skip
        return told


def _nth(stride: int) -> str:
    return {2: "2nd", 3: "3rd"}.get(stride, f"{stride}th")


def _facts(patch: Patch, road: Road, tops: np.ndarray) -> dict[str, str]:
    depth = mean_profile_depth(patch.heights, patch.pitch)
    made = f"{road.texture}, seed {road.seed}"
    size = f"{road.size * 1e3:.4g}"
    return {
        "Road": Path(road.file).name if road.file else made,
        "Size": f"{size} × {size} mm",
        "Pitch": f"{three_digits(patch.pitch * 1e6)} µm",
        "Height, rms (Sq)": f"{three_digits(patch.rms * 1e6)} µm",
        "Slope, rms": three_digits(patch.rms_slope),
        "Skewness": three_digits(patch.skewness),
        "Tops, standard deviation": f"{three_digits(float(tops.std()) * 1e6)} µm",
        "Mean profile depth": _depth(depth),
    }


def _depth(found: ProfileDepth | None) -> str:
    """With the length it was found on, where that is not the standard's."""
    if found is None:
        return "cannot be told"
    short = "" if found.standard else f" over {found.segment * 1e3:.3g} mm"
    return f"{three_digits(found.depth * 1e3)} mm{short}"
