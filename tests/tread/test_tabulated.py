"""A modulus as a table: read, interpolated, refused off the imaginary axis, and not causal."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tyrecontact.errors import InputError
from tyrecontact.tread.kernels import band_limited, passive, passive_mobility, static
from tyrecontact.tread.materials import FractionalZener, Layer, Modulus
from tyrecontact.tread.tabulated import APPENDIX_B, Tabulated, read_table

TABLE = Tabulated((10.0, 1e3, 1e5), (1e7, 2e7, 8e7), (0.01, 0.1, 0.2))


def at(modulus: Modulus, frequency: float | np.ndarray) -> np.ndarray:
    return modulus(2j * np.pi * np.asarray(frequency))


def test_the_thesis_tread_meets_every_number_that_is_printed() -> None:
    low, high = at(APPENDIX_B, 10.0), at(APPENDIX_B, 50e3)
    assert complex(APPENDIX_B(np.array(0.0))) == pytest.approx(25e6, rel=1e-14)
    assert [low.imag / low.real, high.imag / high.real] == pytest.approx([0.005, 0.55])
    assert [high.real, at(APPENDIX_B, 1e6).real] == pytest.approx([50e6, 50e6])


def test_rows_are_met_and_lines_are_straight_in_logarithms_between() -> None:
    found = at(TABLE, np.array([10.0, 100.0, 1e3, 1e4, 1e5]))
    storage = [1e7, np.sqrt(2) * 1e7, 2e7, 4e7, 8e7]
    loss = [0.01, np.sqrt(1e-3), 0.1, np.sqrt(0.02), 0.2]
    np.testing.assert_allclose(found.real, storage, rtol=1e-12)  # rounding
    np.testing.assert_allclose(found.imag / found.real, loss, rtol=1e-12)


def test_beyond_the_rows_the_modulus_is_real_at_rest_and_stays_at_the_top() -> None:
    slow = at(TABLE, np.array([0.0, 1.0, 5.0]))
    np.testing.assert_allclose(slow.real, 1e7, rtol=1e-12)
    np.testing.assert_allclose(slow.imag / slow.real, [0, 1e-3, 5e-3], rtol=1e-12)
    np.testing.assert_allclose(at(TABLE, 1e9), 8e7 * (1 + 0.2j), rtol=1e-12)
    assert np.array_equal(at(TABLE, -100.0), at(TABLE, 100.0).conj())


@pytest.mark.parametrize("s", [1.0, 1e5 + 1e4j, -1j + 1e-3, np.array([0.0, 1j, 1.0])])
def test_complex_frequencies_are_refused_with_the_reason(s: complex) -> None:
    with pytest.raises(InputError, match="not causal and has no continuation to complex s"):
        TABLE(np.asarray(s))


def test_kernels_take_a_table_where_they_ask_along_the_imaginary_axis() -> None:
    layers, rest = [Layer(0.01, 1300, APPENDIX_B, 0.499)], ((2, 2), 1e-3, 1 / 51200, 32)
    for method in (band_limited, passive_mobility):
        assert np.isfinite(method(layers, *rest).values).all()
    assert static(layers, (2, 2), 1e-3).values[0, 0, 0] > 0
    with pytest.raises(InputError, match="not causal"):
        passive(layers, *rest)


def rise_by_kramers_and_kronig(modulus: Modulus, frequency: float) -> float:
    """E'(w) - E'(0) that causality asks for, from E'' (as in test_materials.py)."""
    step, w = 0.01, 2 * np.pi * frequency
    octave = (np.arange(4000) + 0.5) * step
    below, above = (np.imag(modulus(1j * w * np.exp(sign * octave))) for sign in (-1, 1))
    integrand = (below + above + (below - above) / np.tanh(octave)) / 2
    return float(2 / np.pi * integrand.sum() * step)


def test_a_table_made_from_a_causal_material_stays_causal_between_its_rows() -> None:
    """The check itself: 120 rows of a Zener solid pass it, over fourteen decades."""
    zener = FractionalZener(25e6, 50e6, 1e-5, 0.8)
    frequency = np.geomspace(1e-4, 1e12, 160)
    values = at(zener, frequency)
    table = Tabulated(
        tuple(frequency), tuple(values.real), tuple(np.maximum(values.imag / values.real, 1e-12))
    )
    rise = float(at(table, 1e4).real - 25e6)
    # straight lines between ten rows a decade: 1 %
    assert rise_by_kramers_and_kronig(table, 1e4) == pytest.approx(rise, rel=0.02)


@pytest.mark.parametrize("frequency", [1e3, 1e4])
def test_the_thesis_tread_is_not_causal(frequency: float) -> None:
    """Its losses ask for a stiffening that its storage modulus does not show."""
    rise = float(at(APPENDIX_B, frequency).real - 25e6)
    asked = rise_by_kramers_and_kronig(APPENDIX_B, frequency)
    assert abs(asked - rise) > 0.2 * rise


def test_no_causal_material_from_25_to_50_mpa_loses_as_much_as_the_thesis_says() -> None:
    """The largest loss factor there is, is a Zener solid's: 0.354 against 0.55."""
    zener = at(FractionalZener(25e6, 50e6, 1e-5, 1.0), np.geomspace(1e2, 1e7, 5000))
    largest = (zener.imag / zener.real).max()
    assert largest == pytest.approx(25 / (2 * np.sqrt(25 * 50)), rel=1e-5)  # the grid
    assert largest < APPENDIX_B.loss_factor[-1]


