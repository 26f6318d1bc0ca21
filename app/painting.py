"""How the browser paints the plots: less of it, where it would be the same. Without a look."""

from __future__ import annotations

from pathlib import Path

from panel.custom import JSComponent


class Painting(JSComponent):
    """Holds for all plots of the page that it is in."""

    _esm = Path(__file__).parent / "painting.js"
