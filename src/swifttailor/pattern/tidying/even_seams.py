"""Making both sides of seams that run down to a hem equally long, where they are nearly so."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from swifttailor.pattern import EdgeRef, Panel, Pattern, Stitch
from swifttailor.pattern.check.repair import Change
from swifttailor.pattern.curve import Arc

NEARLY_CM = 12.0
"""Sides of a seam that differ by more are left alone."""
SEEN_CM = 0.3
LEAST_CM = 4.0
"""Shorter edges are no side seams."""


@dataclass(frozen=True)
class _Side:
    """An edge that ends where a hem begins."""

    ref: EdgeRef
    at_end: bool
    """Whether it is the end of the edge that lies at the hem, and not its start."""
    length: float
    """cm."""


def even_seams(pattern: Pattern) -> tuple[Pattern, tuple[Change, ...]]:
    """Gives both sides of such seams their mean length by moving the corners at the hem.

    A skirt whose back is cut longer at the sides than its front hangs unevenly and is drawn awry. Only
    corners between a seam and an edge that is sewn to nothing are moved; gathers have none.
    """
    panels = {p.name: p for p in pattern.panels}
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    changes = []
    for number, stitch in enumerate(pattern.stitches):
        pair = _sides(panels, sewn, stitch)
        if pair is None:
            continue
        apart = abs(pair[0].length - pair[1].length)
        if not SEEN_CM < apart <= NEARLY_CM:
            continue
        mean = (pair[0].length + pair[1].length) / 2
        for side in pair:
            panels[side.ref.panel] = _stretched(panels[side.ref.panel], side, mean / side.length)
        changes.append(
            Change(
                "uneven-hem",
                f"made both sides of this seam equally long, {apart:.2g} cm apart",
                stitch=number,
            )
        )
    if not changes:
        return pattern, ()
    return replace(pattern, panels=tuple(panels[p.name] for p in pattern.panels)), tuple(changes)


def hem_seams(pattern: Pattern) -> Iterator[tuple[Stitch, float, float]]:
    """The seams that run down to a hem, and the lengths of their sides in cm."""
    panels = {p.name: p for p in pattern.panels}
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    for stitch in pattern.stitches:
        pair = _sides(panels, sewn, stitch)
        if pair is not None:
            yield stitch, pair[0].length, pair[1].length


def _sides(panels: dict[str, Panel], sewn: set[EdgeRef], stitch: Stitch) -> tuple[_Side, _Side] | None:
    """Both sides of a seam that ends in a hem with one end each, the ends that are sewn together."""
    first, second = (_side(panels[ref.panel], ref, sewn) for ref in stitch.sides)
    if first is None or second is None or first.ref.panel == second.ref.panel:
        return None
    meet = first.at_end == second.at_end if stitch.right_wrong else first.at_end != second.at_end
    return (first, second) if meet else None


def _side(panel: Panel, ref: EdgeRef, sewn: set[EdgeRef]) -> _Side | None:
    count, length = len(panel.edges), panel.edge_length(ref.edge)
    at_start = EdgeRef(ref.panel, (ref.edge - 1) % count) not in sewn
    at_end = EdgeRef(ref.panel, (ref.edge + 1) % count) not in sewn
    if length < LEAST_CM or not (at_start or at_end):
        return None
    if at_start and at_end:  # from one free border to another: the lower one is the hem
        start, end = panel.to_world(panel.chord(ref.edge))[:, 1]
        at_end = bool(end < start)
    return _Side(ref, at_end, length)


def _stretched(panel: Panel, side: _Side, factor: float) -> Panel:
    """The panel with an edge made longer by a factor, its end at the hem moved along it."""
    count, edge = len(panel.edges), side.ref.edge
    start, end = edge, (edge + 1) % count
    fixed, moved = (start, end) if side.at_end else (end, start)
    vertices = panel.vertices.copy()
    vertices[moved] = vertices[fixed] + factor * (vertices[moved] - vertices[fixed])
    edges = list(panel.edges)
    curve = edges[edge].curve
    # Control points are told from the chord; only radii are absolute.
    if isinstance(curve, Arc):
        edges[edge] = replace(edges[edge], curve=replace(curve, radius=curve.radius * factor))
    return replace(panel, vertices=vertices, edges=tuple(edges))
