"""What a contact map can show of its elements, each with its unit."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from tyrecontact.contact.bonds import ElementState

from .style import BLUE, ORANGE, VERMILION

Fields = Mapping[str, np.ndarray]

#: by `ElementState`: what it is called, and its colour where states are shown
STATES = ("apart", "pressed", "in tension", "released")
STATE_COLORS = ("#9AA0A859", BLUE, ORANGE, VERMILION)


@dataclass(frozen=True)
class Mode:
    """One quantity.

    Attributes
    ----------
    title : with its unit.  unit : for a value at the pointer.
    values : fields, area of an element [m2] -> values in that unit, NaN where there are none.
    marks : whether elements in tension and released ones are marked.
    """

    title: str
    unit: str
    values: Callable[[Fields, float], np.ndarray]
    marks: bool = False


def touching(fields: Fields) -> np.ndarray:
    """Elements that are pressed, or held by a bond."""
    state = fields["state"]
    return (state == ElementState.COMPRESSED) | (state == ElementState.TENSION)


def _of_touching(name: str, factor: float) -> Callable[[Fields, float], np.ndarray]:
    return lambda fields, _: np.where(touching(fields), fields[name] * factor, np.nan)


MODES: Mapping[str, Mode] = MappingProxyType(
    {
        "force": Mode("Force [N]", "N", _of_touching("element_force", 1.0), True),
        "compression": Mode(
            "Compression [µm]", "µm", _of_touching("compression", 1e6), True
        ),
        "displacement": Mode(
            "Displacement [µm]", "µm", lambda f, _: f["displacement"] * 1e6
        ),
        "state": Mode("State", "", lambda f, _: f["state"].astype(float), True),
        "age": Mode("Time in contact [ms]", "ms", _of_touching("age", 1e3)),
        "contact area": Mode(
            "Contact area [%]", "%",
            lambda f, area: np.where(touching(f), f["contact_area"] * (100 / area), np.nan),
        ),
    }
)  # fmt: skip
