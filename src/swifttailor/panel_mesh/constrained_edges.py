"""Makes a Delaunay triangulation contain given edges, and keeps the triangles on their left."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.errors import GeometryError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


def recover_edges(points: Floats, faces: Ints, wanted: Ints) -> Ints:
    """Flips edges until every wanted edge is in the triangulation.

    S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993. Only the few
    missing edges cost anything.

    Args:
        points: (n, 2).
        faces: (f, 3) counter-clockwise triangles of the convex hull.
        wanted: (m, 2) vertex pairs that must be edges.

    Returns:
        Faces (f, 3) with the same vertices.

    Raises:
        GeometryError: Two wanted edges cross, or a point lies on one.
    """
    present = _edge_keys(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), len(points))
    missing = wanted[~np.isin(_edge_keys(wanted, len(points)), present)]
    if not len(missing):
        return faces
    triangles = [(int(a), int(b), int(c)) for a, b, c in faces]
    left: dict[tuple[int, int], int] = {}
    for t, (a, b, c) in enumerate(triangles):
        left[a, b] = left[b, c] = left[c, a] = t
    kept = {tuple(sorted((int(a), int(b)))) for a, b in wanted}
    for a, b in missing:
        _insert(points, triangles, left, int(a), int(b), kept)
    return np.array(triangles, dtype=np.int64)


def interior_triangles(faces: Ints, boundary: Ints) -> Ints:
    """Triangles reachable from the left side of the boundary edges without crossing one, (k, 3)."""
    left = {(int(f[k]), int(f[(k + 1) % 3])): t for t, f in enumerate(faces) for k in range(3)}
    wall = {(int(a), int(b)) for a, b in boundary} | {(int(b), int(a)) for a, b in boundary}
    stack = [left[int(a), int(b)] for a, b in boundary if (int(a), int(b)) in left]
    inside = np.zeros(len(faces), dtype=bool)
    inside[stack] = True
    while stack:
        a, b, c = (int(v) for v in faces[stack.pop()])
        for edge in ((a, b), (b, c), (c, a)):
            if edge in wall:
                continue
            other = left.get((edge[1], edge[0]))
            if other is not None and not inside[other]:
                inside[other] = True
                stack.append(other)
    return faces[inside]


def _edge_keys(edges: Ints, count: int) -> Ints:
    ordered = np.sort(edges, axis=1).astype(np.int64)
    return ordered[:, 0] * count + ordered[:, 1]


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

    for _ in range(10 * len(points)):
        if (a, b) in left or (b, a) in left:
            return
        flipped = False
        for u, v in _crossing(points, list(left), a, b):
            if tuple(sorted((u, v))) in kept or (v, u) not in left:
                continue
            one, two = left[u, v], left[v, u]
            p = next(w for w in triangles[one] if w not in (u, v))
            q = next(w for w in triangles[two] if w not in (u, v))
            if turn(p, q, v) <= 0 or turn(q, p, u) <= 0:  # the two triangles are no convex quadrilateral
                continue
            del left[u, v], left[v, u]
            triangles[one], triangles[two] = (p, u, q), (q, v, p)
            for t, (i, j, k) in ((one, triangles[one]), (two, triangles[two])):
                left[i, j] = left[j, k] = left[k, i] = t
            flipped = True
            break
        if not flipped:
            break
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
