"""Settings of the tread: its layers and what they are made of."""

from __future__ import annotations

from tyrecontact.settings import Choice, Part, Quantity

_MM, _MPA = ("mm", 1e3), ("MPa", 1e-6)


class Tread(Part):
    """Two layers on a rigid base (thesis, Appendix B)."""

    material = Choice(
        "fractional-kelvin-voigt",
        ["fractional-kelvin-voigt", "fractional-zener", "tabulated"],
        "Law of the tread's modulus; tabulated is the thesis' and serves the band-limited kernel",
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
    density = Quantity(1300.0, (1.0, 3e4), "kg/m3", "Density of the tread")
    thickness = Quantity(10e-3, (0.1e-3, 0.2), "m", "Thickness of the tread", _MM)
    base_modulus = Quantity(72e9, (1e5, 1e13), "Pa", "Young's modulus of the base", ("GPa", 1e-9))
    base_loss_factor = Quantity(5e-5, (0.0, 0.09), "", "Loss factor of the base", ("1e-5", 1e5))
    base_poissons_ratio = Quantity(0.33, (-0.9, 0.4999), "", "Poisson's ratio of the base")
    base_density = Quantity(2700.0, (1.0, 3e4), "kg/m3", "Density of the base")
    base_thickness = Quantity(3e-3, (1e-5, 0.2), "m", "Thickness of the base", _MM)
