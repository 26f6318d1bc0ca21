"""Makes the pictures: `python -m app.thumbnails DIR`, DIR written by `tyrecontact thesis`.

Figures are drawn from the runs in DIR, the other presets are run; it takes half a minute.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
from bokeh.palettes import cividis

from tyrecontact import Results, Simulation, figures, presets
from tyrecontact.assembly.road import road_patch
from tyrecontact.thesis.runs import run

from ..figure_panels import force_by_depth, force_by_time
from ..report import panels_of
from . import svg

#: figure -> which of its panels tells most; the first of the others
_BEST = {"fig-24-26": 3, "fig-30-34": 1, "fig-35-38": 1}
#: ramps -> how far they are shown [µm]
_RAMPS = {
    "thesis-instability": 120.0,
    "thesis-factor-2": 200.0,
    "thesis-factor-4": 200.0,
    "thesis-exchange": 120.0,
    "quasi-static": 200.0,
}
_COLORS = tuple(cividis(64))
#: pixels a side of a road's picture
_PIXELS = 84


def main() -> None:
    """Write a picture of every preset beside this file."""
    parser = argparse.ArgumentParser(prog="python -m app.thumbnails", description=__doc__)
    parser.add_argument("folder", type=Path, metavar="DIR", help="written by tyrecontact thesis")
    folder = parser.parse_args().folder
    for name, drawn in (*of_figures(folder), *of_presets()):
        (Path(__file__).parent / f"{name}.svg").write_text(drawn, encoding="utf-8")
        print(f"{name}: {len(drawn)} bytes")


def of_figures(folder: Path) -> Iterator[tuple[str, str]]:
    """Name and picture of each figure of the thesis."""
    record = json.loads((folder / "thesis.json").read_text(encoding="utf-8"))
    for entry in record["figures"]:
        name = entry["name"]
        if figures.find(name).numbers:
            yield name, svg.plot(panels_of(folder, entry)[_BEST.get(name, 0)])


def of_presets() -> Iterator[tuple[str, str]]:
    """Name and picture of each preset that is no figure."""
    for name in presets.PRESETS:
        if name in _RAMPS:
            family = {"quasi-static": _run("quasi-static"), name: _run(name)}
            if name == "quasi-static":
                family = {"alone": _run(name)}  # else it would lie grey behind the others
            yield name, svg.plot(force_by_depth(_RAMPS[name])(family))
        elif name == "adhesion":
            yield name, svg.plot(force_by_time({name: _run(name)}))
        elif name.startswith("road-"):
            yield name, _road(name)
        else:
            yield name, _contact(name)


@cache
def _run(name: str) -> Results:
    return run(presets.get(name).to_dict())


def _road(name: str) -> str:
    """Heights, each pixel the mean of its square."""
    road = presets.get(name).road
    heights = road_patch(road).heights
    many = heights.shape[0] // _PIXELS
    cut = heights[: many * _PIXELS, : many * _PIXELS]
    small = cut.reshape(_PIXELS, many, _PIXELS, many).mean(axis=(1, 3))
    return svg.field(small, "Heights of the road", f"{road.size * 1e3:g} mm", _COLORS)


def _contact(name: str) -> str:
    """Forces of the elements half-way in."""
    simulation = Simulation(presets.get(name))
    half = simulation.scenario.loading.max_indentation / 2
    step = next(step for step in simulation if step.indentation >= half)
    force = np.where(step.element_force > 0, step.element_force, np.nan)
    side = f"{simulation.scenario.road.size * 1e3:g} mm"
    return svg.field(force, "Force on each element", side, _COLORS)


if __name__ == "__main__":
    main()
