"""Figures by name: which there are, what they show, and their members as presets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from tyrecontact.errors import unknown_name
from tyrecontact.scenario import Scenario

Family = Callable[[], dict[str, Scenario]]


@dataclass(frozen=True)
class Figure:
    """Figures of the thesis that show one result.

    Attributes
    ----------
    name : such as "fig-24-26".  numbers : of the thesis' figures; none for what it lacks.
    main : label of the member that stands for the family.
    family : function that makes label -> scenario.
    chapter : of the thesis, "4.2.4"; empty for what it lacks.
    """

    name: str
    numbers: tuple[int, ...]
    main: str
    family: Family
    chapter: str = ""

    @property
    def caption(self) -> str:
        """One line on what it shows, and where it is from."""
        return (self.family.__doc__ or "").strip().partition("\n")[0]

    @property
    def source(self) -> str:
        """Where in the thesis: "Figs. 27-29, chapter 4.2.4"; empty for what it lacks."""
        if not self.numbers:
            return ""
        first, last = self.numbers[0], self.numbers[-1]
        which = f"Fig. {first}" if first == last else f"Figs. {first}-{last}"
        return f"{which}, chapter {self.chapter}"

    @property
    def members(self) -> dict[str, str]:
        """Label -> name by which the member is a preset."""
        return {label: f"{self.name}/{_in_one_word(label)}" for label in self.family()}


def _in_one_word(label: str) -> str:
    """A label without spaces, so that a command line needs no quotes."""
    return label.replace(" = ", "=").replace(" ", "-")


FIGURES: dict[str, Figure] = {}


def figure(first: int, last: int, main: str, chapter: str) -> Callable[[Family], Family]:
    """Register a family as the thesis' figures `first` to `last`; `main` stands for it."""
    name = f"fig-{first}" if first == last else f"fig-{first}-{last}"
    return _registered(name, tuple(range(first, last + 1)), main, chapter)


def beside_the_thesis(name: str, main: str) -> Callable[[Family], Family]:
    """Register a family that the thesis lacks."""
    return _registered(name, (), main)


def _registered(
    name: str, numbers: tuple[int, ...], main: str, chapter: str = ""
) -> Callable[[Family], Family]:
    def register(family: Family) -> Family:
        FIGURES[name] = Figure(name, numbers, main, family, chapter)
        return family

    return register


def find(name: str) -> Figure:
    """The figure of a name, "fig-25" or "25" as well as "fig-24-26".

    Raises
    ------
    InputError : no figure has that name; the nearest is offered.
    """
    for known in FIGURES.values():
        numbers = {str(number) for number in known.numbers}
        if name == known.name or name.removeprefix("fig-") in numbers:
            return known
    raise unknown_name("figure", name, FIGURES)


def scenario(name: str) -> Scenario:
    """The main member of a figure, "fig-44", or any other, "fig-44/62-N".

    Raises
    ------
    InputError : no figure, or none of its members, has that name.
    """
    head, _, member = name.partition("/")
    found = find(head)
    family = found.family()
    labels = {_in_one_word(label): label for label in family}
    if not member:
        return family[found.main]
    if member not in labels:
        raise unknown_name(f"member of {found.name}", member, labels)
    return family[labels[member]]


def member(name: str, label: str) -> Scenario:
    """A member of a figure by its label, "62 N"."""
    return find(name).family()[label]
