"""From settings to bodies: the road, its springs, the tread and the loading of a scenario."""

from tyrecontact.assembly.checks import require_consistent
from tyrecontact.assembly.process import loading_path
from tyrecontact.assembly.road import road_patch, roughness_springs
from tyrecontact.assembly.tread import tread_kernel, tread_layers, tread_thickness

__all__ = [
    "loading_path",
    "require_consistent",
    "road_patch",
    "roughness_springs",
    "tread_kernel",
    "tread_layers",
    "tread_thickness",
]
