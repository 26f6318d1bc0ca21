"""What was computed last, for those who ask the same again: no step needs it twice."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, TypeVar, TypeVarTuple

_Asked = TypeVarTuple("_Asked")
_Value = TypeVar("_Value")


class Latest(Generic[*_Asked, _Value]):
    """A function that keeps its last answer, for as long as it is asked about the same objects.

    The same means identical: arrays inside must not be written to in between.
    """

    def __init__(self, function: Callable[[*_Asked], _Value]) -> None:
        self._function = function
        self._kept: tuple[tuple[object, ...], _Value] | None = None

    def __call__(self, *asked: *_Asked) -> _Value:
        objects: tuple[object, ...] = (*asked,)
        kept = self._kept  # another thread may replace it meanwhile
        if kept is not None and all(a is b for a, b in zip(kept[0], objects, strict=True)):
            return kept[1]
        value = self._function(*asked)
        self._kept = objects, value
        return value
