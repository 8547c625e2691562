"""Makes a Delaunay triangulation contain given edges, and keeps the triangles on their left."""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from swifttailor.arrays import Floats, Longs
from swifttailor.errors import GeometryError

_NO_AREA = 1e-12
"""Share of the whole below which an area is rounding."""
_FLIPS = 20
"""Flips for each pair of edges in the way after which there is no way to make an edge."""


def recover_edges(points: Floats, faces: Longs, neighbors: Longs, following: Longs) -> tuple[Longs, Longs]:
    """Flips edges until every boundary edge is in the triangulation.

    S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993. Only the few
    missing edges cost anything.

    Args:
        points: (n, 2).
        faces: (f, 3) counter-clockwise triangles of the convex hull.
        neighbors: (f, 3) the triangle opposite each corner, or -1.
        following: (n,) the boundary point that each boundary point is to be joined to, -1 for inner points.

    Returns:
        Faces and neighbours (f, 3) over the same vertices.

    Raises:
        GeometryError: Two boundary edges cross, or a point lies on one.
    """
    start, end = faces[:, [1, 2, 0]], faces[:, [2, 0, 1]]
    present = following < 0
    present[start[following[start] == end]] = True
    present[end[following[end] == start]] = True
    missing = np.flatnonzero(~present)
    if not len(missing):
        return faces, neighbors
    triangles = [(int(a), int(b), int(c)) for a, b, c in faces]
    left: dict[tuple[int, int], int] = {}
    for t, (a, b, c) in enumerate(triangles):
        left[a, b] = left[b, c] = left[c, a] = t
    kept = {tuple(sorted((a, b))) for a, b in enumerate(following.tolist()) if b >= 0}
    for a in missing.tolist():
        _insert(points, triangles, left, a, int(following[a]), kept)
    recovered = np.array(triangles, dtype=np.int64)
    across = [[left.get((c, b), -1), left.get((a, c), -1), left.get((b, a), -1)] for a, b, c in triangles]
    return recovered, np.array(across, dtype=np.int64)


def interior_triangles(points: Floats, faces: Longs, neighbors: Longs, following: Longs) -> NDArray[np.bool_]:
    """Which triangles (f,) can be reached from the left side of the boundary edges without crossing one.

    Triangles between corners that lie on one line have no area, and their winding is chance. So every part
    that the boundary cuts out is judged by all its triangles along the boundary, each counting by its area.

    Arguments are those of `recover_edges`; every boundary edge must be in the triangulation.
    """
    start, end = faces[:, [1, 2, 0]], faces[:, [2, 0, 1]]
    inner_side, outer_side = following[start] == end, following[end] == start
    triangle, corner = np.nonzero(~(inner_side | outer_side) & (neighbors >= 0))
    graph = coo_array(
        (np.ones(len(triangle), np.int8), (triangle, neighbors[triangle, corner])), shape=(len(faces),) * 2
    )
    part = connected_components(graph, directed=False)[1]
    (ux, uy), (wx, wy) = (
        (points[faces[:, 1]] - points[faces[:, 0]]).T,
        (points[faces[:, 2]] - points[faces[:, 0]]).T,
    )
    area = np.abs(ux * wy - uy * wx)
    votes = np.bincount(part, weights=area * (inner_side.sum(axis=1) - outer_side.sum(axis=1)))
    return (votes > _NO_AREA * area.sum())[part]


def _insert(
    points: Floats,
    triangles: list[tuple[int, int, int]],
    left: dict[tuple[int, int], int],
    a: int,
    b: int,
    kept: set[tuple[int, ...]],
) -> None:
    def turn(i: int, j: int, k: int) -> float:
        (xi, yi), (xj, yj), (xk, yk) = points[i], points[j], points[k]
        return float((xj - xi) * (yk - yi) - (yj - yi) * (xk - xi))

    waiting = deque(_crossing(points, list(left), a, b))
    for _ in range(_FLIPS * len(waiting) ** 2):
        if not waiting:
            break
        u, v = waiting.popleft()
        if tuple(sorted((u, v))) in kept:
            break
        one, two = left[u, v], left[v, u]
        p = next(w for w in triangles[one] if w not in (u, v))
        q = next(w for w in triangles[two] if w not in (u, v))
        if turn(p, q, v) <= 0 or turn(q, p, u) <= 0:  # the two triangles are no convex quadrilateral
            waiting.append((u, v))
            continue
        del left[u, v], left[v, u]
        triangles[one], triangles[two] = (p, u, q), (q, v, p)
        for t, (i, j, k) in ((one, triangles[one]), (two, triangles[two])):
            left[i, j] = left[j, k] = left[k, i] = t
        if not {p, q} & {a, b} and turn(a, b, p) * turn(a, b, q) < 0:
            waiting.append((p, q))
    if (a, b) in left or (b, a) in left:
        return
    raise GeometryError(
        f"The panel outline cannot be meshed near ({points[a][0]:.2f}, {points[a][1]:.2f}) cm: it crosses or "
        "touches itself there. Run: swifttailor check PATTERN"
    )


def _crossing(points: Floats, edges: list[tuple[int, int]], a: int, b: int) -> list[tuple[int, int]]:
    """Edges (each once) that properly cross the segment from a to b, nearest to a first."""
    pairs = np.array([e for e in edges if e[0] < e[1]])
    p, q, s, e = points[pairs[:, 0]], points[pairs[:, 1]], points[a], points[b]

    def side(origin: Floats, tip: Floats, x: Floats) -> Floats:
        d, w = tip - origin, x - origin
        return d[..., 0] * w[..., 1] - d[..., 1] * w[..., 0]

    apart = (side(s, e, p) * side(s, e, q) < 0) & (side(p, q, s[None]) * side(p, q, e[None]) < 0)
    shared = (pairs == a).any(axis=1) | (pairs == b).any(axis=1)
    hits = pairs[apart & ~shared]
    order = np.argsort(np.linalg.norm(points[hits].mean(axis=1) - s, axis=1), kind="stable")
    return [(int(u), int(v)) for u, v in hits[order]]
