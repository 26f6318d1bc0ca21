"""The command line: what it prints, what it writes, and how it refuses."""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest
import xarray as xr

from tyrecontact import Scenario, Simulation, presets, simulation, thesis
from tyrecontact.__main__ import main
from tyrecontact.thesis.findings import Claim

QUICK = ["road.elements=6", "road.size=6e-3", "road.pixel=5e-5", "numerics.lags=32"]
QUICK += ["loading.max_indentation=1e-4", "loading.rate=0.1024"]

Capture = pytest.CaptureFixture[str]


def quickly(*arguments: str) -> list[str]:
    """Arguments of a run with the settings of the `quick` scenario."""
    name, *rest = arguments
    return ["run", name, *(word for change in QUICK for word in ("--set", change)), *rest]


def printed(capsys: Capture, arguments: list[str]) -> dict[str, Any]:
    """The one JSON object that a run with --json must print, and nothing else."""
    assert main([*arguments, "--json"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    return json.loads(out)


def refused(capsys: Capture, arguments: list[str]) -> str:
    """The one line on stderr with which a call must be refused."""
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("tyrecontact: ")
    assert err.count("\n") == 1
    return err


@pytest.fixture
def _never_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """A run that must be refused before it begins fails at its first step."""
    monkeypatch.setattr(simulation, "advance", None)


def test_presets_are_listed_with_their_captions(capsys: Capture) -> None:
    assert main(["presets"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == presets.names()
    for line, name in zip(lines, presets.names(), strict=True):
        assert line.endswith(presets.caption(name))


def test_describe_tells_every_setting_with_default_unit_bounds_and_meaning(capsys: Capture) -> None:
    assert main(["describe"]) == 0
    out = capsys.readouterr().out
    for path, parameter, _ in Scenario().settings():
        assert f"{path} = " in out
        assert parameter.doc in out
    assert "loading.rate = 0.03 m/s  [0.0001 to 10]" in out
    assert "numerics.kernel = passive  [passive | passive-mobility | band-limited | static]" in out
    assert "road.file = ''  [any text]" in out
    assert "tread.layers = []  [tables, as JSON]" in out


def test_json_is_the_summary_and_the_clocks(capsys: Capture, quick: Scenario) -> None:
    found = printed(capsys, quickly("default"))
    clocks = {name: found.pop(name) for name in ("wall_s", "kernel_s")}
    assert found == Simulation(quick).run().summary()
    assert 0 < clocks["kernel_s"] < clocks["wall_s"]


def test_a_run_is_told_in_words(capsys: Capture) -> None:
    assert main(quickly("default")) == 0
    out, err = capsys.readouterr()
    assert re.match(r"51 steps in \d+\.\d\d s: completed\n", out)
    assert all(what in out for what in ("largest force", "final stiffness", "Newton iterations"))
    assert err == ""
    changes = ["--set", "numerics.max_iterations=1", "--set", "numerics.solver=thesis"]
    assert main(quickly("default", *changes)) == 0
    assert "first step that did not converge: 1, at 0.020 ms" in capsys.readouterr().out


def test_a_terminal_shows_progress_and_stdout_stays_clean(
    capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    terminal = io.StringIO()
    monkeypatch.setattr(terminal, "isatty", lambda: True)
    monkeypatch.setattr(sys, "stderr", terminal)
    assert main(quickly("default", "--json")) == 0
    assert "/51" in terminal.getvalue()
    json.loads(capsys.readouterr().out)


def test_set_changes_one_setting_and_may_be_repeated(capsys: Capture) -> None:
    assert printed(capsys, quickly("default", "--set", "loading.rate = 0.2048"))["steps"] == 26
    last = quickly("default", "--set", "loading.rate=0.2048", "--set", "loading.rate=0.512")
    assert printed(capsys, last)["steps"] == 11


def test_a_file_names_a_preset_and_changes_it(capsys: Capture, tmp_path: Path) -> None:
    file, output = tmp_path / "my.toml", tmp_path / "run.nc"
    file.write_text('preset = "thesis-instability"\n[tread]\ndensity = 900\n', encoding="utf-8")
    printed(capsys, quickly(str(file), "--output", str(output)))
    with xr.open_dataset(output) as dataset:
        asked = json.loads(dataset.attrs["scenario"])
    expected = presets.get("thesis-instability")
    for change in [*QUICK, "tread.density=900"]:
        expected.set(*change.split("="))
    assert asked == expected.to_dict()


def test_a_file_without_a_preset_changes_the_default(capsys: Capture, tmp_path: Path) -> None:
    (tmp_path / "my.toml").write_text("[numerics]\nmax_iterations = 1\n", encoding="utf-8")
    found = printed(capsys, quickly(str(tmp_path / "my.toml")))
    assert "not converged" in found["stop_reason"]


def test_the_output_is_the_run(capsys: Capture, tmp_path: Path, quick: Scenario) -> None:
    output = tmp_path / "run.nc"
    printed(capsys, quickly("default", "--output", str(output)))
    with xr.open_dataset(output) as found:
        xr.testing.assert_equal(found, Simulation(quick).run().to_xarray())


def test_an_output_whose_maps_are_thinned_says_so(capsys: Capture, tmp_path: Path) -> None:
    output = tmp_path / "run.nc"
    memory = f"numerics.field_memory={20 * 36 * 33}"  # of 51 steps
    assert main(quickly("default", "--json", "--output", str(output), "--set", memory)) == 0
    out, err = capsys.readouterr()
    assert json.loads(out)["steps"] == 51
    assert err.startswith("tyrecontact: maps of every 4 steps and of the last are in ")
    with xr.open_dataset(output) as found:
        assert found["field_step"].to_numpy().tolist() == [*range(0, 49, 4), 50]
        assert found.sizes["time"] == 51


@pytest.mark.usefixtures("_never_run")
@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        (["defualt"], "did you mean 'default'?"),
        (["missing.toml"], "No such file or directory"),
        (["default", "--set", "loading.rate"], "--set must be given as part.name=value"),
        (["default", "--set", "loading.rate=-1"], "loading.rate must be a number between"),
        (["default", "--set", "loading.rate=fast"], "got 'fast'"),
        (["default", "--set", "loading.speed=1"], "setting of loading must be one of"),
        (["default", "--set", "lading.rate=1"], "did you mean 'loading'?"),
        (["default", "--set", "road.file=missing.npy"], "pitch must be given"),
        (["quasi-static", "--set", "loading.rate=10", "--set", "road.size=1"], "road.size must"),
        (["thesis-factor-4", "--set", "numerics.time_resolution_factor=3"], "must be 1, 2 or 4"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_what_cannot_be_run_is_refused_in_a_line(
    capsys: Capture, arguments: list[str], part: str
) -> None:
    assert part in refused(capsys, ["run", *arguments, "--json"])


TOO_LONG = pytest.param("x" * 300, id="too long")


def test_a_road_that_cannot_be_used_is_refused_before_a_kernel_is_made(
    capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = Mock(side_effect=AssertionError("a kernel was made"))
    monkeypatch.setattr("tyrecontact.assembly.tread_kernel", made)
    message = refused(capsys, quickly("default", "--set", "road.pixel=1e-3"))
    assert "pitch must give at least 4 heights" in message


@pytest.mark.usefixtures("_never_run")
@pytest.mark.parametrize("name", ["", "missing/run.nc", "link.nc", "regular/run.nc", TOO_LONG])
def test_an_output_that_cannot_be_written_is_refused_first(
    capsys: Capture, tmp_path: Path, name: str
) -> None:
    (tmp_path / "link.nc").symlink_to(tmp_path / "missing" / "run.nc")
    (tmp_path / "regular").write_text("a file")
    message = refused(capsys, quickly("default", "--output", str(tmp_path / name)))
    assert "--output must name a file that can be written" in message
    assert {path.name for path in tmp_path.iterdir()} == {"link.nc", "regular"}


def test_a_write_that_fails_leaves_the_older_file(
    capsys: Capture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "run.nc").write_text("older")
    monkeypatch.setattr(xr.Dataset, "to_netcdf", Mock(side_effect=OSError(28, "No space left")))
    assert main(quickly("default", "--json", "--output", str(tmp_path / "run.nc"))) == 2
    out, err = capsys.readouterr()
    assert json.loads(out)["steps"] == 51  # the figures are not lost
    assert err.startswith("tyrecontact: --output could not be written, ")
    assert err.count("\n") == 1
    assert [path.read_text() for path in tmp_path.iterdir()] == ["older"]


@pytest.fixture
def _few_findings(monkeypatch: pytest.MonkeyPatch) -> None:
    """One finding that agrees and one that does not, about the tiny figures."""
    found = [
        Claim("fig-43", "It parts", "yes", "it does", lambda _: ("yes", True)),
        Claim("fig-44", "It stays", "yes", "it does", lambda _: ("no", False), "it is pulled"),
    ]
    monkeypatch.setattr(thesis, "FINDINGS", found)


@pytest.mark.usefixtures("tiny_figures", "_few_findings")
def test_the_thesis_is_run_judged_and_written(capsys: Capture, tmp_path: Path) -> None:
    assert main(["thesis", "--output", str(tmp_path / "out"), "--jobs", "1"]) == 0
    out, err = capsys.readouterr()
    assert out.startswith("1 of 2 findings agree")
    assert "step" in err  # the bar
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "runs",
        "thesis.json",
        "thesis.md",
    }
    record = json.loads((tmp_path / "out" / "thesis.json").read_text(encoding="utf-8"))
    for figure in record["figures"]:
        for file in figure["runs"].values():
            assert (tmp_path / "out" / file).is_file()


@pytest.mark.usefixtures("tiny_figures", "_few_findings")
def test_only_the_figures_asked_for_are_run(capsys: Capture, tmp_path: Path) -> None:
    assert main(["thesis", "--output", str(tmp_path), "--figures", "44", "--jobs", "1"]) == 0
    assert capsys.readouterr().out.startswith("0 of 1 findings agree")
    assert [path.name for path in (tmp_path / "runs").iterdir()] == ["fig-44_c-d.nc"]


@pytest.mark.usefixtures("_never_run")
@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        (["--figures", "17"], "figure must be one of"),
        (["--jobs", "0"], "--jobs must be at least 1, got 0"),
        (["--output", "regular/out"], "--output must name a folder that can be written"),
    ],
)
def test_a_campaign_that_cannot_be_run_is_refused_first(
    capsys: Capture,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    part: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "regular").write_text("a file")
    assert part in refused(capsys, ["thesis", "--output", "out", *arguments])


@pytest.mark.usefixtures("tiny_figures")
def test_members_of_figures_are_listed_on_demand(capsys: Capture) -> None:
    assert main(["presets", "--members"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[-2].startswith("fig-44 ")
    assert lines[-1] == "    fig-44/c-d"


@pytest.mark.usefixtures("_never_run")
@pytest.mark.parametrize(
    "text",
    ["[loading\n", "[lading]\nrate = 1\n", "[loading]\nrate = 99\n", "loading = 3\n",
     "preset = 3\n", "preset = ['default']\n", "[self]\nrate = 1\n"],
)  # fmt: skip
def test_a_file_that_cannot_be_used_is_refused(capsys: Capture, tmp_path: Path, text: str) -> None:
    (tmp_path / "my.toml").write_text(text, encoding="utf-8")
    refused(capsys, ["run", str(tmp_path / "my.toml")])


def test_ctrl_c_writes_what_was_computed(
    capsys: Capture, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    advance, calls = simulation.advance, iter(range(100))

    def interrupted(*arguments: Any) -> Any:
        if next(calls) == 10:
            raise KeyboardInterrupt
        return advance(*arguments)

    monkeypatch.setattr(simulation, "advance", interrupted)
    found = printed(capsys, quickly("default", "--output", str(tmp_path / "run.nc")))
    assert (found["steps"], found["stop_reason"]) == (10, "stopped by the user")
    with xr.open_dataset(tmp_path / "run.nc") as dataset:
        assert dataset.sizes["time"] == 10


def test_the_module_runs_as_a_program() -> None:
    call = [sys.executable, "-m", "tyrecontact"]
    listed = subprocess.run([*call, "presets"], capture_output=True, text=True, check=True)
    assert (listed.stdout[:8], listed.stderr) == ("default ", "")
    wrong = subprocess.run([*call, "run", "nope"], capture_output=True, text=True, check=False)
    assert (wrong.returncode, wrong.stdout) == (2, "")


def line_of(path: Path, named: bool = True) -> str:
    """A profile of 90 mm in a text file, with or without names of its columns."""
    rows = "".join(f"{n * 0.1:.1f} {n % 7 * 0.01:.2f}\n" for n in range(900))
    path.write_text(("distance (mm)  height (mm)\n" if named else "") + rows)
    return str(path)


def test_what_is_understood_of_a_road_file_is_told(capsys: Capture, tmp_path: Path) -> None:
    file = line_of(tmp_path / "line.txt")
    assert main(["road", file]) == 0
    out = capsys.readouterr().out
    for part in (
        "line.txt: profile", "pitch               100 µm (file)", "unit of heights     mm (file)",
        "mean profile depth  ", "- levelled: ", "patch               a patch of 20 mm, rms ",
    ):  # fmt: skip
        assert part in out
    found = printed(capsys, ["road", file, "--set", "trim_start=0.01", "--set", "size=0.2"])
    assert found["extent"] == [pytest.approx(0.08)]
    assert found["patch"].startswith("none: road must cover 200 x 200 mm")


def test_a_road_file_is_asked_for_what_it_does_not_carry(capsys: Capture, tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("\n".join(" ".join(["1 2 3"] * 20) for _ in range(60)))
    file = str(tmp_path / "a.txt")
    assert "pitch must be given" in refused(capsys, ["road", file])
    assert "unit must be given" in refused(capsys, ["road", file, "--pitch", "1e-4"])
    assert "unit" in refused(capsys, ["road", file, "--pitch", "1e-4", "--unit", "nm"])
    assert "columns must be named" in refused(
        capsys, ["road", line_of(tmp_path / "b.txt", named=False), "--pitch", "1e-4"]
    )
    assert "road file must be readable" in refused(capsys, ["road", str(tmp_path / "c.x3p")])
    assert "must be given as name=value" in refused(capsys, ["road", file, "--set", "size"])
    found = printed(capsys, ["road", file, "--pitch", "1e-4", "--unit", "um"])
    assert (found["pitch_origin"], found["unit_origin"]) == ("given", "given")
