"""The question: every setting of a run, declared once.

From this one declaration come validation, command-line options, files and the page's controls.
All values are SI; `metadata["shown_in"]` is what a form shows instead.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import param

from tyrecontact.errors import InputError, unknown_name
from tyrecontact.settings import Choice, Count, Group, Part, Quantity, Text, parsed

_UM, _MM, _MS, _MPA = ("µm", 1e6), ("mm", 1e3), ("ms", 1e3), ("MPa", 1e-6)
_RATE = ("mm/s", 1e3)


class Road(Part):
    """The patch of road: read from a file, or made worn from a seed."""

    file = Text("", "Height map to read (.npy, .npz or a text matrix); empty: a road is made")
    pitch = Quantity(
        0.0, (0.0, 1e-2), "m", "Distance of neighbouring heights in the file; 0: not given", _UM
    )
    height_unit = Choice("", ["", "m", "mm", "um"], "Unit of the heights in the file")
    size = Quantity(20e-3, (1e-3, 0.2), "m", "Side of the square patch", _MM)
    elements = Count(20, (2, 128), "Elements along a side of the patch")
    seed = Count(1, (0, 2**32 - 1), "Seed of the made road")
    pixel = Quantity(25e-6, (5e-6, 1e-3), "m", "Pitch of the made road", _UM)
    stone_size = Quantity(
        5e-3, (0.2e-3, 0.1), "m", "Roll-off wavelength of stones and valleys", _MM
    )
    valley_rms = Quantity(150e-6, (1e-6, 5e-3), "m", "Rms height of stones and valleys", _UM)
    valley_offset = Quantity(
        120e-6, (-5e-3, 5e-3), "m", "Mean of the valleys' surface above the plateau: wear", _UM
    )
    plateau_rms = Quantity(22e-6, (1e-7, 1e-3), "m", "Rms height of the polished plateau", _UM)
    plateau_wavelength = Quantity(
        16e-3, (0.2e-3, 0.1), "m", "Roll-off wavelength of the polished plateau", _MM
    )
    hurst = Quantity(0.8, (0.05, 1.0), "", "Hurst exponent of both surfaces")


class Springs(Part):
    """Roughness springs (thesis, chapter 3.2)."""

    youngs_modulus = Quantity(10e6, (1e4, 1e10), "Pa", "Modulus of the rubber at small scale", _MPA)
    exchange_count = Count(0, (0, 8192), "Stiffest springs exchanged for the next ones", "springs")
    exchange_compression = Quantity(
        9e-6, (1e-8, 1e-3), "m", "Compression at which springs are ranked by force", _UM
    )


class Tread(Part):
    """Two layers on a rigid base (thesis, Appendix B)."""

    static_modulus = Quantity(25e6, (1e4, 1e12), "Pa", "Young's modulus at rest", _MPA)
    exponent = Quantity(0.6091, (0.05, 1.0), "", "Exponent of the fractional Kelvin-Voigt law")
    relaxation_time = Quantity(
        3.717e-6, (1e-12, 1.0), "s", "Time constant of that law", ("µs", 1e6)
    )
    poissons_ratio = Quantity(0.499, (-0.9, 0.4999), "", "Poisson's ratio of the tread")
    density = Quantity(1300.0, (1.0, 3e4), "kg/m3", "Density of the tread")
    thickness = Quantity(10e-3, (0.1e-3, 0.2), "m", "Thickness of the tread", _MM)
    base_modulus = Quantity(72e9, (1e5, 1e13), "Pa", "Young's modulus of the base", ("GPa", 1e-9))
    base_loss_factor = Quantity(5e-5, (0.0, 0.09), "", "Loss factor of the base", ("1e-5", 1e5))
    base_poissons_ratio = Quantity(0.33, (-0.9, 0.4999), "", "Poisson's ratio of the base")
    base_density = Quantity(2700.0, (1.0, 3e4), "kg/m3", "Density of the base")
    base_thickness = Quantity(3e-3, (1e-5, 0.2), "m", "Thickness of the base", _MM)


class Loading(Part):
    """How the road is moved into the tread (thesis, chapters 4.3 and 5.1)."""

    profile = Choice(
        "linear", ["linear", "quadratic", "load-hold-unload"], "Indentation against time"
    )
    max_indentation = Quantity(0.2e-3, (1e-6, 2e-3), "m", "Largest indentation", _MM)
    rate = Quantity(0.03, (1e-4, 10.0), "m/s", "Rate of loading (linear, load-hold-unload)", _RATE)
    acceleration = Quantity(9.0, (1e-3, 1e5), "m/s2", "Acceleration (quadratic); 2 C of the thesis")
    hold_time = Quantity(2e-3, (0.0, 10.0), "s", "Time at the largest indentation", _MS)
    unloading_rate = Quantity(0.003, (1e-5, 10.0), "m/s", "Rate of unloading", _RATE)
    retraction = Quantity(
        0.2e-3, (0.0, 2e-3), "m", "How far above first contact the road ends after unloading", _MM
    )


class Adhesion(Part):
    """What holds road and tread together (thesis, chapter 5)."""

    release_force = Quantity(
        0.6, (0.0, 100.0), "N", "Tension at which an element lets go; 0: no adhesion"
    )


class Numerics(Part):
    """How it is computed."""

    kernel = Choice(
        "passive",
        ["passive", "band-limited", "static"],
        "Element kernel: passive is stable, band-limited is the thesis', static is quasi-static",
    )
    solver = Choice("robust", ["robust", "thesis"], "Newton's method: guarded, or the thesis' own")
    time_resolution_factor = Count(1, (1, 16), "How many times finer than the sampling frequency")
    sampling_frequency = Quantity(51200.0, (10.0, 1e7), "Hz", "Sampling frequency", ("kHz", 1e-3))
    lags = Count(256, (2, 65536), "Lags of the kernel at the sampling frequency", "samples")
    tolerance = Quantity(
        1e-10, (1e-13, 1e-3), "", "Largest residual, per largest indentation", ("1e-10", 1e10)
    )
    max_iterations = Count(50, (1, 1000), "Newton iterations allowed in a step; 10 in the thesis")
    initial_guess = Choice(
        "extrapolated",
        ["extrapolated", "last"],
        "First guess: from the last two steps, or the last",
    )


class Scenario(Part):
    """All settings of a run.

    Parts are attributes (`scenario.loading.rate`), or keyword arguments of dictionaries:
    `Scenario(loading={"rate": 0.01}, numerics={"kernel": "static"})`.

    Raises
    ------
    InputError : an unknown part or setting, or a value that is out of bounds or of a wrong kind.
    """

    road = Group(Road)
    springs = Group(Springs)
    tread = Group(Tread)
    loading = Group(Loading)
    adhesion = Group(Adhesion)
    numerics = Group(Numerics)

    PARTS = ("road", "springs", "tread", "loading", "adhesion", "numerics")

    def __init__(self, /, **parts: Mapping[str, Any]) -> None:
        super().__init__()
        for part, values in parts.items():
            if part not in self.PARTS:
                raise unknown_name("part of a scenario", part, self.PARTS)
            if not isinstance(values, Mapping):
                raise InputError(f"{part} must be a table of settings, got {values!r}")
            for name, value in values.items():
                self.set(f"{part}.{name}", value)

    def set(self, path: str, value: Any) -> None:
        """Set one setting by its path, such as "loading.rate"; a text is parsed."""
        part, parameter = self.find(path)
        if isinstance(value, str):
            value = parsed(parameter, value)
        setattr(part, path.partition(".")[2], value)

    def find(self, path: str) -> tuple[Part, param.Parameter]:
        """The part and the declaration of a setting, from its path."""
        part_name, _, name = path.partition(".")
        if part_name not in self.PARTS:
            raise unknown_name("part of a scenario", part_name, self.PARTS)
        part = getattr(self, part_name)
        names = [known for known in part.param if known != "name"]
        if name not in names:
            raise unknown_name(f"setting of {part_name}", name, names)
        return part, part.param[name]

    def settings(self) -> Iterator[tuple[str, param.Parameter, Any]]:
        """Every setting: path, declaration, value."""
        for part_name in self.PARTS:
            part = getattr(self, part_name)
            for name in part.param:
                if name != "name":
                    yield f"{part_name}.{name}", part.param[name], getattr(part, name)

    def to_dict(self) -> dict[str, dict[str, Any]]:
        """Nested plain values; `Scenario(**scenario.to_dict())` is an equal scenario."""
        result: dict[str, dict[str, Any]] = {part: {} for part in self.PARTS}
        for path, _, value in self.settings():
            part, _, name = path.partition(".")
            result[part][name] = value
        return result

    def copy(self) -> Scenario:
        """An equal scenario that shares nothing with this one."""
        return Scenario(**self.to_dict())


def read_tables(path: Path) -> dict[str, Any]:
    """The tables of a TOML file.

    Raises
    ------
    InputError : a file that is absent or not TOML.
    """
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"scenario file must be readable, got {path}: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(f"scenario file must be TOML, got {path}: {error}") from None
