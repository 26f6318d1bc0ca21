"""The run on show is offered as files, made when they are asked for."""

from __future__ import annotations

import io
import tomllib

import pandas as pd
import pytest
import xarray as xr

from app import exports
from app.runner import Run
from app.views.downloads import Downloads
from tyrecontact import Scenario


@pytest.fixture
def view() -> Downloads:
    return Downloads()


def test_nothing_is_made_before_it_is_shown(view: Downloads) -> None:
    assert len(view.root) == 0


def test_before_a_run_it_is_said_what_will_be_there(view: Downloads, small: Scenario) -> None:
    for run, said in ((None, "Press Run: "), (Run(small), "The run has no step yet.")):
        view.show("default", run)
        assert view.note.object.startswith(said)
        assert all(button.disabled for button in view.files.values())
    assert not any(button.disabled for button in view.pictures.values())


def test_files_are_those_of_the_run(view: Downloads, finished: Run) -> None:
    view.show("fig-44/14-N", finished)
    results = finished.results()
    assert view.note.object == "The run, 52 steps:"
    assert not any(button.disabled for button in view.files.values())
    files = {ending: view.contents(ending) for ending in view.files}
    assert all(name.startswith("tyrecontact-fig-44-14-N-2") for name, _ in files.values())
    assert [name.rpartition(".")[2] for name, _ in files.values()] == ["nc", "csv", "toml"]
    with xr.open_dataset(io.BytesIO(files["nc"][1]), engine="scipy") as found:
        xr.testing.assert_identical(found.load(), results.to_xarray())
    assert len(pd.read_csv(io.BytesIO(files["csv"][1]), comment="#")) == 52
    assert tomllib.loads(files["toml"][1].decode())["preset"] == "fig-44/14-N"


def test_no_file_is_made_before_it_is_asked_for(
    view: Downloads, finished: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(exports, "netcdf", None)
    monkeypatch.setattr(exports, "csv", None)
    view.show("default", finished)
    with pytest.raises(TypeError):
        view.contents("nc")


def test_a_run_under_way_gives_what_it_has(view: Downloads, small: Scenario) -> None:
    run = Run(small, duration=30.0)
    run.start()
    while run.record is None or run.record.count < 3:
        assert not run.join(0.01)
    view.show("default", run)
    rows = pd.read_csv(io.BytesIO(view.contents("csv")[1]), comment="#")
    run.stop()
    assert run.join(5)
    assert 3 <= len(rows) < 52


def test_pictures_are_named_by_the_preset(view: Downloads) -> None:
    view.show("thesis-factor-2", None)
    assert {tuple(b.tags) for b in view.pictures.values()} == {("tyrecontact-thesis-factor-2",)}


def test_buttons_stay_when_another_run_is_shown(view: Downloads, finished: Run) -> None:
    view.show("default", None)
    before = list(view.root)
    view.show("default", finished)
    assert list(view.root) == before
