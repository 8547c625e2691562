"""Tags that stitched edges have in common, and the stitches that are found by them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.pattern import EdgeRef, Pattern

FARTHEST_CM = 15.0
"""Edges whose tags are farther apart are not stitched."""
_TIE_CM = 0.1
"""Tags that are as near are told apart by the lengths of the edges."""


def tags_of(pattern: Pattern) -> dict[EdgeRef, Floats]:
    """For each stitched edge the mean of the end points of both edges, (3,) world cm.

    Args:
        pattern: Placed.

    Raises:
        PatternError: An edge is stitched twice, to itself, or is none of the pattern.
    """
    counts = Counter(side for stitch in pattern.stitches for side in stitch.sides)
    tags: dict[EdgeRef, Floats] = {}
    for stitch in pattern.stitches:
        for side in stitch.sides:
            if counts[side] > 1:
                raise PatternError(
                    f"Edge {side.edge} of panel '{side.panel}' is in {counts[side]} stitches; a panel tensor "
                    "holds one for each edge. Split the edge, or remove a stitch."
                )
            if not pattern.has_edge(side):
                raise PatternError(f"A stitch names edge {side.edge} of '{side.panel}', which is not there.")
        ends = [_ends(pattern, side) for side in stitch.sides]
        tags |= dict.fromkeys(stitch.sides, np.concatenate(ends).mean(0))
    return tags


def nearest_pairs(
    tags: Mapping[EdgeRef, Floats], lengths: Mapping[EdgeRef, float]
) -> list[Sequence[EdgeRef]]:
    """Pairs of edges, those first whose tags are nearest; what is left over is in none.

    Args:
        tags: Of the edges to pair, (3,) world cm.
        lengths: Of the same edges, cm.
    """
    edges = sorted(tags)
    if len(edges) < 2:
        return []
    at, long = np.array([tags[edge] for edge in edges]), np.array([lengths[edge] for edge in edges])
    one, other = np.triu_indices(len(edges), 1)
    apart = np.linalg.norm(at[one] - at[other], axis=1)
    uneven = np.abs(long[one] - long[other])
    taken: set[int] = set()
    pairs: list[Sequence[EdgeRef]] = []
    for k in np.lexsort((apart, uneven, np.round(apart / _TIE_CM))):
        i, j = int(one[k]), int(other[k])
        if apart[k] > FARTHEST_CM or i in taken or j in taken:
            continue
        taken |= {i, j}
        pairs.append((edges[i], edges[j]))
    return pairs


def _ends(pattern: Pattern, side: EdgeRef) -> Floats:
    panel = pattern.panel(side.panel)
    return panel.to_world(panel.chord(side.edge))
