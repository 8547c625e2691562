"""Ornamental shapes that can be cut into the side of a skirt."""

from __future__ import annotations

from collections.abc import Callable

from swifttailor.programs.curved_edges import arc_from_three_points
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edge_shapes import from_verts
from swifttailor.programs.edges import to_vertex

RAYS = 6


def sun(width: float, depth: float) -> EdgeSequence:
    """Half a sun of straight rays.

    Args:
        width: Of its opening, cm.
        depth: From the opening to the points of the middle rays, cm.
    """
    ray = depth * 0.2
    outer = arc_from_three_points([0.0, 0.0], [width, 0.0], [width / 2, depth]).as_curve()
    inner = arc_from_three_points([ray, 0.0], [width - ray, 0.0], [width / 2, depth - ray]).as_curve()
    verts = []
    for k in range(RAYS):
        verts += [to_vertex(inner.point(k / RAYS)), to_vertex(outer.point((k + 0.5) / RAYS))]
    return from_verts(*verts, to_vertex(inner.point(1.0)))


ORNAMENTS: dict[str, Callable[[float, float], EdgeSequence]] = {"Sun": sun}
