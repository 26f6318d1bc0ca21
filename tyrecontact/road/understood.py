"""What was understood of a road file, in numbers and in words, to be confirmed by who gave it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from tyrecontact.road.profile_depth import SEGMENT, mean_profile_depth
from tyrecontact.road.scan import Scan

#: a road steeper than this on the average was read in a wrong unit, or is no road
_STEEP = 5.0


@dataclass(frozen=True)
class Understood:
    """Facts and figures of a road file.

    Attributes
    ----------
    name, kind : of the file. `profile`: a line, not a map.
    shape : number of heights (y, x), or (n,). extent : (y, x) or (x,) [m].
    pitch : [m], with its origin, "file" or "given"; unit of the heights, with its origin.
    missing_share : of the heights in the file [-].
    rms [m], rms_slope [-], skewness [-] : of the valid heights, after what was `done`.
    span : highest less lowest [m].
    mean_profile_depth : ISO 13473-1 [m] over segments of depth_segment [m] (100 mm, or the length
        of a shorter road, which gives less); None where it cannot be told.
    done : what was done, one clause each. doubts : what looks wrong.
    """

    name: str
    kind: str
    profile: bool
    shape: tuple[int, ...]
    extent: tuple[float, ...]
    pitch: float
    pitch_origin: str
    unit: str
    unit_origin: str
    missing_share: float
    rms: float
    rms_slope: float
    skewness: float
    span: float
    mean_profile_depth: float | None
    depth_segment: float | None
    done: tuple[str, ...]
    doubts: tuple[str, ...]

    def lines(self) -> list[str]:
        """The same in words, a fact a line."""
        size = " x ".join(f"{length * 1e3:.4g}" for length in reversed(self.extent))
        count = " x ".join(str(n) for n in reversed(self.shape))
        depth = "cannot be told"
        if self.mean_profile_depth is not None and self.depth_segment is not None:
            over = f"over {self.depth_segment * 1e3:.3g} mm"
            short = ", not the 100 mm of ISO 13473-1" if self.depth_segment < SEGMENT else ""
            depth = f"{self.mean_profile_depth * 1e3:.3g} mm {over}{short}"
        return [
            f"{self.name}: {'profile' if self.profile else 'map'} ({self.kind})",
            f"extent              {size} mm, {count} heights",
            f"pitch               {self.pitch * 1e6:.4g} µm ({self.pitch_origin})",
            f"unit of heights     {self.unit} ({self.unit_origin})",
            f"missing             {self.missing_share:.2%}",
            f"rms                 {self.rms * 1e6:.4g} µm",
            f"rms slope           {self.rms_slope:.3g}",
            f"highest to lowest   {self.span * 1e6:.4g} µm",
            f"mean profile depth  {depth}",
            f"skewness            {self.skewness:.3g}",
            *(f"- {clause}" for clause in self.done),
            *(f"! {doubt}" for doubt in self.doubts),
        ]

    def sentence(self) -> str:
        """The same in one line, for a status."""
        size = " x ".join(f"{length * 1e3:.3g}" for length in reversed(self.extent))
        told = [
            f"{size} mm, pitch {self.pitch * 1e6:.3g} µm ({self.pitch_origin})",
            f"heights in {self.unit} ({self.unit_origin})",
            f"rms {self.rms * 1e6:.3g} µm",
            f"rms slope {self.rms_slope:.2g}",
            f"skewness {self.skewness:.2g}",
        ]
        if self.missing_share:
            told.append(f"{self.missing_share:.1%} missing")
        return ", ".join(told) + "".join(f"; {text}" for text in (*self.done, *self.doubts)) + "."

    def to_dict(self) -> dict[str, Any]:
        """Plain values by name."""
        return asdict(self)


def understood(scan: Scan) -> Understood:
    """Facts and figures of a scan as it is now; level it first, or its tilt counts as roughness."""
    heights = scan.heights[scan.valid]
    mean = heights.mean()
    rms, span = float(heights.std()), float(np.ptp(heights))
    skewness = float((((heights - mean) / rms) ** 3).mean()) if rms else 0.0
    slope = _rms_slope(scan)
    depth = mean_profile_depth(scan.heights, scan.pitch)
    doubts = []
    if slope > _STEEP:
        doubts.append(f"an rms slope of {slope:.3g} is that of no road: check pitch and unit")
    if not span:
        doubts.append("all heights are equal")
    return Understood(
        name=scan.name,
        kind=scan.kind,
        profile=scan.is_profile,
        shape=scan.heights.shape,
        extent=scan.extent,
        pitch=scan.pitch,
        pitch_origin=scan.pitch_origin,
        unit=scan.unit,
        unit_origin=scan.unit_origin,
        missing_share=scan.missing_share,
        rms=rms,
        rms_slope=slope,
        skewness=skewness,
        span=span,
        mean_profile_depth=depth.depth if depth else None,
        depth_segment=depth.segment if depth else None,
        done=scan.done,
        doubts=tuple(doubts),
    )


def _rms_slope(scan: Scan) -> float:
    """Root mean square of the gradient's magnitude, where neighbours are both there [-]."""
    total = 0.0
    for axis in range(scan.heights.ndim):
        step = np.diff(scan.heights, axis=axis) / scan.pitch
        step = step[np.isfinite(step)]
        total += float((step**2).mean()) if step.size else 0.0
    return float(np.sqrt(total))
