"""What was understood of a road file, as a table to be confirmed by who brought it."""

from __future__ import annotations

from html import escape

from tyrecontact.road.profile_depth import SEGMENT
from tyrecontact.road.understood import Understood

from .headline import three_digits

_ORIGIN = {"file": "from the file", "given": "given by you"}
_UNIT = {"um": "µm"}
_ROW = (
    '<tr><th scope="row" style="text-align:left;font-weight:400;padding:1px 12px 1px 0;'
    'vertical-align:top;white-space:nowrap;opacity:.85">{}</th><td style="padding:1px 0">{}</td>'
    "</tr>"
)


def facts(found: Understood) -> list[tuple[str, str]]:
    """Name and value of each, with units: what the file is, how large, how rough."""
    size = " × ".join(three_digits(length * 1e3) for length in reversed(found.extent))
    count = " × ".join(f"{n:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")
                       for n in reversed(found.shape))  # fmt: skip
    unit = _UNIT.get(found.unit, found.unit)
    rows = [
        ("Kind", f"{'profile' if found.profile else 'map'} ({found.kind})"),
        ("Extent", f"{size} mm, {count} heights"),
        ("Pitch", f"{three_digits(found.pitch * 1e6)} µm, {_ORIGIN[found.pitch_origin]}"),
        ("Unit of heights", f"{unit}, {_ORIGIN[found.unit_origin]}"),
        ("Drop-outs", _share(found.missing_share)),
        ("Roughness (rms)", f"{three_digits(found.rms * 1e6)} µm"),
        ("Rms slope", three_digits(found.rms_slope)),
        ("Lowest to highest", f"{three_digits(found.span * 1e6)} µm"),
        ("Skewness", three_digits(found.skewness)),
    ]
    if found.mean_profile_depth is not None and found.depth_segment is not None:
        over = f"over {three_digits(found.depth_segment * 1e3)} mm"
        short = ", not the 100 mm of ISO 13473-1" if found.depth_segment < SEGMENT else ""
        depth = f"{three_digits(found.mean_profile_depth * 1e3)} mm {over}{short}"
        rows.append(("Mean profile depth", depth))
    return rows


def table(found: Understood) -> str:
    """The facts, what was done to the heights, and what looks wrong, as HTML."""
    rows = "".join(_ROW.format(name, escape(value)) for name, value in facts(found))
    told = [_sentence(clause) for clause in found.done]
    doubts = [f"⚠ {_sentence(doubt)}" for doubt in found.doubts]
    listed = "".join(f"<li>{escape(text)}</li>" for text in (*doubts, *told))
    return (
        '<div style="font-size:13px;line-height:1.45;color:currentColor">'
        f'<table style="border-collapse:collapse">{rows}</table>'
        f'<ul style="margin:6px 0 0;padding-left:18px">{listed}</ul></div>'
    )


def _share(missing: float) -> str:
    return f"{three_digits(missing * 100)} % of the heights" if missing else "none"


def _sentence(clause: str) -> str:
    return f"{clause[:1].upper()}{clause[1:]}."
