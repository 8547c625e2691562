"""Opening slits of a written pattern whose two sides lie on each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern import EdgeRef, Panel, Pattern
from swifttailor.pattern.check.repair import Change
from swifttailor.pattern.curve import Line

NARROWEST_CM = 1.0
"""A slit is opened to this width."""
LEAST_CM = 3.0
"""Shorter cuts are no slits."""


def open_slits(pattern: Pattern) -> tuple[Pattern, tuple[Change, ...]]:
    """Moves the lower corners of slits apart where they are so near that the outline touches itself.

    A slit is two straight edges that meet inside of a panel and are sewn to nothing.
    """
    sewn = {side for stitch in pattern.stitches for side in stitch.sides}
    panels, changes = [], []
    for panel in pattern.panels:
        count = len(panel.edges)
        after = panel
        for edge in range(count):
            ids = edge, (edge + 1) % count
            if count < 5 or any(EdgeRef(panel.name, k) in sewn for k in ids):
                continue
            wider = _opened(after, *ids)
            if wider is not None:
                after = wider
                changes.append(Change("closed-slit", "opened a slit without width", panel.name, edge))
        panels.append(after)
    return (replace(pattern, panels=tuple(panels)), tuple(changes)) if changes else (pattern, ())


def _opened(panel: Panel, edge: int, following: int) -> Panel | None:
    """The panel with a slit opened; None where these edges are none, or it is open."""
    count = len(panel.edges)
    if not all(isinstance(panel.edges[k].curve, Line) for k in (edge, following)):
        return None
    left, apex, right = panel.vertices[[edge, following, (following + 1) % count]]
    sides = np.array([left - apex, right - apex])
    lengths = np.linalg.norm(sides, axis=1)
    if lengths.min() < LEAST_CM or np.dot(*sides) < 0.9 * lengths.prod():
        return None
    before, after = panel.vertices[[(edge - 1) % count, (following + 2) % count]]
    along = after - before
    along = along / max(float(np.linalg.norm(along)), 1e-9)
    # Crossed sides have a negative width.
    if float((right - left) @ along) >= NARROWEST_CM:
        return None
    middle = (left + right) / 2
    vertices = panel.vertices.copy()
    vertices[edge], vertices[(following + 1) % count] = (
        middle - along * NARROWEST_CM / 2,
        middle + along * NARROWEST_CM / 2,
    )
    return replace(panel, vertices=vertices)
