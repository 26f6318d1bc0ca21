"""From settings to the layers of the tread."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact import Scenario, Simulation, assembly
from tyrecontact.errors import InputError
from tyrecontact.parts.tread import Tread
from tyrecontact.tread.materials import (
    FractionalKelvinVoigt,
    FractionalZener,
    Layer,
    NearlyConstantLoss,
)
from tyrecontact.tread.tabulated import APPENDIX_B, Tabulated

ROAD = {"elements": 6, "size": 6e-3, "pixel": 5e-5}


def small(**numerics: object) -> Scenario:
    return Scenario(road=ROAD, numerics={"lags": 16, **numerics})


LAYERS = [
    {"thickness": 2e-3, "density": 1200, "poissons_ratio": 0.49, "material": "fractional-zener",
     "static_modulus": 5e6, "glassy_modulus": 5e8, "exponent": 0.6, "relaxation_time": 1e-7},
    {"thickness": 6e-3, "density": 1100, "poissons_ratio": 0.48,
     "material": "fractional-kelvin-voigt", "static_modulus": 8e6, "exponent": 0.5,
     "relaxation_time": 1e-6},
    {"thickness": 1e-3, "density": 7800, "poissons_ratio": 0.3,
     "material": "nearly-constant-loss", "youngs_modulus": 2.1e11, "loss_factor": 1e-3},
]  # fmt: skip


def test_layers_carry_the_settings_from_the_top_down() -> None:
    top, base = assembly.tread_layers(Tread(static_modulus=1e7, base_thickness=2e-3, density=999))
    assert (top.thickness, top.density, top.poissons_ratio) == (10e-3, 999, 0.499)
    assert (base.thickness, base.density, base.poissons_ratio) == (2e-3, 2700, 0.33)
    assert top.modulus(np.array(0.0)) == 1e7
    assert base.modulus(np.array(0.0)) == 72e9
    slower = assembly.tread_layers(Tread(static_modulus=1e7, relaxation_time=1e-5))[0]
    assert abs(slower.modulus(1e4j)) > abs(top.modulus(1e4j))


def test_the_material_is_chosen_by_name() -> None:
    zener = Tread(material="fractional-zener", glassy_modulus=6e7, exponent=0.5)
    found = assembly.tread_layers(zener)[0].modulus
    assert found == FractionalZener(25e6, 6e7, 3.717e-6, 0.5)
    assert assembly.tread_layers(Tread(material="tabulated"))[0].modulus is APPENDIX_B
    assert assembly.tread_layers(Tread())[0].modulus == FractionalKelvinVoigt()


def test_a_table_of_ones_own_is_read(tmp_path: Path) -> None:
    (tmp_path / "modulus.csv").write_text("# f, E', eta\n10, 1e7, 0.02\n1e4, 3e7, 0.4\n")
    tread = Tread(material="tabulated", modulus_table=str(tmp_path / "modulus.csv"))
    expected = Tabulated((10.0, 1e4), (1e7, 3e7), (0.02, 0.4))
    assert assembly.tread_layers(tread)[0].modulus == expected


def test_any_number_of_layers_takes_the_place_of_the_two() -> None:
    assert assembly.tread_layers(Tread(layers=LAYERS)) == [
        Layer(2e-3, 1200, FractionalZener(5e6, 5e8, 1e-7, 0.6), 0.49),
        Layer(6e-3, 1100, FractionalKelvinVoigt(8e6, 1e-6, 0.5), 0.48),
        Layer(1e-3, 7800, NearlyConstantLoss(2.1e11, 1e-3), 0.3),
    ]
    layered = Scenario(road=ROAD, tread={"layers": LAYERS}, numerics={"lags": 32})
    kernel = assembly.tread_kernel(layered)
    two = assembly.tread_kernel(small(lags=32))
    # the top is five times as soft
    assert kernel.static_compliance[0, 0] > 3 * two.static_compliance[0, 0]


def test_the_two_layers_may_be_written_as_tables() -> None:
    tables = [
        {"thickness": 10e-3, "density": 1300.0, "poissons_ratio": 0.499,
         "material": "fractional-kelvin-voigt", "static_modulus": 25e6, "exponent": 0.6091,
         "relaxation_time": 3.717e-6},
        {"thickness": 3e-3, "density": 2700.0, "poissons_ratio": 0.33,
         "material": "nearly-constant-loss", "youngs_modulus": 72e9, "loss_factor": 5e-5},
    ]  # fmt: skip
    assert assembly.tread_layers(Tread(layers=tables)) == assembly.tread_layers(Tread())


@pytest.mark.parametrize(
    ("tread", "numerics", "sentence"),
    [
        ({"material": "tabulated"}, {}, "numerics.kernel must be band-limited, .* is not causal"),
        ({"layers": [{**LAYERS[2], "material": "tabulated"}]}, {}, "layer 1 of tread.layers: "),
        ({"material": "fractional-zener", "static_modulus": 6e7}, {}, "glassy_modulus must be at"),
        (
            {"layers": [LAYERS[2], {**LAYERS[0], "glassy_modulus": 1e6}]},
            {},
            "layer 2 of tread.layers: glassy_modulus must be at least static_modulus, 5e.06 Pa",
        ),
        (
            {"layers": [{**LAYERS[0], "thickness": 1e-4}]},
            {},
            "less than the thickness of tread.layers, 0.0001 m, got 0.0002 m",
        ),
        ({"material": "tabulated", "modulus_table": "none.txt"}, {}, "table must be readable"),
        ({"layers": LAYERS[1:]}, {"lags": 10}, "numerics.lags must cover the ringing"),
    ],
)
def test_treads_that_cannot_be_are_refused_before_the_run(
    tread: dict[str, object], numerics: dict[str, object], sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        Simulation(Scenario(road=ROAD, tread=tread, numerics=numerics))
