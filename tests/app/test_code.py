"""Script, command line and file give the scenario again, to the last digit."""

from __future__ import annotations

import json
import random
import subprocess
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import xarray as xr

import tyrecontact
from app import code
from tests.app.scenarios import LAYERS, random_scenario
from tyrecontact import Scenario, Simulation, __main__, presets
from tyrecontact.errors import TyreContactError


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Scenario]]:
    """Scenarios that the library was asked to run, none of which is run."""
    seen: list[Scenario] = []

    def refuse(scenario: Scenario) -> None:
        seen.append(scenario)
        raise TyreContactError("not run in this test")

    monkeypatch.setattr(tyrecontact, "Simulation", refuse)
    monkeypatch.setattr(__main__, "Simulation", refuse)
    return seen


def words_of(command: str) -> list[str]:
    """Arguments that a shell makes of a command."""
    script = f"tyrecontact() {{ printf '%s\\0' \"$@\"; }}\n{command}"
    out = subprocess.run(["sh", "-c", script], capture_output=True, check=True).stdout
    return out.decode().split("\0")[:-1]


def all_three(preset: str, scenario: Scenario, asked: list[Scenario], folder: Path) -> list[dict]:
    """What script, command line and file ask for."""
    with pytest.raises(TyreContactError, match="not run in this test"):
        exec(code.python(preset, scenario), {})
    assert __main__.main(words_of(code.command_line(preset, scenario))) == 2
    (folder / "my.toml").write_text(code.toml(preset, scenario), encoding="utf-8")
    assert __main__.main(["run", str(folder / "my.toml")]) == 2
    return [found.to_dict() for found in asked]


EVERY = [*presets.names(), "fig-44/14-N"]


@pytest.mark.parametrize("name", EVERY)
def test_a_preset_is_its_name(name: str, asked: list[Scenario], tmp_path: Path) -> None:
    scenario = presets.get(name)
    assert code.changes(name, scenario) == {}
    assert "scenario.set" not in code.python(name, scenario)
    assert all_three(name, scenario, asked, tmp_path) == [scenario.to_dict()] * 3


@pytest.mark.parametrize("seed", range(8))
def test_any_scenario_is_given_exactly(seed: int, asked: list[Scenario], tmp_path: Path) -> None:
    scenario = random_scenario(random.Random(seed))
    scenario.tread.layers = LAYERS if seed % 2 else []
    scenario.road.file = ["", '/data/it\'s a "road" $HOME.npy', "C:\\roads\\über `x`.txt"][seed % 3]
    name = EVERY[seed]
    assert all_three(name, scenario, asked, tmp_path) == [scenario.to_dict()] * 3


def test_the_script_runs_and_writes_the_run(
    small: Scenario, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    exec(code.python("default", small), {})
    expected = Simulation(small).run().to_xarray()
    with xr.open_dataset(code.OUTPUT) as written:
        xr.testing.assert_equal(written, expected)
    Path(code.OUTPUT).unlink()
    assert __main__.main(words_of(code.command_line("default", small))) == 0
    with xr.open_dataset(code.OUTPUT) as written:
        xr.testing.assert_equal(written, expected)
        assert json.loads(written.attrs["scenario"]) == small.to_dict()


def test_each_change_is_a_line_of_its_own(small: Scenario) -> None:
    lines = code.python("default", small).splitlines()
    assert 'scenario = tc.presets.get("default")' in lines
    assert 'scenario.set("road.elements", 6)' in lines
    assert 'scenario.set("loading.rate", 0.1)' in lines
    assert sum(line.startswith("scenario.set(") for line in lines) == 6
    assert "  --set loading.rate=0.1 \\" in code.command_line("default", small).splitlines()


def test_the_file_says_only_what_differs(small: Scenario) -> None:
    tables = tomllib.loads(code.toml("adhesion", presets.get("adhesion")))
    assert tables == {"preset": "adhesion"}
    tables = tomllib.loads(code.toml("default", small))
    assert tables["road"] == {"size": 6e-3, "elements": 6, "pixel": 5e-5}


def test_layers_stand_in_the_script_as_tables() -> None:
    scenario = Scenario(tread={"layers": LAYERS})
    script = code.python("default", scenario)
    assert 'scenario.set(\n    "tread.layers",\n    [{' in script
    assert all(len(line) <= 100 for line in script.splitlines())


def test_folders_of_the_server_are_told_nobody() -> None:
    scenario = Scenario(
        road={"file": "/tmp/secret/A12 lane 1.npy"}, loading={"table": "/tmp/secret/a.txt"}
    )
    scenario.tread.layers = [{**LAYERS[1], "modulus_table": "/tmp/secret/rubber.txt"}]
    bare = code.without_folders(scenario)
    assert code.files(bare) == {
        "road.file": "A12 lane 1.npy",
        "loading.table": "a.txt",
        "layer 1 of tread.layers": "rubber.txt",
    }
    assert scenario.road.file == "/tmp/secret/A12 lane 1.npy"
    for text in (code.python("default", bare), code.toml("default", bare)):
        assert text.count("give the path of your copy") == 3
        assert "secret" not in text
    assert code.without_folders(Scenario()).to_dict() == Scenario().to_dict()


def test_an_unknown_preset_is_refused() -> None:
    with pytest.raises(TyreContactError, match="did you mean 'adhesion'"):
        code.python("adhesoin", Scenario())


def test_values_of_every_kind_are_read_as_they_were() -> None:
    changes: dict[str, Any] = {
        "loading.rate": 1 / 3, "numerics.kernel": "static", "road.seed": 2**32 - 1,
        "road.height_unit": "um",
    }  # fmt: skip
    scenario = Scenario()
    for path, value in changes.items():
        scenario.set(path, value)
    assert code.changes("default", scenario) == changes
