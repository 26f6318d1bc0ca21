"""Numbers as the table says them."""

from __future__ import annotations

import numpy as np


def at_depth(depth: float) -> str:
    """An indentation [m], or that it is nowhere."""
    return f"at {depth * 1e3:.3g} mm" if np.isfinite(depth) else "nowhere"


def percent(share: float) -> str:
    """A share with its sign."""
    return f"{signed(100 * share, '+.1f')} %"


def percents(shares: np.ndarray) -> str:
    """Several shares."""
    return ", ".join(map(percent, shares))


def signed(value: float, form: str = "+.3g") -> str:
    """A number with its sign, as a true minus."""
    return format(value, form).replace("-", "−")
