"""Makes a Delaunay triangulation contain given edges, and keeps the triangles on their left."""

from __future__ import annotations

import math
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
    mesh = _Flippable(points, faces, following)
    for a in missing.tolist():
        mesh.insert(a, int(following[a]))
    triangles, left = mesh.triangles, mesh.left
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


class _Flippable:
    """A triangulation whose edges can be flipped."""

    def __init__(self, points: Floats, faces: Longs, following: Longs) -> None:
        """Takes over faces (f, 3); flips never touch the edges of the boundary."""
        self.xy = points.tolist()
        self.triangles: list[tuple[int, int, int]] = [(a, b, c) for a, b, c in faces.tolist()]
        self.left: dict[tuple[int, int], int] = {}
        """Triangle on the left of each directed edge."""
        for t, (a, b, c) in enumerate(self.triangles):
            self.left[a, b] = self.left[b, c] = self.left[c, a] = t
        self._at = [-1] * len(points)
        """A triangle at each point."""
        for t, corners in enumerate(self.triangles):
            for corner in corners:
                self._at[corner] = t
        self._points = points
        self._kept = {(a, b) for a, b in enumerate(following.tolist()) if b >= 0}

    def insert(self, a: int, b: int) -> None:
        """Flips edges until there is one from a to b."""
        if (a, b) in self.left or (b, a) in self.left:  # flips for another have made it
            return
        crossed = self._walk(a, b)
        waiting = deque(self._search(a, b) if crossed is None else self._nearest_first(crossed, a))
        for _ in range(_FLIPS * len(waiting) ** 2):
            if not waiting:
                break
            u, v = waiting.popleft()
            if (u, v) in self._kept or (v, u) in self._kept:
                break
            one, two = self.left.get((u, v)), self.left.get((v, u))
            if one is None or two is None:  # beyond it lies a triangle of no area, wound the other way
                break
            p = next(w for w in self.triangles[one] if w not in (u, v))
            q = next(w for w in self.triangles[two] if w not in (u, v))
            if self._turn(p, q, v) <= 0 or self._turn(q, p, u) <= 0:  # no convex quadrilateral
                waiting.append((u, v))
                continue
            self._flip(u, v, p, q)
            if not {p, q} & {a, b} and self._turn(a, b, p) * self._turn(a, b, q) < 0:
                waiting.append((p, q))
        if (a, b) in self.left or (b, a) in self.left:
            return
        x, y = self.xy[a]
        raise GeometryError(
            f"The panel outline cannot be meshed near ({x:.2f}, {y:.2f}) cm: it crosses or touches itself "
            "there. Run: swifttailor check PATTERN"
        )

    def _walk(self, a: int, b: int) -> list[tuple[int, int]] | None:
        """Edges that the segment from a to b crosses, triangle by triangle; None where it meets a corner."""
        first = self._toward(a, b)
        if first is None:
            return None
        right, left = first
        crossed = []
        while True:
            crossed.append((min(right, left), max(right, left)))
            beyond = self.left.get((left, right))
            if beyond is None:
                return None
            tip = next(w for w in self.triangles[beyond] if w not in (left, right))
            if tip == b:
                return crossed
            side = self._turn(a, b, tip)
            if side == 0:
                return None
            right, left = (tip, left) if side < 0 else (right, tip)

    def _toward(self, a: int, b: int) -> tuple[int, int] | None:
        """The edge opposite a, right end first, of the triangle at a through which b is seen."""
        start = self._at[a]
        for ahead in (True, False):  # all the way round, or to the border and back from the start
            t: int | None = start
            while t is not None:
                i, j, k = self.triangles[t]
                x, y = (j, k) if i == a else (k, i) if j == a else (i, j)
                if self._turn(a, x, b) > 0 and self._turn(a, b, y) > 0:
                    return x, y
                t = self.left.get((a, y) if ahead else (x, a))
                if t == start:
                    return None
        return None

    def _search(self, a: int, b: int) -> list[tuple[int, int]]:
        """What `_walk` finds, among all edges: where corners lie on the segment or triangles have no area."""
        pairs = np.array([pair for pair in self.left if pair[0] < pair[1]], np.int64)
        p, q, s, e = self._points[pairs[:, 0]], self._points[pairs[:, 1]], self._points[a], self._points[b]
        apart = (_side(s, e, p) * _side(s, e, q) < 0) & (_side(p, q, s[None]) * _side(p, q, e[None]) < 0)
        shared = (pairs == a).any(axis=1) | (pairs == b).any(axis=1)
        return self._nearest_first([(u, v) for u, v in pairs[apart & ~shared].tolist()], a)

    def _nearest_first(self, edges: list[tuple[int, int]], a: int) -> list[tuple[int, int]]:
        x, y = self.xy[a]

        def distance(edge: tuple[int, int]) -> float:
            (xu, yu), (xv, yv) = self.xy[edge[0]], self.xy[edge[1]]
            return math.hypot((xu + xv) / 2 - x, (yu + yv) / 2 - y)

        return sorted(edges, key=distance)

    def _flip(self, u: int, v: int, p: int, q: int) -> None:
        """Replaces the edge between u and v by that between the corners p and q opposite it."""
        one, two = self.left.pop((u, v)), self.left.pop((v, u))
        self.triangles[one], self.triangles[two] = (p, u, q), (q, v, p)
        for t, (i, j, k) in ((one, self.triangles[one]), (two, self.triangles[two])):
            self.left[i, j] = self.left[j, k] = self.left[k, i] = t
            self._at[i] = self._at[j] = self._at[k] = t

    def _turn(self, i: int, j: int, k: int) -> float:
        (xi, yi), (xj, yj), (xk, yk) = self.xy[i], self.xy[j], self.xy[k]
        return (xj - xi) * (yk - yi) - (yj - yi) * (xk - xi)


def _side(origin: Floats, tip: Floats, x: Floats) -> Floats:
    """On which side of the lines from origin to tip points lie: positive on the left."""
    d, w = tip - origin, x - origin
    return d[..., 0] * w[..., 1] - d[..., 1] * w[..., 0]
