"""Common sequences of straight edges: through points, in fractions, sides with cuts, darts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from swifttailor.programs.design_error import DesignError
from swifttailor.programs.edge_sequence import EdgeSequence
from swifttailor.programs.edges import Edge, Vertex, close_enough


def from_verts(*verts: Vertex, loop: bool = False) -> EdgeSequence:
    """Straight edges through the given vertices, which it keeps; closed on request."""
    seq = EdgeSequence([Edge(a, b) for a, b in pairwise(verts)])
    if loop:
        seq.append(Edge(verts[-1], verts[0]))
    return seq


def from_fractions(start: Vertex, end: Vertex, fractions: Sequence[float]) -> EdgeSequence:
    """Straight edges from start to end with these fractions of the way."""
    parts = [abs(f) for f in fractions]
    if not close_enough(sum(parts), 1.0):
        raise DesignError(f"An edge is divided into fractions whose sum is 1, got {list(fractions)}.")
    verts, covered = [start], 0.0
    for part in parts[:-1]:
        covered += part
        verts.append([a + covered * (b - a) for a, b in zip(start, end, strict=True)])
    return from_verts(*verts, end)


def side_with_cut(start: Vertex, end: Vertex, start_cut: float = 0.0, end_cut: float = 0.0) -> EdgeSequence:
    """A side with vertices at these fractions from its start and its end, so that a part can stay open."""
    verts = [start]
    if start_cut > 0:
        verts.append([a + start_cut * (b - a) for a, b in zip(start, end, strict=True)])
    if end_cut > 0:
        verts.append([b - end_cut * (b - a) for a, b in zip(start, end, strict=True)])
    return from_verts(*verts, end)


def dart_shape(width: float, side_len: float | None = None, depth: float | None = None) -> EdgeSequence:
    """A triangular dart of a width and a length of its sides or a depth, cm."""
    if depth is None:
        if side_len is None:
            raise DesignError("A dart needs the length of its sides or its depth; neither is given.")
        if width / 2 > side_len:
            raise DesignError(
                f"A dart {width:.4g} cm wide cannot have sides of {side_len:.4g} cm; half of the width "
                "is the least. Change the parameters that give the width."
            )
        depth = math.sqrt(side_len**2 - (width / 2) ** 2)
    return from_verts([0.0, 0.0], [width / 2, -depth], [width, 0.0])
