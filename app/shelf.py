"""The pinned runs of one session: kept to be compared, a few of them, without their maps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import count

from tyrecontact.errors import InputError

from .compared import Row, differences, key_figures
from .pinned import Look, Pinned, taken
from .runner import Run
from .setting_words import label as label_for
from .setting_words import preset_of
from .views.comparison import COLORS

#: runs kept at most
MOST = 8
#: characters of a label
LONGEST = 40
#: readable on white and on black, and no pinned run's
THIS_RUN = Look("#2F8FD0", "solid")
_BLUE, _VERMILION, _GREEN, _ORANGE, _PURPLE, _SKY = COLORS
_COLORS = (_GREEN, _VERMILION, _PURPLE, _ORANGE, _SKY, THIS_RUN.color)
_DASHES = ("dashed", "dotdash", "dotted", "solid")
#: each has a pair of colour and dash of its own, and none is that of the run on show
LOOKS = tuple(Look(_COLORS[n % len(_COLORS)], _DASHES[n % len(_DASHES)]) for n in range(MOST))


class Shelf:
    """Pinned runs, in the order in which they were pinned.

    Attributes
    ----------
    pinned : the runs; replaced, never changed.
    """

    def __init__(self) -> None:
        self.pinned: tuple[Pinned, ...] = ()
        self._told: list[Callable[[], None]] = []

    def watch(self, tell: Callable[[], None]) -> None:
        """Have `tell` called after each change."""
        self._told.append(tell)

    def pin(self, run: Run, label: str | None = None) -> Pinned:
        """Keep what there is of a run now.

        A run of a scenario that is pinned already takes its place, colour and, if no other is
        given, label: it is the same run, further on or again.

        Parameters
        ----------
        label : None for one that says in what it differs from the first pinned run; one that is
            taken gets a number.

        Raises
        ------
        InputError : a run without a step; one run too many; a label that is too long or empty.
        """
        before = self.of(run)
        if before is None and len(self.pinned) >= MOST:
            raise InputError(
                f"pinned runs must be at most {MOST}, got one more: unpin one in the tab Compare"
            )
        others = [pin for pin in self.pinned if pin is not before]
        if label is None and before is not None:
            label = before.label
        elif label is None:
            base = self.pinned[0].scenario if self.pinned else None
            label = label_for(run.scenario, base)[:LONGEST]
        look = before.look if before else next(k for k in LOOKS if all(k != p.look for p in others))
        name = _unlike(_checked(label), [pin.label for pin in others])
        found = taken(run, name, preset_of(run.scenario), look)
        if found is None:
            raise InputError("a run to be pinned must have a step, got none so far")
        if before is None:
            self._set((*self.pinned, found))
        else:
            self._set(tuple(found if pin is before else pin for pin in self.pinned))
        return found

    def of(self, run: Run) -> Pinned | None:
        """The pinned run of the same scenario, or None."""
        asked = run.scenario.to_dict()
        return next((pin for pin in self.pinned if pin.scenario.to_dict() == asked), None)

    def unpin(self, label: str) -> None:
        """Let a run go. InputError : no pinned run has that label."""
        gone = self.find(label)
        self._set(tuple(pin for pin in self.pinned if pin is not gone))

    def rename(self, label: str, new: str) -> None:
        """Give a run another label.

        Raises
        ------
        InputError : no run has that label; the new one is empty, too long, or another run's.
        """
        found, name = self.find(label), _checked(new)
        if any(pin.label == name for pin in self.pinned if pin is not found):
            raise InputError(f"label must be unlike those of the other pinned runs, got {name!r}")
        renamed = replace(found, label=name)
        self._set(tuple(renamed if pin is found else pin for pin in self.pinned))

    def clear(self) -> None:
        """Let all runs go."""
        self._set(())

    def find(self, label: str) -> Pinned:
        """A pinned run by its label. InputError : there is none."""
        for pin in self.pinned:
            if pin.label == label:
                return pin
        known = ", ".join(pin.label for pin in self.pinned) or "none so far"
        raise InputError(f"label must be one of the pinned runs ({known}), got {label!r}")

    def with_run(self, run: Run | None) -> tuple[Pinned, ...]:
        """The pinned runs, and the one on show where it has a step and is not among them."""
        if run is None or self.of(run) is not None:
            return self.pinned
        name = _unlike("this run", [pin.label for pin in self.pinned])
        found = taken(run, name, preset_of(run.scenario), THIS_RUN)
        return self.pinned if found is None else (*self.pinned, found)

    def differences(self, run: Run | None = None) -> list[Row]:
        """Settings that are not the same in all pinned runs, and in the run on show if given."""
        return differences(self.with_run(run))

    def key_figures(self, run: Run | None = None) -> list[Row]:
        """What the pinned runs came to, and the run on show if given."""
        return key_figures(self.with_run(run))

    def _set(self, pinned: tuple[Pinned, ...]) -> None:
        self.pinned = pinned
        for tell in list(self._told):
            tell()


def _checked(label: str) -> str:
    name = " ".join(label.split())
    if not 1 <= len(name) <= LONGEST:
        raise InputError(f"label must have 1 to {LONGEST} characters, got {len(name)}")
    return name


def _unlike(label: str, taken_already: list[str]) -> str:
    """A label, with a number where another run has it."""
    numbered = (f"{label} ({number})" for number in count(2))
    return (
        label
        if label not in taken_already
        else next(name for name in numbered if name not in taken_already)
    )
