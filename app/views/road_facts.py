"""What was understood of a road file, as a table to be confirmed by who brought it."""

from __future__ import annotations

from html import escape

from tyrecontact.road.profile_depth import SEGMENT
from tyrecontact.road.understood import Understood

from .headline import three_digits

_ORIGIN = {"file": "from the file", "given": "given by you"}
_BANNERS = {
    "success": ("✓", "#009E73"), "info": ("…", "#0072B2"),
    "warning": ("⚠", "#E69F00"), "error": ("✕", "#D55E00"),
}  # fmt: skip
#: shown while a file is worked on
BUSY = (
    '<progress aria-label="Working on the file" style="display:block;width:100%;height:6px">'
    "</progress>"
)
_UNIT = {"um": "µm"}
_ROW = (
    '<tr><th scope="row" style="text-align:left;font-weight:400;padding:1px 12px 1px 0;'
    'vertical-align:top;white-space:nowrap;opacity:.85">{}</th>'
    '<td style="padding:1px 0;overflow-wrap:anywhere">{}</td></tr>'
)


def facts(found: Understood) -> list[tuple[str, str]]:
    """Name and value of each, with units: what the file is, how large, how rough."""
    size = " × ".join(three_digits(length * 1e3) for length in reversed(found.extent))
    count = " × ".join(f"{n:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")
                       for n in reversed(found.shape))  # fmt: skip
    unit = _UNIT.get(found.unit, found.unit)
    rows = [
        ("File", found.name),
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
    """The facts and what was done to the heights, as HTML."""
    rows = "".join(_ROW.format(name, escape(value)) for name, value in facts(found))
    listed = "".join(f"<li>{escape(_sentence(clause))}</li>" for clause in found.done)
    return (
        '<div style="font-size:13px;line-height:1.45;color:currentColor">'
        f'<table style="border-collapse:collapse">{rows}</table>'
        f'<ul style="margin:6px 0 0;padding-left:18px">{listed}</ul></div>'
    )


def banner(kind: str, text: str) -> str:
    """A sentence that is "success", "info", "warning" or "error" (told by a sign, too), as HTML."""
    sign, color = _BANNERS[kind]
    return (
        f'<div role="status" style="border-left:5px solid {color};border-radius:4px;'
        "padding:8px 12px;font-size:14px;line-height:1.4;"
        f'background:color-mix(in srgb, {color} 12%, transparent)">'
        f'<span aria-hidden="true">{sign}</span> {escape(text)}</div>'
    )


def line(text: str) -> str:
    """A small line on a file, as HTML: a visitor's file name may hold anything."""
    return f'<div role="status" style="font-size:12px;line-height:1.4">{escape(text)}</div>'


def _share(missing: float) -> str:
    return f"{three_digits(missing * 100)} % of the heights" if missing else "none"


def _sentence(clause: str) -> str:
    return f"{clause[:1].upper()}{clause[1:]}."
