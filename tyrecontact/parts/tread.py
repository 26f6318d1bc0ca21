"""Settings of the tread: its layers and what they are made of."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tyrecontact.errors import InputError
from tyrecontact.settings import Choice, Part, Quantity, Tables, Text

_MM, _MPA = ("mm", 1e3), ("MPa", 1e-6)
_MODULUS = (1e4, 1e13)


class Layer(Part):
    """One table of `tread.layers`: what every layer has, and the parameters of its material."""

    thickness = Quantity(10e-3, (1e-6, 0.2), "m", "Thickness")
    density = Quantity(1300.0, (1.0, 3e4), "kg/m³", "Density")
    poissons_ratio = Quantity(0.499, (-0.9, 0.4999), "", "Poisson's ratio")
    material = Choice(
        "fractional-kelvin-voigt",
        ["fractional-kelvin-voigt", "fractional-zener", "nearly-constant-loss", "tabulated"],
        "Law of the layer's modulus",
    )
    static_modulus = Quantity(25e6, _MODULUS, "Pa", "Young's modulus at rest (fractional)")
    glassy_modulus = Quantity(50e6, _MODULUS, "Pa", "At high frequency (fractional Zener)")
    exponent = Quantity(0.6091, (0.05, 1.0), "", "Exponent (fractional)")
    relaxation_time = Quantity(3.717e-6, (1e-12, 1.0), "s", "Time constant (fractional)")
    youngs_modulus = Quantity(72e9, _MODULUS, "Pa", "Young's modulus (nearly constant loss)")
    loss_factor = Quantity(5e-5, (0.0, 0.09), "", "Loss factor (nearly constant loss)")
    modulus_table = Text("", "File of the modulus; none: the thesis' Appendix B (tabulated)")


#: what a layer must tell, by its material
_OF_ALL = ("thickness", "density", "poissons_ratio", "material")
_OF_MATERIAL = {
    "fractional-kelvin-voigt": ("static_modulus", "exponent", "relaxation_time"),
    "fractional-zener": ("static_modulus", "glassy_modulus", "exponent", "relaxation_time"),
    "nearly-constant-loss": ("youngs_modulus", "loss_factor"),
    "tabulated": ("modulus_table",),
}


def _layer(table: Mapping[str, Any]) -> dict[str, Any]:
    """A table of `tread.layers` checked: every setting known, in bounds, needed, and there."""
    layer = Layer(**{str(name): value for name, value in table.items()})
    needed = _OF_ALL + _OF_MATERIAL[layer.material] if "material" in table else _OF_ALL
    for name in needed:
        if name not in table:
            raise InputError(f"{name} must be given, got {', '.join(table) or 'nothing'}")
    for name in table:
        if name not in needed:
            raise InputError(
                f"settings of a {layer.material} layer must be {', '.join(needed)}, got {name}"
            )
    return {name: getattr(layer, name) for name in needed}


class Tread(Part):
    """Two layers on a rigid base (thesis, Appendix B), or any number of them."""

    material = Choice(
        "fractional-kelvin-voigt",
        ["fractional-kelvin-voigt", "fractional-zener", "tabulated"],
        "Law of the tread's modulus; tabulated (thesis) is not causal: not for the passive kernel",
    )
    modulus_table = Text(
        "", "Text file of f [Hz], E' [Pa], loss factor (tabulated); none: the thesis' Appendix B"
    )
    static_modulus = Quantity(25e6, (1e4, 1e12), "Pa", "Young's modulus at rest", _MPA)
    glassy_modulus = Quantity(
        50e6, (1e4, 1e13), "Pa", "Young's modulus at high frequency (Zener)", _MPA
    )
    exponent = Quantity(0.6091, (0.05, 1.0), "", "Exponent of the fractional laws")
    relaxation_time = Quantity(
        3.717e-6, (1e-12, 1.0), "s", "Time constant of the fractional laws", ("µs", 1e6)
    )
    poissons_ratio = Quantity(0.499, (-0.9, 0.4999), "", "Poisson's ratio of the tread")
    density = Quantity(1300.0, (1.0, 3e4), "kg/m³", "Density of the tread")
    thickness = Quantity(10e-3, (0.1e-3, 0.2), "m", "Thickness of the tread", _MM)
    base_modulus = Quantity(72e9, (1e5, 1e13), "Pa", "Young's modulus of the base", ("GPa", 1e-9))
    base_loss_factor = Quantity(5e-5, (0.0, 0.09), "", "Loss factor of the base", ("1e-5", 1e5))
    base_poissons_ratio = Quantity(0.33, (-0.9, 0.4999), "", "Poisson's ratio of the base")
    base_density = Quantity(2700.0, (1.0, 3e4), "kg/m³", "Density of the base")
    base_thickness = Quantity(3e-3, (1e-5, 0.2), "m", "Thickness of the base", _MM)
    layers = Tables(
        "layer",
        _layer,
        "Any number of layers from the top down, instead of tread and base; none: those two",
    )
