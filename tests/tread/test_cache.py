"""Kernels on disk: read where they are sound, built anew where they are not."""

from __future__ import annotations

import gc
import io
import os
import pickle
import warnings
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest

from tyrecontact.tread import cache, kernels
from tyrecontact.tread.kernels import Kernel
from tyrecontact.tread.materials import FractionalKelvinVoigt, Layer, NearlyConstantLoss

RUBBER = Layer(0.01, 1300, FractionalKelvinVoigt(), 0.499)
BASE = Layer(0.003, 2700, NearlyConstantLoss(72e9, 5e-5), 0.33)
LAYERS = [RUBBER, BASE]
TIMED = (LAYERS, (2, 3), 1e-3, 1 / 51200, 8)
FREQUENCY = np.array([0.0, 1e3j, 1e5 + 1e4j])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache."""
    monkeypatch.setenv("TYRECONTACT_CACHE", str(tmp_path / "new" / "kernels"))
    return cache.directory()


@pytest.fixture(scope="module")
def made() -> dict[str, Kernel]:
    timed = {
        name: getattr(kernels, name)(*TIMED)
        for name in ("passive", "passive_mobility", "band_limited")
    }
    return {**timed, "static": kernels.static(*TIMED[:3])}


@pytest.fixture
def built(monkeypatch: pytest.MonkeyPatch, made: dict[str, Kernel]) -> list[str]:
    """Names of the kernels that were asked to be computed, as they are; none is."""
    calls: list[str] = []
    for name, kernel in made.items():
        counted = partial(lambda name, kernel, *_: calls.append(name) or kernel, name, kernel)
        monkeypatch.setattr(kernels, name, counted)
    return calls


@pytest.fixture
def file(folder: Path, built: list[str]) -> Path:
    """The file of the passive kernel, just written."""
    cache.passive(*TIMED)
    built.clear()
    (path,) = folder.iterdir()
    return path


def assert_same(one: Kernel, other: Kernel) -> None:
    np.testing.assert_array_equal(one.values, other.values)
    assert (one.spacing, one.time_step) == (other.spacing, other.time_step)


def saved(save: Callable[..., None], *values: Any, **named: Any) -> bytes:
    content = io.BytesIO()
    save(content, *values, **named)
    return content.getvalue()


def test_each_kernel_is_computed_once(
    folder: Path, built: list[str], made: dict[str, Kernel]
) -> None:
    for _ in range(3):
        assert_same(cache.passive(*TIMED), made["passive"])
        assert_same(cache.band_limited(*TIMED), made["band_limited"])
        assert_same(cache.passive_mobility(*TIMED), made["passive_mobility"])
        assert_same(cache.static(*TIMED[:3]), made["static"])
        cache.passive([RUBBER], *TIMED[1:])
    assert built == ["passive", "band_limited", "passive_mobility", "static", "passive"]
    assert [path.suffix for path in folder.iterdir()] == [".npz"] * 5


def test_quadratures_are_told_apart_though_the_modulus_is_constant(folder: Path) -> None:
    elastic = ([BASE], *TIMED[1:])
    for quadrature in ("BDF1", "BDF2", "BDF1"):
        assert_same(cache.passive(*elastic, quadrature), kernels.passive(*elastic, quadrature))
    assert len(list(folder.iterdir())) == 2


def assert_replaced(file: Path, built: list[str]) -> None:
    """The file as it stands is not believed, and a sound one takes its place."""
    built.clear()
    first, second = (cache.passive(*TIMED) for _ in range(2))
    assert built == ["passive"]
    assert_same(first, kernels.passive(*TIMED))
    assert_same(second, first)
    assert list(file.parent.iterdir()) == [file]


def test_a_file_that_is_cut_off_is_replaced(file: Path, built: list[str]) -> None:
    whole = file.read_bytes()
    for length in (0, 1, 100, len(whole) // 2, len(whole) - 1):
        file.write_bytes(whole[:length])
        assert_replaced(file, built)


def test_a_file_with_a_wrong_bit_in_its_values_is_replaced(file: Path, built: list[str]) -> None:
    """Where the archive's own check meets it, and where only the digest does."""
    sound, values = file.read_bytes(), kernels.passive(*TIMED).values.tobytes()
    with np.load(file) as stored:
        arrays = dict(stored)
    for place in (0, 1, 7, 100, len(values) - 1):
        wrong = bytearray(values)
        wrong[place] ^= 1
        file.write_bytes(sound.replace(values, wrong))
        assert_replaced(file, built)
        arrays["values"] = np.frombuffer(wrong).reshape(8, 2, 3)
        file.write_bytes(saved(np.savez, **arrays))
        assert_replaced(file, built)


