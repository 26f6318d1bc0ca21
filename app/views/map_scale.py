"""The scale of a map's colours: two linear halves, a small pull is seen beside a big push."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from bokeh.palettes import Blues256, Cividis256, Oranges256

from ..plain_words import true_minus

#: limits are such numbers, whose halves are short, times a power of ten
_LIMITS = (1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
#: room that a limit gets when it has to grow while a run goes on
_ROOM = 1.5
#: what a run has not shown anything of yet
_LEAST = 1e-9
_MAGNITUDES = tuple(Cividis256)
#: pulled orange, pressed blue, neither pale
_SIGNED = (*Oranges256, *reversed(Blues256))


def leap(value: float) -> float:
    """The least short number that is not less than a value > 0."""
    power = 10.0 ** math.floor(math.log10(value))
    return next((n * power for n in _LIMITS if n * power >= value * (1 - 1e-12)), 10 * power)


@dataclass(frozen=True)
class Scale:
    """From `low` <= 0 to `high` >= 0, each half linear by itself; values in the unit shown.

    Attributes
    ----------
    fixed : `high` stays what it is, and what is beyond is marked as such.
    """

    low: float = 0.0
    high: float = 0.0
    fixed: bool = False

    @property
    def palette(self) -> tuple[str, ...]:
        return _SIGNED if self.low else _MAGNITUDES

    def holding(self, low: float, high: float, room: float = _ROOM) -> Scale:
        """This scale where it holds values from `low` to `high`, or one that does; never less."""
        grown = self
        if low < min(self.low, -_LEAST) and math.isfinite(low):
            grown = replace(grown, low=-leap(-low * room))
        if high > max(self.high, _LEAST) and math.isfinite(high) and not self.fixed:
            grown = replace(grown, high=leap(high * room))
        return grown

    def place(self, values: np.ndarray) -> np.ndarray:
        """Where values lie: 0 at zero, 1 at `high`, -1 at `low`; float32, NaN where they are."""
        placed = values / (self.high or 1.0)
        if self.low:
            placed = np.where(values < 0, values / -self.low, placed)
        return placed.astype(np.float32)

    @property
    def ticks(self) -> dict[float, str]:
        """Place -> label, five of them."""
        places = (-1.0, -0.5, 0.0, 0.5, 1.0) if self.low else (0.0, 0.25, 0.5, 0.75, 1.0)
        high = self.high or 1.0
        return {at: true_minus(f"{at * (high if at >= 0 else -self.low):.3g}") for at in places}
