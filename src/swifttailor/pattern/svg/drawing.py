"""The whole drawing: panels on a sheet, seams marked in pairs, a scale bar and a legend."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from swifttailor.atomic_files import write_text
from swifttailor.pattern import curve as curves
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch
from swifttailor.pattern.svg.paths import edge_path, number, outline_path
from swifttailor.pattern.svg.placing import PlacedPanel, place_panel, shelves

PALETTE = (
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9",
    "#b07d00", "#7b3294", "#5a6b00", "#a6303f", "#00736f",
)  # fmt: skip
"""Seam colours: Okabe and Ito's, without their yellow, which white paper swallows; then four darker ones."""

GATHER_RATIO = 1.05
"""A seam whose edges differ in length by more than this is drawn as gathered on the longer one."""


@dataclass(frozen=True)
class _Seam:
    number: int
    color: str
    kind: str
    """``seam``, ``dart`` or ``gather`` (on the longer edge)."""
    title: str


def pattern_to_svg(pattern: Pattern) -> str:
    """Draws a pattern as SVG, 1:1 when printed at 100 %.

    Every panel is seen from the right side of the cloth, upright as in its own coordinates, without overlap.
    Edges are exact path commands. The two edges of a stitch share a colour and a number, the stitch's index
    in the pattern; free edges are grey. Line widths and letters grow with the sheet, so that a sheet of many
    metres stays readable on a screen.

    Args:
        pattern: Any pattern.

    Returns:
        The SVG document; lengths in millimetres.
    """
    seams = _seams(pattern)
    extents = np.array([np.ptp(p.bounding_box(), axis=0) for p in pattern.panels]).reshape(-1, 2) * 10.0
    unit = float(np.clip(np.sqrt((extents + 20.0).prod(axis=1).sum()) / 95.0, 2.5, 150.0))
    placed = [place_panel(k, p, unit) for k, p in enumerate(pattern.panels)]
    sizes = np.array([p.size for p in placed]).reshape(-1, 2)
    gap = 3.0 * unit
    corners, sheet = shelves(sizes, gap) if placed else (np.zeros((0, 2)), np.zeros(2))
    border = 3.0 * unit
    footer = 8.0 * unit
    width = max(float(sheet[0]), 62.0 * unit) + 2 * border
    height = float(sheet[1]) + 2 * border + footer
    body = [_panel(item, corner + border, seams, unit) for item, corner in zip(placed, corners, strict=True)]
    kinds = {s.kind for s in seams.values()}
    if len(seams) < sum(len(p.edges) for p in pattern.panels):
        kinds.add("free")
    w, h = _short(width), _short(height)
    return "\n".join(
        [
            '<?xml version="1.0" encoding="UTF-8"?>',
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="0 0 {w} {h}">',
            f"<title>{escape(_clean(pattern.name))}</title>",
            "<desc>Sewing pattern, 1 unit = 1 mm; panels seen from the right side of the cloth.</desc>",
            f"<style>{_style(unit)}</style>",
            f'<rect class="sheet" width="{w}" height="{h}"/>',
            *body,
            _footer(pattern, kinds, border, height - border, width - 2 * border, unit),
            "</svg>",
            "",
        ]
    )


