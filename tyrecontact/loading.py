"""How the road is moved into the tread: indentation against time (physics, section 7)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tyrecontact.errors import InputError

#: more steps than this are refused: a slip of a unit, not a study
MAX_STEPS = 500_000


@dataclass(frozen=True)
class Path:
    """Indentation along straight lines between knots, or as a power of time up to a maximum.

    Attributes
    ----------
    time, indentation : knots [s] and [m], shape (knots,), time increasing.
    power : 1 for straight lines; 2 for the square of time between two knots.
    """

    time: np.ndarray
    indentation: np.ndarray
    power: int = 1

    def sampled(self, time_step: float) -> tuple[np.ndarray, np.ndarray]:
        """Times [s] and indentations [m] of all steps, from rest to the end of the path.

        Each leg takes a whole number of steps, so that every knot is met by a step and no step
        is cut short, which would be a jump of the rate. A leg shorter than a step takes one.

        Raises
        ------
        InputError : the path takes more than `MAX_STEPS` steps, or fewer than three.
        """
        legs = np.maximum(np.rint(np.diff(self.time) / time_step), 1)
        steps = legs.sum() + 1
        if not 3 <= steps <= MAX_STEPS:
            raise InputError(
                f"loading must take 3 to {MAX_STEPS} steps, got {steps:.0f} "
                f"({self.time[-1]:.4g} s in steps of {time_step:.4g} s)"
            )
        knots = np.concatenate([[0.0], np.cumsum(legs)])
        step = np.arange(knots[-1] + 1)
        if self.power == 1:
            return step * time_step, np.interp(step, knots, self.indentation)
        return step * time_step, self.indentation[-1] * (step / knots[-1]) ** self.power


def linear(max_indentation: float, rate: float) -> Path:
    """At a constant rate [m/s] to the largest indentation [m]."""
    return Path(np.array([0, max_indentation / rate]), np.array([0, max_indentation]))


def quadratic(max_indentation: float, acceleration: float) -> Path:
    """At a constant acceleration [m/s2] from rest; the thesis' C is half of it."""
    duration = np.sqrt(2 * max_indentation / acceleration)
    return Path(np.array([0, duration]), np.array([0, max_indentation]), power=2)


def load_hold_unload(
    max_indentation: float,
    rate: float,
    hold_time: float,
    unloading_rate: float,
    retraction: float,
) -> Path:
    """Down at `rate` [m/s], held for `hold_time` [s], up at `unloading_rate` [m/s].

    The road ends `retraction` [m] above where it first touched, so that every bond can part.
    """
    legs = np.array([0, max_indentation / rate, hold_time, 0])
    legs[3] = (max_indentation + retraction) / unloading_rate
    knots = np.array([0, max_indentation, max_indentation, -retraction])
    kept = np.concatenate([[True], legs[1:] > 0])
    return Path(np.cumsum(legs)[kept], knots[kept])