def test_the_file_of_another_kernel_is_replaced(folder: Path, file: Path, built: list[str]) -> None:
    cache.band_limited(*TIMED)
    (other,) = set(folder.iterdir()) - {file}
    other.replace(file)
    assert_replaced(file, built)


FOREIGN = {
    "random": np.random.default_rng(1).bytes(1000),
    "text": b"not a kernel\n",
    "array": saved(np.save, np.ones((8, 2, 3))),
    "pickle": pickle.dumps({"values": [1]}),
    "archive": saved(np.savez, values=np.ones((8, 2, 3))),
    "objects": saved(np.savez, fingerprint=np.array([{}], object), values=np.ones(1)),
}


@pytest.mark.parametrize("content", FOREIGN.values(), ids=FOREIGN)
def test_a_file_that_is_not_ours_is_replaced(file: Path, built: list[str], content: bytes) -> None:
    file.write_bytes(content)
    assert_replaced(file, built)


def test_nothing_is_unpickled(file: Path, built: list[str], tmp_path: Path) -> None:
    target = tmp_path / "sprung"
    trap = type("Trap", (), {"__reduce__": lambda _: (os.mkdir, (str(target),))})()
    for content in (pickle.dumps(trap), saved(np.savez, fingerprint=np.array(trap, object))):
        file.write_bytes(content)
        assert_replaced(file, built)
    assert not target.exists()


@pytest.mark.parametrize("flags", [b"\1", b"\0\0\x63"], ids=["encrypted", "unknown method"])
def test_a_wrong_byte_in_the_archive_is_met(file: Path, built: list[str], flags: bytes) -> None:
    whole = bytearray(file.read_bytes())
    place = whole.index(b"PK\1\2") + 8
    whole[place : place + len(flags)] = flags
    file.write_bytes(whole)
    assert_replaced(file, built)


def test_a_damaged_file_is_closed(file: Path) -> None:
    file.write_bytes(file.read_bytes()[:500])
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        cache.passive(*TIMED)
        gc.collect()
    assert not caught


def test_a_folder_that_cannot_be_made_costs_time_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, built: list[str]
) -> None:
    (tmp_path / "regular").write_text("a file")
    monkeypatch.setenv("TYRECONTACT_CACHE", str(tmp_path / "regular" / "kernels"))
    assert_same(cache.passive(*TIMED), cache.passive(*TIMED))
    assert built == ["passive", "passive"]


@pytest.mark.parametrize("error", [OSError, KeyboardInterrupt])
def test_a_write_that_fails_leaves_no_part_behind(
    folder: Path, monkeypatch: pytest.MonkeyPatch, error: type[BaseException]
) -> None:
    monkeypatch.setattr(np, "savez", Mock(side_effect=error))
    with suppress(KeyboardInterrupt):
        cache.passive(*TIMED)
    assert list(folder.iterdir()) == []


def test_the_users_cache_is_the_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TYRECONTACT_CACHE")
    assert cache.directory().parts[-2:] == ("tyrecontact", "kernels")


def key(method: str = "passive", layers: Any = LAYERS, **changed: Any) -> str:
    rest = {"shape": (2, 3), "spacing": 1e-3, "time_step": 1e-5, "lags": 8, **changed}
    return cache.fingerprint(method, layers, laplace_frequency=FREQUENCY, **rest)


def test_the_fingerprint_knows_all_that_a_kernel_depends_on() -> None:
    flatter, stiffer = FractionalKelvinVoigt(exponent=0.6), NearlyConstantLoss(73e9, 5e-5)
    changed = [{"thickness": 0.011}, {"density": 1301}, {"poissons_ratio": 0.498}]
    changed += [{"modulus": flatter}, {"modulus": FractionalKelvinVoigt(relaxation_time=3.7e-6)}]
    keys = [key(layers=[replace(RUBBER, **change), BASE]) for change in changed]
    keys += [key(layers=[RUBBER, replace(BASE, modulus=stiffer)]), key(layers=LAYERS[::-1])]
    keys += [key(layers=[RUBBER]), key(method="static"), key(), key(shape=(3, 2)), key(lags=9)]
    keys += [key(spacing=1.001e-3), key(time_step=1.001e-5)]
    assert len(set(keys)) == len(keys) == 14


def test_the_fingerprint_knows_a_modulus_by_its_values() -> None:
    same = partial(FractionalKelvinVoigt.__call__, FractionalKelvinVoigt())
    assert key(layers=[replace(RUBBER, modulus=same), BASE]) == key()