def write_svg(pattern: Pattern, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes `pattern_to_svg` to a file, over another of that name where `overwrite`; returns its path."""
    return write_text(path, pattern_to_svg(pattern), overwrite=overwrite)


def _style(unit: float) -> str:
    thin, thick = _short(0.10 * unit), _short(0.22 * unit)
    rules = (
        ".sheet{fill:#ffffff}",
        ".cloth{fill:#f4f1ec;stroke:none}",
        f".edge{{fill:none;stroke-width:{thick};stroke-linecap:round;stroke-linejoin:round}}",
        f".free{{stroke:#55524e;stroke-width:{thin}}}",
        f".dart{{stroke-dasharray:{_short(0.05 * unit)} {_short(0.45 * unit)}}}",
        f".gather{{stroke-dasharray:{_short(0.8 * unit)} {_short(0.45 * unit)}}}",
        "text{font-family:Helvetica,Arial,'DejaVu Sans',sans-serif;text-anchor:middle;"
        "dominant-baseline:central}",
        ".name{fill:#3a3835}",
        ".legend{fill:#6b6762;text-anchor:start}",
        f".number{{font-size:{_short(0.66 * unit)}px;font-weight:bold}}",
        f".bar{{fill:none;stroke:#3a3835;stroke-width:{_short(0.14 * unit)}}}",
    )
    return "".join(rules)


def _seams(pattern: Pattern) -> dict[EdgeRef, _Seam]:
    """How to draw each stitched edge."""
    seams: dict[EdgeRef, _Seam] = {}
    for k, stitch in enumerate(pattern.stitches):
        if not all(pattern.has_edge(side) for side in stitch.sides):
            continue
        lengths = [pattern.edge_length(side) for side in stitch.sides]
        dart = _is_dart(pattern, stitch)
        for side, other, own, its in (
            (stitch.first, stitch.second, *lengths),
            (stitch.second, stitch.first, *lengths[::-1]),
        ):
            gathered = own > GATHER_RATIO * its + 0.05
            kind = "gather" if gathered else "dart" if dart else "seam"
            title = f"stitch {k}: to {other.panel}, edge {other.edge}; {own:.1f} cm"
            title += f" gathered to {its:.1f} cm" if gathered else ""
            title += "; right side to wrong side" if stitch.right_wrong else ""
            seams[side] = _Seam(k, PALETTE[k % len(PALETTE)], kind, title)
    return seams


def _is_dart(pattern: Pattern, stitch: Stitch) -> bool:
    """Whether a stitch closes two neighbouring edges of one panel."""
    if stitch.first.panel != stitch.second.panel:
        return False
    count = len(pattern.panel(stitch.first.panel).edges)
    return (stitch.first.edge - stitch.second.edge) % count in (1, count - 1)


def _panel(item: PlacedPanel, corner: np.ndarray, seams: dict[EdgeRef, _Seam], unit: float) -> str:
    """One panel at the upper left `corner` (2,) of its place, mm."""
    panel = item.panel
    shift_x, shift_y = corner[0] - item.low[0], corner[1] + item.low[1] + item.size[1]
    name = _clean(panel.name)
    parts = [
        f'<g class="panel" data-panel={quoteattr(name)} data-mirrored="{int(item.mirrored)}" '
        f'transform="translate({number(float(shift_x))} {number(float(shift_y))})">',
        f'<path class="cloth" d="{outline_path(panel)}"/>',
    ]
    marks = []
    for k in range(len(panel.edges)):
        path = edge_path(panel, k)
        seam = seams.get(EdgeRef(panel.name, k))
        if seam is None:
            length = f"free edge {k}: {panel.edge_length(k):.1f} cm"
            parts.append(f'<path class="edge free" data-edge="{k}" d="{path}"><title>{length}</title></path>')
            continue
        parts.append(
            f'<path class="edge {seam.kind}" data-edge="{k}" data-stitch="{seam.number}" '
            f'stroke="{seam.color}" d="{path}"><title>{escape(_clean(seam.title))}</title></path>'
        )
        marks.append(_seam_number(item, k, seam, unit))
    parts += [m for m in marks if m]
    caption = item.caption
    parts.append(
        f'<text class="name" x="{_short(caption.x)}" y="{_short(-caption.y)}" '
        f'font-size="{_short(caption.size)}">{escape(name)}</text>'
    )
    parts.append("</g>")
    return "\n".join(parts)


def _seam_number(item: PlacedPanel, edge: int, seam: _Seam, unit: float) -> str:
    """The stitch's number just inside the middle of an edge; nothing on edges too short for it."""
    panel = item.panel
    chord, curve = panel.chord(edge), panel.edges[edge].curve
    if 10.0 * panel.edge_length(edge) < 0.9 * unit:
        return ""
    middle = curves.parameters_by_length(curve, chord, [0.5])
    point = curves.evaluate(curve, chord, middle)[0] * 10.0
    along = curves.derivative(curve, chord, middle)[0]
    norm = float(np.hypot(*along))
    if norm == 0.0:
        return ""
    # The panel is drawn right side up, so its loop runs anticlockwise: inside is to the left.
    inward = np.array([-along[1], along[0]]) / norm
    x, y = point + 0.62 * unit * inward
    return f'<text class="number" x="{_short(x)}" y="{_short(-y)}" fill="{seam.color}">{seam.number}</text>'


def _footer(pattern: Pattern, kinds: set[str], left: float, bottom: float, width: float, unit: float) -> str:
    """Scale bar, title and what the marks mean."""
    bar = next((b for b in (10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0) if b >= 6 * unit), 2000.0)
    label = f"{bar / 10:g} cm" if bar < 1000 else f"{bar / 1000:g} m"
    y, tick = bottom - 2.2 * unit, 0.35 * unit
    x0, x1 = left, left + bar
    count = len(pattern.panels), len(pattern.stitches)
    title = f"{_clean(pattern.name)}: {count[0]} panels, {count[1]} stitches"
    size = min(unit, width / (0.58 * max(len(title), 1)))
    note = "seen from the right side of the cloth; print at 100 %"
    marks = [
        ("edge seam", f'stroke="{PALETTE[0]}"', "seam (equal numbers meet)"),
        ("edge gather", f'stroke="{PALETTE[0]}"', "gathered"),
        ("edge dart", f'stroke="{PALETTE[0]}"', "dart"),
        ("edge free", "", "free edge"),
    ]
    marks = [m for m in marks if m[0].split()[1] in kinds]
    small = 0.8 * unit
    parts = ['<g class="footer">']
    parts.append(
        f'<text class="legend" x="{_short(left)}" y="{_short(bottom - 4.6 * unit)}" '
        f'font-size="{_short(size)}">{escape(title)}</text>'
    )
    parts.append(
        f'<path class="bar" data-length="{_short(bar)}" d="M{_short(x0)},{_short(y - tick)}'
        f"V{_short(y + tick)}M{_short(x0)},{_short(y)}H{_short(x1)}"
        f'M{_short(x1)},{_short(y - tick)}V{_short(y + tick)}"/>'
    )
    parts.append(
        f'<text class="legend" x="{_short(x1 + unit)}" y="{_short(y)}" font-size="{_short(small)}">'
        f"{label}, {note}</text>"
    )
    x = left
    for kind, stroke, meaning in marks:
        parts.append(
            f'<path class="{kind}" {stroke} d="M{_short(x)},{_short(bottom)}h{_short(3 * unit)}"/>'
            f'<text class="legend" x="{_short(x + 3.6 * unit)}" y="{_short(bottom)}" '
            f'font-size="{_short(small)}">{meaning}</text>'
        )
        x += (3.6 + 0.58 * 0.8 * len(meaning) + 2.0) * unit
    parts.append("</g>")
    return "\n".join(parts)


def _clean(text: str) -> str:
    """Text without the control characters that XML forbids."""
    return "".join(
        c if c >= " " and not "\ud800" <= c <= "\udfff" and c not in "\ufffe\uffff" else " " for c in text
    )


def _short(value: float) -> str:
    return number(round(float(value), 3))
