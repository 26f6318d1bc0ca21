"""A component that is told its state many times a second."""

from __future__ import annotations

from typing import Any

import param
from panel.custom import JSComponent


class Told(JSComponent):
    """The browser hears of a new state by a message.

    A change of a parameter goes through the models of the page, ten times as slowly, and holds
    up the solver meanwhile.

    Attributes
    ----------
    state : as last told; what a browser that comes later begins with.
    """

    state = param.Dict(default={})

    __abstract = True

    def tell(self, state: dict[str, Any]) -> None:
        """Show another state; nothing is sent where it is the same."""
        if state != self.state:
            with param.parameterized.discard_events(self):
                self.state = state
            self._send_msg(state)
