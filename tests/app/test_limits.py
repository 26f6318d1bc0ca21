"""What a server allows: read once, refused in a sentence."""

from __future__ import annotations

import pytest

from app.limits import Limits
from tyrecontact import Scenario, Simulation
from tyrecontact.errors import InputError


def test_nothing_set_is_no_limit_but_for_uploads(small: Scenario) -> None:
    limits = Limits.from_environment({"TYRECONTACT_MAX_RUNS": " ", "HOME": "/"})
    assert limits == Limits(None, None, None, None, None, 200.0)
    limits.check(Simulation(small))
    limits.check_upload(100e6)


def test_all_are_read() -> None:
    names = ("SESSIONS", "RUNS", "STEPS", "ELEMENTS", "SECONDS", "UPLOAD")
    values = ("20", " 2 ", "20000", "64", "90.5", "1e2")
    environment = {f"TYRECONTACT_MAX_{n}": v for n, v in zip(names, values, strict=True)}
    assert Limits.from_environment(environment) == Limits(20, 2, 20000, 64, 90.5, 100.0)


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("RUNS", "0", "must be a whole number above 0, got 0"),
        ("RUNS", "2.5", "must be a whole number above 0, got '2.5'"),
        ("SESSIONS", "-3", "must be a whole number above 0, got -3"),
        ("STEPS", "many", "must be a whole number above 0, got 'many'"),
        ("SECONDS", "nan", "must be a positive number, got nan s"),
        ("SECONDS", "inf", "must be a positive number, got inf s"),
        ("UPLOAD", "0", "must be a positive number, got 0.0 MB"),
        ("UPLOAD", "2 GB", "must be a positive number, got '2 GB' MB"),
    ],
)
def test_what_is_no_limit_is_refused(name: str, text: str, sentence: str) -> None:
    with pytest.raises(InputError) as refused:
        Limits.from_environment({f"TYRECONTACT_MAX_{name}": text})
    assert str(refused.value) == f"TYRECONTACT_MAX_{name} {sentence}"


def test_too_many_elements_or_steps_are_refused_with_what_to_lower(small: Scenario) -> None:
    simulation = Simulation(small)
    Limits(elements=6, steps=len(simulation)).check(simulation)
    with pytest.raises(
        InputError, match=r"^road\.elements must be at most 5 on this server, got 6$"
    ):
        Limits(elements=5).check(simulation)
    with pytest.raises(
        InputError, match=r"at most 20 steps on this server, got 52: .*time_resolution_factor$"
    ):
        Limits(steps=20).check(simulation)


def test_a_file_that_is_too_large_is_refused() -> None:
    with pytest.raises(InputError, match=r"at most 0\.5 MB on this server, got 0\.6 MB$"):
        Limits(upload=0.5).check_upload(6e5)
