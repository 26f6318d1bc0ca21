"""The dialog asks for what a file lacks, and shows the fields that mean something for it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.road_dialog import RoadDialog
from app.road_reading import Reading
from tyrecontact.parts.road import Road


class Asked:
    """A dialog on one file, answered at once."""

    def __init__(self, path: Path) -> None:
        self.reading = Reading(path, path.name)
        self.dialog = RoadDialog(self.answer, lambda: None, lambda: None)
        self.dialog.open(path.name, Road(), fresh=True)

    def answer(self, road: Road) -> None:
        self.dialog.show(self.reading.look(road), road)

    def shown(self) -> set[str]:
        return {name for name, field in self.dialog.fields.items() if field.visible}


@pytest.fixture
def profile(tmp_path: Path) -> Path:
    path = tmp_path / "line.dat"
    rows = "".join(f"{n * 0.1:.1f}\t{n % 7}\n" for n in range(90))
    path.write_text(f"distance (mm)\theight (mm)\n{rows}")
    return path


def test_a_file_that_carries_pitch_and_unit_needs_neither(profile: Path) -> None:
    asked = Asked(profile)
    assert "100 µm, from the file" in asked.dialog.facts.object
    # 9 mm do not carry a patch of 20 mm: the largest is offered
    assert asked.dialog.fields["size"].value == pytest.approx(9.0)
    assert {"trim_start", "trim_end", "profile_use"} < asked.shown()
    assert "centre_y" not in asked.shown()


def test_a_map_has_no_ends_to_trim_and_only_gaps_ask_how_many_to_fill(tmp_path: Path) -> None:
    heights = np.random.default_rng(1).normal(0, 0.02, (300, 300))
    np.save(tmp_path / "map.npy", heights)
    asked = Asked(tmp_path / "map.npy")
    assert asked.shown() == {"pitch", "height_unit"}
    assert asked.dialog.fields["pitch"].helper_text == "must be given"
    asked.dialog.fields["pitch"].value = 100.0
    assert asked.dialog.fields["height_unit"].error_state
    assert not asked.dialog.fields["pitch"].error_state
    asked.dialog.fields["height_unit"].value = "mm"
    assert not asked.shown() & {"trim_start", "trim_end", "profile_use", "fill_limit"}
    assert not asked.dialog.use_button.disabled


def test_a_value_out_of_bounds_is_one_sentence_with_the_name_of_its_field(profile: Path) -> None:
    asked = Asked(profile)
    asked.dialog.fields["size"].value = 500.0
    assert "Side of the patch must be a number between 0.001 and 0.2 m" in (
        asked.dialog.message.object
    )
    assert asked.dialog.use_button.disabled
    asked.dialog.fields["size"].value = 8.0
    assert not asked.dialog.use_button.disabled
    asked.dialog.fields["elements"].value = 200
    assert "at least 4 heights a side of an element" in asked.dialog.message.object
    assert asked.dialog.use_button.disabled


def test_a_long_name_is_short_in_the_title_and_whole_in_the_facts(profile: Path) -> None:
    name = f"{'long' * 20}.dat"
    asked = Asked(profile.rename(profile.with_name(name)))
    assert asked.dialog.root.title == "Your road: longlonglong…glong.dat"
    assert name in asked.dialog.facts.object
    assert not asked.dialog.busy.object


def test_a_steep_road_is_usable_but_doubted(profile: Path) -> None:
    asked = Asked(profile)
    assert "Please check: an rms slope" in asked.dialog.message.object
    assert not asked.dialog.use_button.disabled


@pytest.mark.parametrize("values", [{"trim_start": 100.0}, {"trim_end": 100.0}])
def test_what_leaves_nothing_of_a_file_can_be_put_right(
    profile: Path, values: dict[str, float]
) -> None:
    asked = Asked(profile)
    fields = asked.shown()
    for name, value in values.items():
        asked.dialog.fields[name].value = value
    assert "must leave some" in asked.dialog.message.object
    assert asked.dialog.facts.object == ""
    assert asked.dialog.use_button.disabled
    assert asked.shown() == fields
    for name in values:
        asked.dialog.fields[name].value = 0.0
    assert not asked.dialog.use_button.disabled
    assert "line.dat" in asked.dialog.facts.object
