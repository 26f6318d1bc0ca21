"""How stiff the contact is, and how far its force is from that of the tread at rest."""

from __future__ import annotations

from dataclasses import dataclass

import holoviews as hv
import numpy as np

from tyrecontact import key_figures
from tyrecontact.branches import Branch, branches

from .headline import three_digits
from .lines import RUN, Line, behind, lines, window
from .tab import Reading, Seen, TabView

#: name of a branch -> dash of its line
DASHES = {"loading": "solid", "unloading": "dashed"}
#: shares of a force below this share of the largest tell nothing
_TOLD = 0.02
#: a branch with fewer points has no slope worth telling
_LEAST = 5
#: differences below this share are called small; below this one [%] there is none
_SMALL, _NOTHING = 0.05, 0.02
#: a stiffness that is within this share of the last one, this early, levels off
_LEVEL, _SOON = 0.9, 0.8
#: a stiffness is wrong that is off by this share of the largest one
_OFF = 0.25
#: a difference is shown up to this share, where it goes beyond three times that
_SHOWN = 0.1
_DEEP, _FORCE = "Indentation [µm]", "Force [N]"
_STILL, _STIFF = "quasi-static", "Stiffness dF/dd [MN/m]"
_NONE = Branch(np.zeros(0), np.zeros(0))


