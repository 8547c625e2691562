"""The outlines of all panels as one table of points, which is what everything in this room is drawn from."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from swifttailor.arrays import Floats, Ints
from swifttailor.pattern import EdgeRef, Pattern

TOLERANCE = 2e-5
"""Largest distance between a curved edge and its polyline, as a share of the largest panel: at 256 pixels at
most a two-hundredth of one. A share, so that the number of points is bounded whatever a file holds."""


@dataclass(frozen=True, eq=False)
class Outlines:
    """Polylines of all edges of a pattern, one after the other.

    Edges are numbered through the pattern: those of the first panel, then those of the second, and so on.
    """

    points: Floats
    """(n, 2) panel-local cm; every edge with both its ends."""
    fraction: Floats
    """(n,) share of the edge's arc length that lies before the point, 0 to 1."""
    edge: Ints
    """(n,) number of the edge each point belongs to."""
    edge_panel: Ints
    """(e,) panel index of each edge."""
    first_edge: Ints
    """(p + 1,) number of each panel's first edge, and the number of edges."""

    @cached_property
    def panel(self) -> Ints:
        """(n,) panel index of each point."""
        return self.edge_panel[self.edge]

    @cached_property
    def signed_area(self) -> Floats:
        """(p,) area of each panel in cm^2, positive where the loop runs anticlockwise."""
        count = len(self.first_edge) - 1
        here, there = self._segments
        panel = self.panel[here]
        # Relative to the panel's own corner: far from the origin the difference of products loses digits.
        corner = self.bounds[0][panel]
        a, b = self.points[here] - corner, self.points[there] - corner
        doubled = np.bincount(panel, a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], count)
        return doubled.astype(np.float64) / 2

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lower and upper corner (p, 2) of each panel's box in panel-local cm."""
        first = np.searchsorted(self.edge, self.first_edge[:-1])
        return (
            np.minimum.reduceat(self.points, first, axis=0),
            np.maximum.reduceat(self.points, first, axis=0),
        )

    @cached_property
    def _segments(self) -> tuple[Ints, Ints]:
        here = np.flatnonzero(self.edge[1:] == self.edge[:-1]).astype(np.int32)
        return here, here + 1

    @property
    def segments(self) -> tuple[Ints, Ints]:
        """Indices (s,) of the first and of the second point of every piece of the polylines."""
        return self._segments

    def number(self, pattern: Pattern, ref: EdgeRef) -> int:
        """The number of an edge of the pattern the outlines were traced from."""
        return int(self.first_edge[pattern.panel_index(ref.panel)]) + ref.edge


def trace_outlines(pattern: Pattern) -> Outlines:
    """Traces all edges of a pattern within `TOLERANCE`."""
    tolerance = TOLERANCE * max(
        (float(np.ptp(p.vertices, axis=0).max()) for p in pattern.panels), default=0.0
    )
    tolerance = max(tolerance, 1e-9)  # panels without extent
    points, fractions, edges = [], [], []
    first_edge, panels = [0], []
    for index, panel in enumerate(pattern.panels):
        for k in range(len(panel.edges)):
            line = panel.flatten_edge(k, tolerance)
            way = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
            # An edge of no length has no arc length to divide by; its points are one point.
            fractions.append(way / way[-1] if way[-1] > 0 else np.linspace(0.0, 1.0, len(way)))
            edges.append(np.full(len(line), len(panels), np.int32))
            points.append(line)
            panels.append(index)
        first_edge.append(len(panels))
    return Outlines(
        np.concatenate(points) if points else np.zeros((0, 2)),
        np.concatenate(fractions) if fractions else np.zeros(0),
        np.concatenate(edges) if edges else np.zeros(0, np.int32),
        np.array(panels, np.int32),
        np.array(first_edge, np.int32),
    )
