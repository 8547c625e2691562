"""Darts: wedges of a panel's outline that are sewn shut, and how their mouths are cut."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.pattern import EdgeRef, Pattern

_EVEN = 0.04, 0.3
"""Legs of a dart differ by at most this share of their length, or by this many cm."""
_WIDEST = 1.0
"""A dart's mouth is at most this many times as wide as its legs are long; else it is cut out."""
_NARROWEST_CM = 0.05


@dataclass(frozen=True)
class Dart:
    """A wedge with its point inside the panel: leg in, leg out."""

    panel: str
    leg_in: int
    """Edge from the mouth to the point."""
    leg_out: int
    """The next edge, from the point back to the mouth."""

    @property
    def legs(self) -> tuple[EdgeRef, EdgeRef]:
        """Both edges."""
        return EdgeRef(self.panel, self.leg_in), EdgeRef(self.panel, self.leg_out)


def find_darts(pattern: Pattern, partner: Mapping[EdgeRef, EdgeRef]) -> tuple[Dart, ...]:
    """Finds neighbouring edges of one panel that are sewn together around a notch in its outline.

    Wedges that are very wide, or uneven, are not darts: they are cut out, with seam allowances along both
    edges.

    Args:
        pattern: Any pattern.
        partner: What every stitched edge is sewn to.
    """
    darts = []
    for panel in pattern.panels:
        count = len(panel.edges)
        orientation = 1.0 if panel.signed_area() >= 0 else -1.0
        polygon = None
        for k in range(count):
            follower = (k + 1) % count
            ref, other = EdgeRef(panel.name, k), EdgeRef(panel.name, follower)
            if count < 4 or partner.get(ref) != other:
                continue
            a, tip = panel.chord(k)
            b = panel.chord(follower)[1]
            leg, back = panel.edge_length(k), panel.edge_length(follower)
            mouth = float(np.hypot(*(b - a)))
            turn = (tip - a)[0] * (b - tip)[1] - (tip - a)[1] * (b - tip)[0]
            even = abs(leg - back) <= max(_EVEN[0] * leg, _EVEN[1])
            if not even or turn * orientation >= 0 or not _NARROWEST_CM < mouth < _WIDEST * leg:
                continue
            if polygon is None:
                polygon = shapely.make_valid(shapely.Polygon(panel.outline(0.02)))
            wedge = shapely.Polygon([a, tip, b])
            if shapely.area(shapely.intersection(wedge, polygon)) < 0.05 * wedge.area + 0.01:
                darts.append(Dart(panel.name, k, follower))
    return tuple(darts)


def dart_peak(before: Floats, leg_in: Floats, leg_out: Floats, after: Floats) -> Floats:
    """Where the cut line peaks across a dart, so that the folded dart reaches into the seam.

    Half of the wedge comes to lie, turned over at a leg, under the cloth beside it. Its end must follow the
    edge there; so the edge is mirrored at the leg, and goes on to the middle of the dart.

    Args:
        before: Polyline (n, 2) that ends where the dart begins, cm, anticlockwise around the piece.
        leg_in: Polyline from the mouth to the point.
        leg_out: Polyline from the point to the mouth.
        after: Polyline that begins where the dart ends.

    Returns:
        (2,) cm; the middle of the mouth where no better point is found.
    """
    a, tip, b = leg_in[0], leg_in[-1], leg_out[-1]
    middle = (a + b) / 2
    axis = middle - tip
    height = float(np.hypot(*axis))
    if height < 1e-6:
        return middle
    axis = axis / height
    best = 0.0
    for corner, edge in ((a, before[::-1]), (b, after)):
        along = _direction(edge)
        leg = (tip - corner) / max(float(np.hypot(*(tip - corner))), 1e-9)
        mirrored = 2 * (along @ leg) * leg - along
        across = mirrored[0] * axis[1] - mirrored[1] * axis[0]
        if abs(across) < 1e-6:
            continue
        offset = middle - corner
        reach = (offset[0] * axis[1] - offset[1] * axis[0]) / across
        beyond = float((corner + reach * mirrored - middle) @ axis)
        if reach > 0 and abs(beyond) <= 1.0 * float(np.hypot(*(b - a))):
            best = max(best, beyond)
    return middle + best * axis


def _direction(points: Floats) -> Floats:
    step = points[1] - points[0]
    return step / max(float(np.hypot(*step)), 1e-12)