@dataclass(frozen=True)
class _Pair:
    """A run, as far as its steps converge, and the quasi-static one, if there, on one branch."""

    name: str
    run: Branch
    still: Branch

    def difference(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Indentation [m]; force less the quasi-static one [N] and [%], nan where that is small."""
        depth, excess, due = self.run.less(self.still)
        enough = np.abs(due) >= _TOLD * np.abs(self.still.force).max(initial=0.0)
        return depth, excess, 100 * excess / np.where(enough, np.abs(due), np.nan)


class StiffnessView(TabView):
    """Attributes: `root` to look at; `reading` what is shown."""

    @property
    def promise(self) -> str:
        return (
            "Here the stiffness of the contact will be seen, against indentation and force, and "
            "what the tread's dynamics add to the force. Press Run."
        )

    def read(self, seen: Seen) -> Reading:
        pairs = _pairs(seen)
        if not any(pair.run.depth.size >= _LEAST for pair in pairs):
            return Reading(_too_short(seen), seen.failed_at is not None)
        loading, unloading = pairs
        if seen.failed_at is not None and not unloading.run.depth.size:
            sentence, bad = _on_failure(seen, loading), True
        else:
            sentence, bad = _on_stiffness(loading) + _on_difference(loading), False
            sentence += _on_unloading(seen, unloading)
        sentence = f"{sentence.strip()} {_on_baseline(seen)}".strip()
        return Reading(sentence, bad, _figures(seen, pairs), _plots(pairs))


def _pairs(seen: Seen) -> list[_Pair]:
    depth, force = seen.columns["indentation"], seen.columns["contact_force"]
    sound, still = slice(0, seen.failed_at), seen.run.baseline
    run = branches(depth[sound], force[sound], seen.columns["drive"][sound])
    rest = (_NONE, _NONE) if still is None else branches(still.indentation, still.contact_force)
    if seen.failed_at is not None and seen.failed_at <= int(depth.argmax()):
        run = run[0], _NONE  # what came back was no loading
    return [_Pair(*parts) for parts in zip(DASHES, run, rest, strict=True)]


def _too_short(seen: Seen) -> str:
    if seen.failed_at is not None:
        first = seen.failed_at + 1
        return f"No stiffness can be read off: the run failed at its step {first}."
    if not np.any(seen.columns["contact_force"]):
        return "Road and tread have not met yet: there is no stiffness before they do."
    if seen.ended:
        return "No stiffness can be read off: the run ended within a few steps of first touch."
    return "The stiffness takes a few steps in contact to show."


def _on_stiffness(pair: _Pair) -> str:
    depth, force, stiffness = pair.run.slope()
    if not stiffness.size:
        return ""
    early, last = int(0.1 * (depth.size - 1)), int(stiffness.size - 1)
    level = int(np.flatnonzero(stiffness >= _LEVEL * stiffness[last])[0])
    levels = ""
    if depth[level] < _SOON * depth[last] and stiffness.max() < stiffness[last] / _LEVEL:
        levels = f", levelling off from {three_digits(depth[level] * 1e6)} µm on"
    verb = "stiffens" if stiffness[last] > 1.1 * stiffness[early] else "does not stiffen"
    return (
        f"The contact {verb} as the road is pressed in: {three_digits(stiffness[early] / 1e6)} "
        f"MN/m at {three_digits(depth[early] * 1e6)} µm, {three_digits(stiffness[last] / 1e6)} "
        f"MN/m at {three_digits(depth[last] * 1e6)} µm ({three_digits(force[last])} N){levels}. "
    )


def _on_difference(pair: _Pair) -> str:
    _, excess, share = pair.difference()
    if not share.size or not np.isfinite(share[-1]):
        return ""
    most = float(np.nanmax(np.abs(share)))
    if most < _NOTHING:
        return "Its force is that of the quasi-static run: the tread is at rest in every step. "
    above = "above" if share[-1] > 0 else "below"
    much = "little" if abs(share[-1]) / 100 < _SMALL else "something that matters"
    return (
        f"In the end its force is {three_digits(abs(share[-1]))} % "
        f"({three_digits(abs(excess[-1]))} N) {above} that of the quasi-static run, "
        f"{three_digits(most)} % at most on the way: the tread's inertia and damping add {much}. "
    )


def _on_unloading(seen: Seen, pair: _Pair) -> str:
    stiffness = pair.run.slope()[2]
    if not seen.columns["releases"].any() or stiffness.min(initial=0.0) >= 0:
        return ""
    return "While unloading it swings, and falls below 0, where bonds break. "


def _on_baseline(seen: Seen) -> str:
    """Why there is nothing to compare with, where that is so."""
    if seen.run.baseline is not None:
        return ""
    if seen.ended:
        return "There is no quasi-static run to compare with."
    return "The quasi-static run to compare with comes after the last step."


def _on_failure(seen: Seen, pair: _Pair) -> str:
    """Bad news: how far the stiffness was that of a sound run, and where the steps fail."""
    assert seen.failed_at is not None
    failed = three_digits(seen.columns["indentation"][seen.failed_at] * 1e6)
    text = f"From {failed} µm on steps did not converge, and the curves end there. "
    if seen.columns["converged"].all():
        text = f"At {failed} µm the run had to be ended, and the curves end there. "
    sound = _sound(pair)
    if sound.any() and not sound.all():
        deep = three_digits(pair.run.slope()[0][sound][-1] * 1e6)
        text = (
            f"Up to {deep} µm the stiffness is that of the "
            f"quasi-static run to within a quarter; then the force swings from step to step. {text}"
        )
    if seen.run.baseline is not None:
        text += "The plots are as high as a run that goes well needs."
    return text


def _sound(pair: _Pair) -> np.ndarray:
    """Whether each stiffness of a run, and all before it, is near that of the tread at rest."""
    depth, _, stiffness = pair.run.slope()
    still_depth, _, still = pair.still.slope()
    if still.size < 3:
        return np.ones(depth.size, bool)
    off = np.abs(stiffness - np.interp(depth, still_depth, still)) > _OFF * still.max()
    sound: np.ndarray = np.cumsum(off) == 0
    return sound


def _figures(seen: Seen, pairs: list[_Pair]) -> dict[str, str]:
    columns, found = seen.columns, {}
    loaded = seen.failed_at is None or seen.failed_at > int(columns["indentation"].argmax())
    final = key_figures.final_stiffness(columns) if loaded and seen.ended else None
    if final is not None:
        found["Final stiffness"] = f"{three_digits(final / 1e6)} MN/m"
    for pair in pairs:
        depth, _, stiffness = pair.run.slope()
        if seen.failed_at is not None:
            stiffness = stiffness[_sound(pair)]
        if stiffness.size:
            most = int(stiffness.argmax())
            deep = three_digits(depth[most] * 1e6)
            found[f"Most, {pair.name}"] = f"{three_digits(stiffness[most] / 1e6)} MN/m at {deep} µm"
    return found


def _plots(pairs: list[_Pair]) -> dict[str, hv.Overlay]:
    drawn = [pair for pair in pairs if pair.run.depth.size >= _LEAST]
    run = {pair.name: pair.run.slope() for pair in drawn}
    still = {pair.name: pair.still.slope() for pair in drawn if pair.still.depth.size}
    seen = window([k / 1e6 for *_, k in run.values()], [k / 1e6 for *_, k in still.values()])
    by_depth = [
        *(behind(_STILL, d * 1e6, k / 1e6, DASHES[name]) for name, (d, _, k) in still.items()),
        *(Line(name, d * 1e6, k / 1e6, RUN, DASHES[name]) for name, (d, _, k) in run.items()),
    ]
    pressed = {name: _to_the_hardest_pull(*slope) for name, slope in run.items()}
    at_rest = {name: _to_the_hardest_pull(*slope) for name, slope in still.items()}
    by_force = [
        *(behind(_STILL, f, k / 1e6, DASHES[name]) for name, (f, k) in at_rest.items()),
        *(Line(name, f, k / 1e6, RUN, DASHES[name]) for name, (f, k) in pressed.items()),
    ]
    return {
        "by depth": lines("Stiffness against indentation", _DEEP, _STIFF, by_depth, seen),
        "by force": lines("Stiffness against force", _FORCE, _STIFF, by_force, seen),
        **(_differences(drawn) if still else {}),
    }


def _to_the_hardest_pull(
    _depth: np.ndarray, force: np.ndarray, stiffness: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Without what comes after it, where the force comes back to each value again and again."""
    first = int(force.argmin()) if force.size else 0
    return force[first:], stiffness[first:]


def _differences(drawn: list[_Pair]) -> dict[str, hv.Overlay]:
    found = {pair.name: pair.difference() for pair in drawn}
    newtons = [
        Line(name, depth * 1e6, excess, RUN, DASHES[name])
        for name, (depth, excess, _) in found.items()
    ]
    percent = [
        Line(name, depth * 1e6, share, RUN, DASHES[name])
        for name, (depth, _, share) in found.items()
    ]
    usual = _SHOWN * max(np.abs(pair.still.force).max(initial=0.0) for pair in drawn)
    return {
        "newtons": _difference("Force less the quasi-static one", "N", newtons, usual),
        "percent": _difference("The same, as a share of it", "%", percent, 100 * _SHOWN),
    }


def _difference(title: str, unit: str, parts: list[Line], usual: float) -> hv.Overlay:
    shown = window([part.y for part in parts], [np.array([-usual, usual])])
    return lines(title, _DEEP, f"Difference [{unit}]", parts, shown)
