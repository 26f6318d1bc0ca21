"""The report: one page with all that it needs in it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from app import report
from tyrecontact import thesis
from tyrecontact.__main__ import main
from tyrecontact.figures import FIGURES
from tyrecontact.thesis.findings import Claim


@pytest.fixture
def written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tiny_figures: dict[str, object]
) -> Path:
    """A campaign of two tiny figures."""
    found = [
        Claim("fig-43", "It parts", "<yes>", "it does", lambda _: ("yes", True)),
        Claim("fig-44", "It stays", "yes", "it does", lambda _: ("no", False), "it is pulled"),
    ]
    monkeypatch.setattr(thesis, "FINDINGS", found)
    assert main(["thesis", "--output", str(tmp_path), "--jobs", "1"]) == 0
    return tmp_path


def test_the_page_holds_table_figures_and_reasons(
    written: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert report.main([str(written)]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == str(written / "report.html")
    page = (written / "report.html").read_text(encoding="utf-8")
    assert "<strong>1 of 2</strong> findings agree" in page
    assert page.count('class="mark yes"') == page.count('class="mark no"') == 2  # table, figure
    assert "&lt;yes&gt;" in page  # nothing of the data is taken as HTML
    assert "it is pulled" in page
    for name in FIGURES:
        assert f'<section id="{name}">' in page
    assert page.count('<div class="plot">') == 4  # force and indentation of each


def test_the_page_asks_nothing_of_the_network(written: Path) -> None:
    page = report.report(written)
    # BokehJS, in the page, has addresses in its texts; what loads something are these
    body = re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
    assert not re.search(r"https?://|//cdn", body)
    assert not re.search(r"<script[^>]*\ssrc=", page)
    assert "<link" not in body.replace('<link rel="icon" href="data:,">', "")
    assert "@import" not in body


@pytest.mark.parametrize("spoil", [None, "thesis.json", "runs/fig-43_a.nc"])
def test_a_folder_that_is_no_campaign_is_refused_in_a_line(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    spoil: str | None,
    request: pytest.FixtureRequest,
) -> None:
    folder = tmp_path
    if spoil:
        folder = request.getfixturevalue("written")
        (folder / spoil).write_text("{")
    assert report.main([str(folder)]) == 2
    err = capsys.readouterr().err.splitlines()[-1]
    assert err.startswith("app.report: DIR must be a folder written by `tyrecontact thesis")
    assert not (folder / "report.html").exists()
