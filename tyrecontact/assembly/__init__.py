"""From settings to bodies: the road, its springs, the tread and the loading of a scenario."""

from tyrecontact.assembly.checks import require_consistent, require_shallow
from tyrecontact.assembly.process import adhesion_law, loading_path, machine
from tyrecontact.assembly.road import (
    arranged_springs,
    original_springs,
    road_patch,
    road_scan,
    road_understood,
    roughness_springs,
)
from tyrecontact.assembly.tread import tread_kernel, tread_layers, tread_thickness

__all__ = [
    "adhesion_law",
    "arranged_springs",
    "loading_path",
    "machine",
    "original_springs",
    "require_consistent",
    "require_shallow",
    "road_patch",
    "road_scan",
    "road_understood",
    "roughness_springs",
    "tread_kernel",
    "tread_layers",
    "tread_thickness",
]
