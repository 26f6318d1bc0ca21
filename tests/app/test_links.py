"""A link gives the scenario again, and one that nobody should have written does no harm."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from app import links
from app.link_keys import KEYS, LAYER_KEYS, PRESET_KEY, VERSION_KEY, VIEW_MARK
from app.link_values import shortest
from tests.app.scenarios import LAYERS, random_scenario
from tyrecontact import Scenario, Simulation, presets
from tyrecontact.errors import InputError
from tyrecontact.parts.tread import Layer

PINNED = json.loads((Path(__file__).parent / "link_keys_v1.json").read_text(encoding="utf-8"))
VIEWS = {"axis": ["indentation", "time"], "tab": ["Live", "Release and bonds"]}


def only_problem(search: str) -> str:
    """The one sentence on a link that changes nothing otherwise."""
    link = links.parse(search, VIEWS)
    assert link.scenario.to_dict() == Scenario().to_dict()
    assert len(link.problems) == 1
    return link.problems[0]


def valid_scenarios(count: int, share: float) -> Iterator[Scenario]:
    """Random scenarios whose settings go together."""
    chance = random.Random(count)
    while count:
        scenario = random_scenario(chance, share)
        scenario.tread.layers = random.Random(count).choice([[], LAYERS, LAYERS[:1]])
        try:
            Simulation(scenario)
        except InputError:
            continue
        count -= 1
        yield scenario


def test_every_setting_has_a_key_of_its_own() -> None:
    paths = [path for path, _, _ in Scenario().settings()]
    assert list(KEYS) == paths
    assert len(set(KEYS.values())) == len(KEYS)
    assert not {VERSION_KEY, PRESET_KEY} & set(KEYS.values())
    assert all(key.isalpha() and key.islower() and len(key) <= 3 for key in KEYS.values())
    assert not any(key.startswith(VIEW_MARK) for key in KEYS.values())
    assert set(LAYER_KEYS) == set(Layer().param) - {"name"}
    assert len(set(LAYER_KEYS.values())) == len(LAYER_KEYS)


def test_no_key_of_version_1_has_changed() -> None:
    assert links.VERSION == 1
    assert PINNED["settings"].items() <= KEYS.items()
    assert PINNED["layers"].items() <= LAYER_KEYS.items()


def test_a_link_of_version_1_is_still_understood() -> None:
    layer = "t0.01~d1300~p0.49~mfractional-kelvin-voigt~e25e6~x0.6091~r3.717e-6"
    link = links.parse(f"?v=1&p=thesis-factor-2&rn=10&lr=0.05&nk=passive&ru=um&tl={layer}")
    expected = presets.get("thesis-factor-2")
    for path, value in {"road.elements": 10, "loading.rate": 0.05, "numerics.kernel": "passive",
                        "road.height_unit": "um"}.items():  # fmt: skip
        expected.set(path, value)
    expected.tread.layers = [{
        "thickness": 0.01, "density": 1300.0, "poissons_ratio": 0.49,
        "material": "fractional-kelvin-voigt", "static_modulus": 25e6, "exponent": 0.6091,
        "relaxation_time": 3.717e-6,
    }]  # fmt: skip
    assert link.problems == []
    assert link.preset == "thesis-factor-2"
    assert link.scenario.to_dict() == expected.to_dict()


@pytest.mark.parametrize("name", [*presets.names(), "fig-44/14-N"])
def test_a_preset_is_its_name(name: str) -> None:
    scenario = presets.get(name)
    text = links.query(name, scenario)
    assert text == f"v=1&p={name.replace('=', '%3D')}"
    link = links.parse(text)
    assert (link.preset, link.problems) == (name, [])
    assert link.scenario.to_dict() == scenario.to_dict()


@pytest.mark.parametrize("share", [0.05, 0.3])
def test_any_scenario_comes_back_exactly(share: float) -> None:
    for scenario in valid_scenarios(12, share):
        for name in ("default", "fig-44"):
            link = links.parse(links.query(name, scenario))
            assert link.problems == []
            assert link.scenario.to_dict() == scenario.to_dict()


def test_a_link_is_short_and_readable() -> None:
    scenario = Scenario(loading={"rate": 0.05}, tread={"static_modulus": 12e6})
    assert links.query("default", scenario, {"axis": "time"}) == (
        "v=1&p=default&te=12e6&lr=0.05&_axis=time"
    )
    assert len(links.query("default", random_scenario(random.Random(0)))) < 1500


def test_numbers_are_written_short_and_exactly() -> None:
    chance = random.Random(1)
    assert [shortest(x) for x in (25e6, 3e-5, 0.6091, -430e-6, 0.0, 1.0, 51200.0, 0.05)] == [
        "25e6", "3e-5", "0.6091", "-43e-5", "0", "1", "51200", "0.05",
    ]  # fmt: skip
    assert [shortest(n) for n in (0, 7, 2**32 - 1, 400000)] == ["0", "7", "4294967295", "400000"]
    for _ in range(2000):
        number = chance.uniform(-1, 1) * 10 ** chance.uniform(-15, 15)
        assert float(shortest(number)) == number


def test_what_is_looked_at_comes_along() -> None:
    view = {"axis": "time", "tab": "Release and bonds"}
    assert links.parse(links.query("default", Scenario(), view), VIEWS).view == view
    assert "'spin'" in only_problem("_spin=1")
    assert only_problem("_axis=sideways") == (
        "axis must be one of indentation, time, got 'sideways'"
    )


def test_a_link_of_nothing_is_the_default() -> None:
    for search in ("", "?", "v=1", "p=default"):
        link = links.parse(search)
        assert (link.preset, link.view, link.problems) == ("default", {}, [])
        assert link.scenario.to_dict() == Scenario().to_dict()


@pytest.mark.parametrize(
    ("search", "said"),
    [
        ("lr=fast", "loading.rate must be a number between 0.0001 and 10 m/s, got 'fast'"),
        ("lr=nan", "loading.rate must be a number between 0.0001 and 10 m/s, got nan m/s"),
        ("lr=1e999", "got inf m/s"),
        ("lr=", "got ''"),
        ("lr=" + "9" * 200, "loading.rate must have at most 80 characters, got 200"),
        ("rn=10.5", "road.elements must be a whole number between 2 and 256, got '10.5'"),
        ("nk=magic", "numerics.kernel must be one of"),
        ("nk=passive%00%1b[31m", r"got 'passive\x00\x1b[31m'"),
        ("nk=%ff%fe", "numerics.kernel must be one of"),
        ("zz=1", "No setting of a link is called 'zz'"),
        ("%3Cscript%3E=1", "No setting of a link is called '<script>'"),
        ("road.file=/etc/passwd", "No setting of a link is called 'road.file'"),
        ("rf=/etc/passwd", "road.file must not be named in a link, got '/etc/passwd'"),
        ("lf=~/.netrc", "loading.table must not be named in a link"),
        ("tf=C:%5Cx", "tread.modulus_table must not be named in a link"),
        ("rf=*", "The road came from a file of the sender's own"),
        ("p=no-such", "No preset is called 'no-such': the default stands in"),
        ("p=fig-44/no-such", "No preset is called 'fig-44/no-such'"),
        ("p=" + "fig-" * 500, "No preset is called"),
        ("v=2", "This link is of version 2 and this page of version 1"),
        ("v=1e3", "The version of a link must be 1, got '1e3'"),
        ("tl=t0.01", "layer 1 of tread.layers: density must be given"),
        ("tl=t1~mtabulated~f/etc/passwd", "modulus_table must not be named in a link"),
        ("tl=q1", "letter of a layer's setting must be one of"),
        ("tl=t1~t1", "thickness of a layer must be given once"),
        ("tl=_____", "letter of a layer's setting must be one of"),
        ("x" * 9000, "A link must have at most 8000 characters, got 9000: nothing was taken"),
        ("lp=table", "loading.profile was left as it is in the preset: loading.table must name"),
        ("sx=201", "springs.exchange_count was left as it is in the preset: springs.exch"),
    ],
)  # fmt: skip
def test_what_cannot_be_used_is_told_in_one_sentence(search: str, said: str) -> None:
    sentence = only_problem(search)
    assert said in sentence
    assert sentence.isprintable()
    assert len(sentence) < 600


def test_the_rest_of_a_link_is_applied() -> None:
    search = "v=9&p=adhesion&lr=x&zz=1&rf=/etc/passwd&lm=5e-5&lm=6e-5&sx=300&_axis=time&_tab=None"
    link = links.parse(search, VIEWS)
    expected = presets.get("adhesion")
    expected.loading.max_indentation = 5e-5
    assert link.scenario.to_dict() == expected.to_dict()
    assert (link.preset, link.view) == ("adhesion", {"axis": "time"})
    assert len(link.problems) == 7
    assert "lm' must be given once" in " ".join(link.problems)


def test_settings_that_need_each_other_are_taken_beside_others_that_are_refused() -> None:
    link = links.parse("tm=tabulated&ld=force&lw=1&nk=band-limited&nf=6&rn=4&sx=80")
    scenario = link.scenario
    assert (scenario.tread.material, scenario.numerics.kernel) == ("tabulated", "band-limited")
    assert (scenario.loading.drive, scenario.loading.mass) == ("force", 1.0)
    assert len(link.problems) == 2


def test_a_flood_of_mistakes_is_told_in_a_few_sentences() -> None:
    link = links.parse("&".join(f"q{n}=1" for n in range(900)))
    assert len(link.problems) == links.MOST_TOLD
    assert link.problems[-1] == "893 more things in this link cannot be used"


def test_noise_is_harmless() -> None:
    chance = random.Random(5)
    alphabet = [*"&=?%;+~_*/\\.\0\n\x1b\u202e<>'\"", *"0123456789e-", *KEYS.values(), "v", "p"]
    for _ in range(60):
        noise = "".join(chance.choices(alphabet, k=chance.randint(1, 200)))
        link = links.parse(noise, VIEWS)
        Simulation(link.scenario)
        assert all(sentence.isprintable() for sentence in link.problems)
        assert not link.scenario.road.file


def test_files_of_ones_own_are_told_and_only_marked() -> None:
    scenario = Scenario(road={"file": "/tmp/secret/road.npy", "pitch": 1e-5})
    assert links.unshared(Scenario()) == []
    assert links.unshared(scenario) == [
        "The road comes from a file of your own, which a link cannot carry: whoever opens it "
        "gets a made road"
    ]
    text = links.query("default", scenario)
    assert text == "v=1&p=default&rf=*&rp=1e-5"
    assert "sender's own" in links.parse(text).problems[0]


def test_every_setting_that_is_a_file_is_told() -> None:
    scenario = Scenario(tread={"layers": [{**LAYERS[1], "modulus_table": "/tmp/secret/a.txt"}]})
    scenario.numerics.kernel = "band-limited"
    for path, parameter, _ in Scenario().settings():
        if type(parameter).__name__ == "Text":
            scenario.set(path, "/tmp/secret/file")
    assert len(links.unshared(scenario)) == 4
    text = links.query("default", scenario)
    assert "secret" not in text
    link = links.parse(text)
    assert len(link.problems) == 4
    assert link.scenario.tread.layers == [LAYERS[1]]
