"""The player without a browser: asked as the browser asks, and what is on show is read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from app.player import DURATION, Player

COLUMNS = {"time": np.arange(342) * 2e-5, "indentation": np.arange(342) * 6e-7}


class Watched(Player):
    """A player that counts its calls for another picture."""

    def __init__(self) -> None:
        self.changes = 0
        super().__init__()
        self.on_change = self.count_one

    def count_one(self) -> None:
        self.changes += 1

    def ask(self, **message: Any) -> None:
        self.root._handle_msg(message)


@pytest.fixture
def player() -> Watched:
    made = Watched()
    made.update(200, 342, COLUMNS)
    return made


def test_it_follows_a_run_until_it_is_scrubbed_and_then_stays(player: Watched) -> None:
    assert player.step is None
    assert player.root.state["label"] == "step 200 of 342, 3.98 ms, 119 µm"
    player.ask(do="scrub", step=120)
    assert (player.step, player.changes) == (120, 1)
    player.update(230, 342, COLUMNS)
    assert player.step == 120
    assert player.root.state["label"] == "step 121 of 342, 2.40 ms, 72.0 µm"
    assert (player.root.state["count"], player.root.state["step"]) == (230, 120)
    player.ask(do="newest")
    assert (player.step, player.root.state["step"]) == (None, -1)


def test_scrubbing_to_the_newest_step_follows_it(player: Watched) -> None:
    player.scrub(50)
    player.scrub(199)
    player.update(220, 342)
    assert player.step is None
    player.move(-1)
    assert player.step == 218
    player.move(10)
    assert player.step is None


def test_keys_move_by_steps_and_stop_at_the_first(player: Watched) -> None:
    player.scrub(12)
    player.ask(do="move", by=-10)
    assert player.step == 2
    player.ask(do="move", by=-10)
    assert player.step == 0
    Player().move(1)  # without a run nothing moves


def test_a_replay_takes_its_time_whatever_the_clock(player: Watched) -> None:
    player.update(342, 342, COLUMNS)
    for frame in (0.05, 0.3):
        player.ask(do="play")
        assert player.playing
        assert player.step == 0
        elapsed = 0.0
        while player.playing:
            player.tick(frame)
            elapsed += frame
        assert player.step is None
        assert elapsed == pytest.approx(DURATION, abs=2 * frame)


def test_speed_changes_while_it_plays(player: Watched) -> None:
    player.play()
    player.tick(1.0)
    assert player.step == int(342 / DURATION)
    player.ask(do="speed", speed=4)
    player.tick(0.5)
    assert player.step == int(3 * 342 / DURATION)
    player.ask(do="speed", speed=1000)
    assert player.speed == 4.0


def test_pause_stays_and_play_goes_on_from_there(player: Watched) -> None:
    player.play()
    player.tick(1.0)
    here = player.step
    player.play()
    assert not player.playing
    player.tick(1.0)
    assert player.step == here
    player.play()
    assert (player.playing, player.step) == (True, here)
    player.scrub(7)
    assert not player.playing


def test_a_replay_that_catches_up_with_a_run_goes_on_live(player: Watched) -> None:
    player.scrub(190)
    player.play()
    player.tick(1.0)
    assert (player.step, player.playing) == (None, False)
    player.update(201, 342, COLUMNS)
    assert player.root.state["label"].startswith("step 201 ")


def test_ticks_without_another_step_change_nothing(player: Watched) -> None:
    player.play()
    changes = player.changes
    player.tick(1e-4)
    assert player.changes == changes
    player.tick(0.1)
    assert player.changes == changes + 1


def test_another_run_starts_anew(player: Watched) -> None:
    player.scrub(150)
    player.update(10, 342, COLUMNS)
    assert player.step is None
    player.scrub(4)
    player.reset()
    assert player.step is None
    assert player.root.state["label"] == "no step yet"
    player.ask(do="play")
    assert not player.playing


@pytest.mark.parametrize("message", [{}, {"do": "scrub"}, {"do": "scrub", "step": "x"}, "play", 3])
def test_what_makes_no_sense_is_passed_over(player: Watched, message: Any) -> None:
    player.root._handle_msg(message)
    assert (player.step, player.changes) == (None, 0)
