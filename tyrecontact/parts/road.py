"""Settings of the road: the patch and its roughness springs."""

from __future__ import annotations

from tyrecontact.settings import Choice, Count, Part, Quantity, Text

_UM, _MM, _MPA = ("µm", 1e6), ("mm", 1e3), ("MPa", 1e-6)


class Road(Part):
    """The patch of road: read from a file, or made from a seed.

    Self-affine and clipped roads take their rms from `valley_rms`, their stones from `stone_size`.
    """

    file = Text("", "Road scan or profile to read; empty: a road is made")
    pitch = Quantity(
        0.0, (0.0, 1e-2), "m", "Distance of neighbouring heights in the file; 0: not given", _UM
    )
    height_unit = Choice("", ["", "m", "mm", "um"], "Unit of the heights in the file")
    height_direction = Choice("up", ["up", "down"], "Which way the heights of the file are counted")
    trim_start = Quantity(
        0.0, (0.0, 1e3), "m", "Taken off the start of a profile: reference plate, run-in", _MM
    )
    trim_end = Quantity(0.0, (0.0, 1e3), "m", "Taken off the end of a profile", _MM)
    levelling = Choice("plane", ["none", "plane"], "What is taken off a measured road first")
    fill_limit = Quantity(
        0.1, (0.0, 0.9), "", "Largest share of missing heights that is filled from around them"
    )
    centre_x = Quantity(0.0, (-1e3, 1e3), "m", "Patch off the middle of the file, along x", _MM)
    centre_y = Quantity(0.0, (-1e3, 1e3), "m", "Patch off the middle of the file, along y", _MM)
    profile_use = Choice(
        "corrugated",
        ["corrugated", "isotropic"],
        "A 1-D profile is drawn out sideways, or gives spectrum and heights of a 2-D road",
    )
    size = Quantity(20e-3, (1e-3, 0.2), "m", "Side of the square patch", _MM)
    elements = Count(20, (2, 256), "Elements along a side of the patch")
    texture = Choice("worn", ["worn", "self-affine", "clipped"], "Kind of road that is made")
    seed = Count(1, (0, 2**32 - 1), "Seed of the made road")
    pixel = Quantity(25e-6, (5e-6, 1e-3), "m", "Pitch of the made road", _UM)
    clip_height = Quantity(
        50e-6, (-5e-3, 5e-3), "m", "Where a clipped road is cut, above its mean", _UM
    )
    stone_size = Quantity(
        1.15e-3, (0.2e-3, 0.1), "m", "Roll-off wavelength of stones and valleys", _MM
    )
    valley_rms = Quantity(300e-6, (1e-6, 5e-3), "m", "Rms height of stones and valleys", _UM)
    valley_offset = Quantity(
        430e-6, (-5e-3, 5e-3), "m", "Mean of the valleys' surface above the plateau: wear", _UM
    )
    plateau_rms = Quantity(20e-6, (1e-7, 1e-3), "m", "Rms height of the polished plateau", _UM)
    plateau_wavelength = Quantity(
        17e-3, (0.2e-3, 0.1), "m", "Roll-off wavelength of the polished plateau", _MM
    )
    polish = Quantity(
        1.5, (0.0, 100.0), "", "Mean of the valleys raised per height of the plateau: tops polished"
    )
    hurst = Quantity(1.0, (0.05, 1.0), "", "Hurst exponent of all surfaces")


class Springs(Part):
    """Roughness springs (thesis, chapter 3.2)."""

    youngs_modulus = Quantity(10e6, (1e4, 1e10), "Pa", "Modulus of the rubber at small scale", _MPA)
    punch = Choice("frictionless", ["frictionless", "no-slip"], "How the punch holds the rubber")
    reading = Choice(
        "tangent",
        ["tangent", "secant"],
        "Punch stiffness as dF/d(delta) (contact mechanics), or as F/delta (the thesis' wording)",
    )
    smoothing = Choice(
        "monotone", ["monotone", "polynomial"], "Monotone spline, or the thesis' 10th order"
    )
    simplification = Choice(
        "none",
        ["none", "mean", "standard", "linear"],
        "Each its own; one mean spring; a few standard ones; or linear ones",
    )
    standard_count = Count(4, (1, 64), "Number of standard springs", "springs")
    linear_compression = Quantity(
        10e-6, (1e-8, 1e-3), "m", "Compression at which linear springs have the true force", _UM
    )
    exchange_count = Count(0, (0, 8192), "Stiffest springs exchanged for the next ones", "springs")
    exchange_compression = Quantity(
        9e-6, (1e-8, 1e-3), "m", "Compression at which springs are ranked", _UM
    )
    exchange_ranking = Choice("force", ["force", "stiffness"], "What springs are ranked by")
