"""Evens out a triangulation by moving its inner points; triangles keep their corners and their winding."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from swifttailor.arrays import Floats, Longs

_ROUNDS = 3
_POOR = 0.35
"""A move may not leave a triangle below this quality (equilateral: 1) unless it was worse before."""


def smooth(points: Floats, faces: Longs, fixed: NDArray[np.bool_]) -> Floats:
    """Moves every free point to the mean of its neighbours, a few times over.

    Moves that would turn a triangle over or flatten it are taken back, so that a valid triangulation stays
    one whatever its outline.

    Args:
        points: (n, 2), cm.
        faces: (f, 3) counter-clockwise; a free point is surrounded by triangles.
        fixed: (n,) points that stay where they are.

    Returns:
        Points (n, 2).
    """
    # Each neighbour of a free point follows it in exactly one of the triangles around it.
    tail, head = faces.ravel(), faces[:, [1, 2, 0]].ravel()
    degree = np.bincount(tail, minlength=len(points))
    free = np.flatnonzero(~fixed & (degree > 0))
    if not len(free):
        return points
    row = np.full(len(points), -1, np.int64)
    row[free] = np.arange(len(free))
    inner = row[tail] >= 0
    tail, head = tail[inner], head[inner]
    mean = csr_array((1.0 / degree[tail], (row[tail], head)), shape=(len(free), len(points)))
    quality = triangle_quality(points, faces)
    for _ in range(_ROUNDS):
        moved = points.copy()
        moved[free] = mean @ points
        points, quality = _without_poor_triangles(points, moved, faces, quality)
    return points


def triangle_quality(points: Floats, faces: Longs) -> Floats:
    """(f,) 4 sqrt(3) area over the sum of squared sides: 1 when equilateral, negative when clockwise."""
    x, y = points[:, 0][faces], points[:, 1][faces]
    ux, uy, wx, wy = x[:, 1] - x[:, 0], y[:, 1] - y[:, 0], x[:, 2] - x[:, 0], y[:, 2] - y[:, 0]
    squares = 2 * (ux * ux + uy * uy + wx * wx + wy * wy - ux * wx - uy * wy)
    return 2 * np.sqrt(3) * (ux * wy - uy * wx) / np.maximum(squares, 1e-300)


def _without_poor_triangles(
    before: Floats, after: Floats, faces: Longs, quality: Floats
) -> tuple[Floats, Floats]:
    """The moved points, with those at triangles that a move has spoilt put back; and the new quality."""
    bound = np.minimum(quality, _POOR)
    while True:
        reached = triangle_quality(after, faces)
        poor = faces[reached < bound]
        if not len(poor):
            return after, reached
        after[poor] = before[poor]
