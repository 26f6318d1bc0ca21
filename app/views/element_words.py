"""One element at one step, said in a sentence."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tyrecontact.contact.bonds import ElementState

from .headline import three_digits

INVITATION = "Tap an element of the map to follow it."
WAITING = "Element row {}, column {} is followed in the next run."
OFFER = "Choose it by row and column"


def say(row: int, column: int, fields: Mapping[str, np.ndarray], element_area: float) -> str:
    """What an element of an area [m2] does at the step that the fields are of."""
    here = {name: float(field[row, column]) for name, field in fields.items()}
    return f"Element row {row}, column {column}: {_doing(here, element_area)}."


def _doing(here: Mapping[str, float], element_area: float) -> str:
    state, depth = int(here["state"]), here["compression"] * 1e6
    if state == ElementState.RELEASED:
        return "its bond broke in this step"
    if state == ElementState.APART:
        if depth > 0:
            return "it carries no force, its dent has not recovered"
        return f"apart, {three_digits(-depth)} µm from touching"
    share = three_digits(100 * here["contact_area"] / element_area)
    age = f"in contact for {three_digits(here['age'] * 1e3)} ms"
    force, depth_said = three_digits(abs(here["element_force"])), three_digits(abs(depth))
    if state == ElementState.TENSION:
        way = f"{'drawn out' if depth < 0 else 'still compressed'} by {depth_said} µm"
        return f"pulled with {force} N, {way}, {age}, {share} % of its area held by its bond"
    way = f"compressed by {depth_said} µm"
    return f"pressed with {force} N, {way}, {age}, {share} % of its area touches"
