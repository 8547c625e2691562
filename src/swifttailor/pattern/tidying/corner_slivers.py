"""Short edges that a network leaves between a seam and a hem, where there ought to be one corner."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import EdgeRef, Panel, Pattern
from swifttailor.pattern.check.repair import Change

ANY_WAY_CM = 1.0
"""A shorter one is left out whichever way it runs."""
ON_CM = 3.5
"""A shorter one is left out where it goes on as the seam does."""
STRAIGHT_ON = 0.75
"""Cosine between seam and sliver from which that is so."""
FEWEST_EDGES = 4
"""A panel with fewer is left as it is."""


def without_corner_slivers(pattern: Pattern) -> tuple[Pattern, tuple[Change, ...]]:
    """Draws seams on to the hem past such edges, which are sewn to nothing themselves.

    Alterations know a hem by the side seams that lead to it, and find none behind a sliver.
    """
    changes: list[Change] = []
    panels: list[Panel] = []
    numbers: dict[EdgeRef, EdgeRef] = {}
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    for panel in pattern.panels:
        names = list(range(len(panel.edges)))
        while len(panel.edges) >= FEWEST_EDGES:
            free = [EdgeRef(panel.name, k) not in sewn for k in names]
            found = next((k for k in range(len(free)) if _is_sliver(panel, k, free)), None)
            if found is None:
                break
            message = f"left out an edge of {panel.edge_length(found):.2g} cm between seam and hem"
            changes.append(Change("corner-sliver", message, panel.name, names[found]))
            panel = _without(panel, found, seam_before=not free[found - 1])
            del names[found]
        panels.append(panel)
        numbers |= {EdgeRef(panel.name, old): EdgeRef(panel.name, new) for new, old in enumerate(names)}
    if not changes:
        return pattern, ()
    stitches = tuple(
        replace(stitch, first=numbers[stitch.first], second=numbers[stitch.second])
        for stitch in pattern.stitches
    )
    return replace(pattern, panels=tuple(panels), stitches=stitches), tuple(changes)


def _is_sliver(panel: Panel, edge: int, free: list[bool]) -> bool:
    """Whether a free edge between a seam and another free edge is too short to mean anything."""
    following = (edge + 1) % len(free)
    if not free[edge] or free[edge - 1] == free[following]:
        return False
    length = panel.edge_length(edge)
    if length >= ON_CM:
        return False
    seam = edge - 1 if not free[edge - 1] else following
    own, other = (np.diff(panel.chord(k), axis=0)[0] for k in (edge, seam % len(free)))
    across = float(np.linalg.norm(own) * np.linalg.norm(other))
    return length < ANY_WAY_CM or float(own @ other) > STRAIGHT_ON * across


def _without(panel: Panel, edge: int, *, seam_before: bool) -> Panel:
    """The panel without an edge: the seam beside it ends where it ended."""
    count = len(panel.edges)
    corner = edge if seam_before else (edge + 1) % count
    # Vertex k begins edge k: without the first vertex the loop begins with the second.
    vertices = np.delete(panel.vertices, corner, axis=0)
    edges = [e for k, e in enumerate(panel.edges) if k != edge]
    if corner == 0 and seam_before is False:
        # The last edge goes, and the first begins where that began.
        vertices = np.concatenate([panel.vertices[-1:], panel.vertices[1:-1]])
    return replace(panel, vertices=vertices, edges=tuple(edges))
