"""Findings about one panel on its own: edges, area, size, self-intersections."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.curve import Arc
from swifttailor.pattern.finding import Finding, Severity
from swifttailor.pattern.finding_kinds import found
from swifttailor.pattern.panel import Panel

ZERO_LENGTH_CM = 1e-6
"""Shorter edges have no direction that floating-point numbers can carry through a placement."""
SLIVER_EDGE_CM = 0.01
"""No cloth is cut to a tenth of a millimetre; GarmentCode's own patterns have a few such edges."""
SLIVER_PANEL_CM = 0.1
NO_AREA_CM = 1e-3
LARGE_PANEL_CM = 400.0
ABSURD_PANEL_CM = 5000.0
RADIUS_ROUNDING = 1e-4
"""Relative amount by which a radius may fall short of half the chord: files with four digits do."""


def check_panel(outline: Outline) -> list[Finding]:
    """All findings about one panel's shape."""
    return [
        *_short_edges(outline),
        *_short_radii(outline.panel),
        *_area_and_size(outline),
        *_self_crossing(outline),
    ]


def radius_needed(panel: Panel, edge: int) -> float | None:
    """Half the chord, cm, of an arc whose radius cannot span it; None where the edge is sound."""
    curve = panel.edges[edge].curve
    if not isinstance(curve, Arc):
        return None
    chord = panel.chord(edge)
    half = float(np.hypot(*(chord[1] - chord[0]))) / 2
    return half if curve.radius < half * (1 - RADIUS_ROUNDING) else None


def _short_edges(outline: Outline) -> list[Finding]:
    findings = []
    for k in np.flatnonzero(outline.lengths < SLIVER_EDGE_CM):
        length = float(outline.lengths[k])
        code = "zero-length-edge" if length < ZERO_LENGTH_CM else "sliver-edge"
        text = f"the edge is only {length:.2g} cm long"
        findings.append(found(code, text, panel=outline.panel.name, edge=int(k), value=length))
    return findings


def _short_radii(panel: Panel) -> list[Finding]:
    findings = []
    for k, edge in enumerate(panel.edges):
        half = radius_needed(panel, k)
        if half is not None and isinstance(edge.curve, Arc):
            radius = edge.curve.radius
            text = f"the arc's radius {radius:.6g} cm is below half its chord ({half:.6g} cm)"
            findings.append(found("short-radius", text, panel=panel.name, edge=k, value=radius))
    return findings


def _area_and_size(outline: Outline) -> list[Finding]:
    findings = []
    width, size, name = outline.mean_width, outline.size, outline.panel.name
    if width < SLIVER_PANEL_CM:
        if width < NO_AREA_CM:
            code, text = "no-area", "the outline encloses no area"
        else:
            code, text = "sliver-panel", f"the panel is only {width:.2g} cm wide"
        findings.append(found(code, text, panel=name, value=width))
    if size > LARGE_PANEL_CM:
        text, worse = f"the panel is {size:.0f} cm long", {}
        if size > ABSURD_PANEL_CM:
            worse = {"severity": Severity.ERROR, "why": "cloth that large cannot be draped"}
        findings.append(found("oversized-panel", text, panel=name, value=size, **worse))
    return findings


def _self_crossing(outline: Outline) -> list[Finding]:
    crossing = find_crossing(outline)
    if crossing is None:
        return []
    a, b = sorted(crossing.edges)
    place = f"edge {a} turns back on itself" if a == b else f"edges {a} and {b} meet"
    more = f"; {crossing.places} places in all" if crossing.places > 1 else ""
    at = f"near ({crossing.point[0]:.2f}, {crossing.point[1]:.2f}) cm{more}"
    depth = crossing.depth if np.isfinite(crossing.depth) else None
    if crossing.kind == "crossing":
        deep = "again and again" if depth is None else f"by {depth:.2g} cm"
        code, what = "self-crossing", f"crosses itself {deep}"
    elif crossing.kind == "noise":
        code, what = "near-crossing", f"overlaps itself by {depth:.2g} cm"
    else:
        code, what = "self-touching", "touches itself"
    text = f"the outline {what}: {place} {at}"
    return [found(code, text, panel=outline.panel.name, edge=a, value=depth)]
