"""The Dockerfile without an engine: files exist, the order is right, commands work as written."""

from __future__ import annotations

import ast
import json
import os
import re
import shlex
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

_ROOT = Path(__file__).parents[1]


def _instructions() -> list[tuple[str, str]]:
    """(keyword, rest) of each instruction, continued lines joined, comments dropped."""
    lines = [
        line
        for line in (_ROOT / "Dockerfile").read_text().splitlines()
        if line[:1] not in ("#", "")
    ]
    joined = re.sub(r"\\\n\s*", "", "\n".join(lines)).splitlines()
    return [(word, rest) for word, _, rest in (line.partition(" ") for line in joined)]


def _command(keyword: str) -> list[str]:
    """The JSON command of the last instruction of a kind, python being this interpreter."""
    rest = [rest for word, rest in _instructions() if word == keyword][-1]
    command = json.loads(rest[rest.index("[") :])
    program = {"python": [sys.executable], "panel": [sys.executable, "-m", "panel"]}[command[0]]
    return [*program, *command[1:]]


@pytest.fixture(scope="module")
def served() -> Iterator[None]:
    """The page, started by the CMD as it stands."""
    server = subprocess.Popen(
        _command("CMD"), cwd=_ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    yield
    server.terminate()
    server.wait(20)


def test_all_that_is_copied_exists() -> None:
    for word, rest in _instructions():
        if word == "COPY":
            for source in shlex.split(rest)[:-1]:
                assert (_ROOT / source).exists(), source


def test_dependencies_are_installed_before_the_package_is_copied() -> None:
    steps = _instructions()
    install = next(i for i, (w, rest) in enumerate(steps) if w == "RUN" and "pip install" in rest)
    copy = next(i for i, step in enumerate(steps) if step == ("COPY", "tyrecontact tyrecontact"))
    assert install < copy


def test_it_serves_as_a_user_without_rights() -> None:
    users = [rest for word, rest in _instructions() if word == "USER"]
    assert users
    assert users[-1] not in ("root", "0")
    made = " ".join(rest for word, rest in _instructions() if word == "RUN")
    assert f"useradd --create-home --uid 10001 {users[-1]}" in made


def test_the_health_check_passes_on_what_the_cmd_serves_and_fails_on_nothing(
    served: None,
) -> None:
    check = _command("HEALTHCHECK")
    limit = time.monotonic() + 60
    while subprocess.run(check, capture_output=True, check=False).returncode != 0:
        assert time.monotonic() < limit, "the health check never passed"
        time.sleep(0.2)
    elsewhere = [part.replace(":5006", ":1") for part in check]
    assert subprocess.run(elsewhere, capture_output=True, check=False).returncode != 0


def test_the_page_never_imports_itself_by_name() -> None:
    # `panel serve app` finds the package `app` only by relative imports: an installed package
    # does not put the project's folder on the path (an editable one does, and hides the fault)
    for path in (_ROOT / "app").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            named = isinstance(node, ast.ImportFrom) and node.level == 0 and node.module
            assert not (named and node.module.split(".")[0] == "app"), path


def test_the_runs_that_fill_the_cache_work(tmp_path: Path) -> None:
    fill = next(rest for word, rest in _instructions() if word == "RUN" and "--json" in rest)
    less_deep = ["--set", "loading.max_indentation=2e-5"]  # the kernels are the same
    for line in fill.split("&&"):
        program, *arguments = shlex.split(line)
        assert program == "tyrecontact"
        done = subprocess.run(
            [sys.executable, "-m", "tyrecontact", *arguments, *less_deep],
            capture_output=True, check=True, text=True,
            env={**os.environ, "TYRECONTACT_CACHE": str(tmp_path)},
        )  # fmt: skip
        assert json.loads(done.stdout)["stop_reason"] == "completed"
    assert len(list(tmp_path.glob("*.npz"))) == 3
