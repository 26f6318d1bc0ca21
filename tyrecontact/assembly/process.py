"""From settings to what is done to road and tread."""

from __future__ import annotations

from tyrecontact import loading
from tyrecontact.parts.process import Loading


def loading_path(settings: Loading) -> loading.Path:
    """The path of the road that the settings of the loading stand for."""
    if settings.profile == "linear":
        return loading.linear(settings.max_indentation, settings.rate)
    if settings.profile == "quadratic":
        return loading.quadratic(settings.max_indentation, settings.acceleration)
    return loading.load_hold_unload(
        settings.max_indentation,
        settings.rate,
        settings.hold_time,
        settings.unloading_rate,
        settings.retraction,
    )
