"""How many mesh segments each edge gets, so that stitched edges match vertex to vertex."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import PatternError
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.pattern.curve_sampling import EdgeSampler


def measured_edges(pattern: Pattern) -> EdgeSampler:
    """All edges of a pattern, panel after panel, ready to be sampled."""
    ends = [np.stack([p.vertices, np.roll(p.vertices, -1, axis=0)], axis=1) for p in pattern.panels]
    chords = np.concatenate(ends) if ends else np.zeros((0, 2, 2))
    return EdgeSampler.of([e.curve for p in pattern.panels for e in p.edges], chords)


def edge_segments(
    pattern: Pattern, edge_length: float, edges: EdgeSampler | None = None
) -> dict[EdgeRef, int]:
    """Segments per edge: the length over `edge_length`, and for a stitch what its longer edge needs.

    Equal counts let a gathered seam be sewn vertex to vertex, the longer side simply denser (GarmentCode
    does the same).

    Args:
        pattern: Its stitches say which counts must agree.
        edge_length: Target edge length, cm.
        edges: `measured_edges` of the pattern, where at hand.

    Returns:
        Counts, in the order of the panels and their edges.

    Raises:
        PatternError: An edge is stitched twice or to itself, or a stitch names no edge of the pattern.
    """
    lengths = (measured_edges(pattern) if edges is None else edges).lengths
    refs = [EdgeRef(p.name, k) for p in pattern.panels for k in range(len(p.edges))]
    counts = np.maximum(1, np.ceil(lengths / edge_length - 1e-9)).astype(np.int64).tolist()
    segments = dict(zip(refs, counts, strict=True))
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
    first: NDArray[np.int64], second: NDArray[np.int64], right_wrong: bool
) -> NDArray[np.int64]:
    """Pairs (n, 2) of vertices that a stitch joins, along the travel of the first edge."""
    return np.stack([first, second if right_wrong else second[::-1]], axis=1)
