"""The results of the thesis, figure by figure: each a small family of scenarios.

`find("44")` is a figure, `scenario("fig-44/14-N")` one of its members.
"""

from tyrecontact.figures import families
from tyrecontact.figures.base import at_rest, dynamic, sticky
from tyrecontact.figures.registry import FIGURES, Figure, find, member, scenario

__all__ = [
    "FIGURES", "Figure", "at_rest", "dynamic", "families", "find", "member", "scenario", "sticky",
]  # fmt: skip