@pytest.mark.parametrize(
    ("columns", "sentence"),
    [
        (((1.0,), (1e7,), (0.1,)), "of one length, at least 2, got 1, 1, 1"),
        (((1.0, 2.0), (1e7,), (0.1, 0.1)), "of one length, at least 2, got 2, 1, 2"),
        (((2.0, 1.0), (1e7, 1e7), (0.1, 0.1)), "must rise from row to row, got 1 after 2 in row 2"),
        (((1.0, 1.0), (1e7, 1e7), (0.1, 0.1)), "must rise"),
        (((0.0, 1.0), (1e7, 1e7), (0.1, 0.1)), r"frequency \[Hz\] .* got 0 in row 1"),
        (((1.0, 2.0), (1e7, np.nan), (0.1, 0.1)), r"storage modulus \[Pa\] .* got nan in row 2"),
        (((1.0, 2.0), (1e7, 1e7), (-0.1, 0.1)), "loss factor .* must be positive .* -0.1 in row 1"),
    ],
)
def test_columns_that_are_no_modulus_are_refused(columns: tuple, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        Tabulated(*columns)


@pytest.mark.parametrize(
    "text",
    ["10 1e7 .01\n1000 2e7 .1\n1e5 8e7 .2\n", "\ufeff# f, E', eta\n10, 1e7, .01\n1e3,2e7,.1\n"
     "1e5,\t8e7, 0.2  # last\n"],
)  # fmt: skip
def test_a_table_is_read_from_text(tmp_path: Path, text: str) -> None:
    (tmp_path / "table.txt").write_text(text, "utf-8")
    assert read_table(tmp_path / "table.txt") == TABLE


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"", "three columns, .* got 0 in"),
        (b"# nothing\n", "three columns"),
        (b"10 1e7\n20 1e7\n", "three columns, .* got 2 in"),
        (b"10 1e7 soft\n", "must hold numbers"),
        (b"10 1e7 0.1\n20 1e7\n", "must hold numbers"),
        (b"\xff\xfe\x00", "must hold numbers"),
        (b"10 1e7 0.1\n", "at least 2"),
        (b"10 1e7 0.1\n" * 200_000, "at most 2 MB"),
    ],
)
def test_a_file_that_is_no_table_is_refused(tmp_path: Path, content: bytes, sentence: str) -> None:
    (tmp_path / "table.txt").write_bytes(content)
    with pytest.raises(InputError, match=sentence) as caught:
        read_table(tmp_path / "table.txt")
    assert "\n" not in str(caught.value)


def test_a_file_that_cannot_be_read_is_refused_with_the_reason(tmp_path: Path) -> None:
    for path, reason in ((tmp_path / "none.txt", "No such file"), (tmp_path, "Is a directory")):
        with pytest.raises(InputError, match=f"modulus table must be readable, .* {reason}"):
            read_table(path)
    with pytest.raises(InputError, match="modulus table must be readable"):
        read_table("null\0byte")
