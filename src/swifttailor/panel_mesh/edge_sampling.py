"""How many mesh segments each edge gets, so that stitched edges match vertex to vertex."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import PatternError
from swifttailor.pattern import EdgeRef, Pattern


def edge_segments(pattern: Pattern, edge_length: float) -> dict[EdgeRef, int]:
    """Segments per edge: the length over `edge_length`, and for a stitch what its longer edge needs.

    Equal counts let a gathered seam be sewn vertex to vertex, the longer side simply denser (GarmentCode
    does the same).

    Raises:
        PatternError: An edge is stitched twice or to itself, or a stitch names no edge of the pattern.
    """
    segments = {
        EdgeRef(p.name, k): max(1, math.ceil(p.edge_length(k) / edge_length - 1e-9))
        for p in pattern.panels
        for k in range(len(p.edges))
    }
    used: dict[EdgeRef, int] = {}
    for index, stitch in enumerate(pattern.stitches):
        for ref in stitch.sides:
            if ref not in segments:
                raise PatternError(
                    f"Stitch {index} names edge {ref.edge} of panel '{ref.panel}', which does not exist. "
                    "Run: swifttailor check PATTERN --repair OUT"
                )
            if ref in used:
                raise PatternError(
                    f"Edge {ref.edge} of panel '{ref.panel}' is in stitch {used[ref]} and in stitch {index}; "
                    "an edge can be sewn once. Run: swifttailor check PATTERN"
                )
            used[ref] = index
        count = max(segments[ref] for ref in stitch.sides)
        for ref in stitch.sides:
            segments[ref] = count
    return segments


def stitched_pairs(
    first: NDArray[np.int32], second: NDArray[np.int32], right_wrong: bool
) -> NDArray[np.int32]:
    """Pairs (n, 2) of vertices that a stitch joins, along the travel of the first edge."""
    return np.stack([first, second if right_wrong else second[::-1]], axis=1)
