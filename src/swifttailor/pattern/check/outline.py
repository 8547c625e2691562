"""What the checks measure on a panel: its outline as a polyline, edge lengths, area, place in space."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, read_only
from swifttailor.pattern import curve as curves
from swifttailor.pattern.curve import Arc, Line
from swifttailor.pattern.panel import Panel

FLATTEN_CM = 0.002
"""Distance from curve to polyline on ordinary panels; absurdly large ones get a coarser one."""


@dataclass(frozen=True, eq=False)
class Outline:
    """A panel's loop as a fine polyline, with the measures the checks share; arrays are read-only."""

    panel: Panel
    points: Floats
    """(m, 2) panel-local cm; segment k joins point k to point k + 1 modulo m."""
    edge_of_segment: NDArray[np.int64]
    """(m,) edge that segment k belongs to."""
    lengths: Floats
    """(n,) length of every edge, cm (of the polyline: short by less than 1e-6 of an ordinary edge)."""
    tolerance: float
    """Largest distance between curve and polyline, cm."""

    @cached_property
    def area(self) -> float:
        """Signed area in cm^2, positive when the loop runs counter-clockwise."""
        x, y = (self.points - self.points.mean(axis=0)).T
        return float(x @ np.roll(y, -1) - np.roll(x, -1) @ y) / 2

    @cached_property
    def perimeter(self) -> float:
        """Length of the loop, cm."""
        return float(self.lengths.sum())

    @cached_property
    def size(self) -> float:
        """Longer side of the local bounding box, cm."""
        return float(np.ptp(self.points, axis=0).max())

    @cached_property
    def mean_width(self) -> float:
        """Twice the area over the perimeter, cm: the width of a thin panel, the radius of a round one."""
        return 2 * abs(self.area) / self.perimeter if self.perimeter > 0 else 0.0

    @cached_property
    def world(self) -> Floats:
        """(n, 3) corners where the panel is placed, cm."""
        return read_only(self.panel.to_world(self.panel.vertices))

    @cached_property
    def normal(self) -> Floats:
        """(3,) unit vector out of the right side of the placed panel."""
        return read_only(self.panel.placement.matrix()[:, 2] * (1.0 if self.area >= 0 else -1.0))


@lru_cache(maxsize=512)
def trace_outline(panel: Panel) -> Outline:
    """Flattens a panel's loop; remembers the latest, since most panels stay as they are from check to check.

    The tolerance grows with the panel's extent and edge count where these are far beyond cloth, so that the
    number of points stays bounded for any input.
    """
    extent = _extent(panel)
    tolerance = max(FLATTEN_CM, 1e-5 * extent * max(1.0, len(panel.edges) / 50))
    if all(isinstance(e.curve, Line) for e in panel.edges):
        lengths = np.hypot(*(np.roll(panel.vertices, -1, axis=0) - panel.vertices).T)
        owner = np.arange(len(panel.edges))
        return Outline(panel, panel.vertices, read_only(owner), read_only(lengths), 0.0)
    pieces = [panel.flatten_edge(k, tolerance) for k in range(len(panel.edges))]
    lengths = np.array([np.hypot(*np.diff(p, axis=0).T).sum() for p in pieces])
    owner = np.repeat(np.arange(len(pieces)), [len(p) - 1 for p in pieces])
    points = np.concatenate([p[:-1] for p in pieces])
    return Outline(panel, read_only(points), read_only(owner), read_only(lengths), tolerance)


def _extent(panel: Panel) -> float:
    """An upper bound of the panel's size from its corners, control points and radii, cm."""
    spans = [float(np.ptp(panel.vertices, axis=0).max())]
    for k, edge in enumerate(panel.edges):
        chord = panel.chord(k)
        if isinstance(edge.curve, Arc):
            length = float(np.hypot(*(chord[1] - chord[0])))
            spans.append(2 * max(edge.curve.radius, length) if edge.curve.large else length)
        elif not isinstance(edge.curve, Line):
            spans.append(float(np.ptp(curves.control_polygon(edge.curve, chord), axis=0).max()))
    return max(spans)
