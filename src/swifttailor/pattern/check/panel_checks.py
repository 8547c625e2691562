"""Findings about one panel on its own: edges, area, size, self-intersections."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.check.crossings import Crossing, find_crossing
from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.curve import Arc
from swifttailor.pattern.finding import Finding, Severity
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
        zero = length < ZERO_LENGTH_CM
        findings.append(
            Finding(
                "zero-length-edge" if zero else "sliver-edge",
                Severity.ERROR if zero else Severity.WARNING,
                f"the edge is only {length:.2g} cm long",
                panel=outline.panel.name,
                edge=int(k),
                value=length,
                why="an edge without length has no direction and cannot be sampled"
                if zero
                else "no cloth is cut that exactly; tools that round coordinates lose the edge and its seam",
                repair="dropped by --repair together with a partner as short"
                if zero
                else "merge it with its neighbour on both sides of the seam",
            )
        )
    return findings


def _short_radii(panel: Panel) -> list[Finding]:
    findings = []
    for k, edge in enumerate(panel.edges):
        half = radius_needed(panel, k)
        if half is not None and isinstance(edge.curve, Arc):
            findings.append(
                Finding(
                    "short-radius",
                    Severity.WARNING,
                    f"the arc's radius {edge.curve.radius:.6g} cm is below half its chord ({half:.6g} cm)",
                    panel=panel.name,
                    edge=k,
                    value=edge.curve.radius,
                    why="no such circle joins the end points; it is taken for a semicircle, others may fail. "
                    "Radii are absolute: they must change with the end points and the unit",
                    repair="--repair raises the radius to half the chord",
                )
            )
    return findings


def _area_and_size(outline: Outline) -> list[Finding]:
    findings = []
    width, size, name = outline.mean_width, outline.size, outline.panel.name
    if width < SLIVER_PANEL_CM:
        empty = width < NO_AREA_CM
        findings.append(
            Finding(
                "no-area" if empty else "sliver-panel",
                Severity.ERROR if empty else Severity.WARNING,
                "the outline encloses no area" if empty else f"the panel is only {width:.2g} cm wide",
                panel=name,
                value=width,
                why="there is no cloth to sew" if empty else "it is narrower than its own seams",
                repair="remove the panel or move its corners apart",
            )
        )
    if size > LARGE_PANEL_CM:
        absurd = size > ABSURD_PANEL_CM
        findings.append(
            Finding(
                "oversized-panel",
                Severity.ERROR if absurd else Severity.WARNING,
                f"the panel is {size:.0f} cm long",
                panel=name,
                value=size,
                why="cloth that large cannot be draped"
                if absurd
                else "rarely meant (stacked gathered skirts explode like this) and slow to drape",
                repair="check properties.units_in_meter (100 means cm, 1000 mm) and the gather ratios",
            )
        )
    return findings


def _self_crossing(outline: Outline) -> list[Finding]:
    crossing = find_crossing(outline)
    if crossing is None:
        return []
    a, b = sorted(crossing.edges)
    place = f"edge {a} turns back on itself" if a == b else f"edges {a} and {b} meet"
    more = f"; {crossing.places} places in all" if crossing.places > 1 else ""
    at = f"near ({crossing.point[0]:.2f}, {crossing.point[1]:.2f}) cm{more}"
    return [_crossing_finding(crossing, outline.panel.name, a, place, at)]


def _crossing_finding(crossing: Crossing, panel: str, edge: int, place: str, at: str) -> Finding:
    if crossing.kind == "crossing":
        deep = f"by {crossing.depth:.2g} cm" if np.isfinite(crossing.depth) else "again and again"
        return Finding(
            "self-crossing",
            Severity.ERROR,
            f"the outline crosses itself {deep}: {place} {at}",
            panel=panel,
            edge=edge,
            value=crossing.depth if np.isfinite(crossing.depth) else None,
            why="cloth cannot be cut where it would lie in two layers",
            repair="move the corner or bend the edge away; --repair does it within half a centimetre",
        )
    if crossing.kind == "noise":
        return Finding(
            "near-crossing",
            Severity.WARNING,
            f"the outline overlaps itself by {crossing.depth:.2g} cm: {place} {at}",
            panel=panel,
            edge=edge,
            value=crossing.depth,
            why="less than the accuracy of cutting, but meshing programs may refuse it",
            repair="--repair moves the corner or flattens the curve, by half a centimetre at most",
        )
    return Finding(
        "self-touching",
        Severity.INFO,
        f"the outline touches itself: {place} {at}",
        panel=panel,
        edge=edge,
        value=crossing.depth,
        why="it can be cut, but two parts of the outline coincide there",
    )
