"""Counts mesh edges that pass through faces: cloth through cloth, cloth through body."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.arrays import Floats, Ints
from swifttailor.draping.contact_kernels import edge_hits_face
from swifttailor.draping.spatial_hash import hash_cell


def self_intersections(vertices: Floats, edges: Ints, faces: Ints) -> int:
    """Number of (edge, face) pairs of one mesh that cross; pairs that share a vertex do not count.

    Args:
        vertices: (v, 3) cm.
        edges: (e, 2)
        faces: (f, 3)
    """
    return len(crossing_pairs(vertices, edges, faces))


def crossing_pairs(vertices: Floats, edges: Ints, faces: Ints) -> Ints:
    """Which edges pass through which faces of the same mesh: (n, 2) indices of edge and face."""
    return _crossings(np.ascontiguousarray(vertices, np.float64), _i32(edges), _i32(faces), True)


def mesh_intersections(vertices: Floats, edges: Ints, other_vertices: Floats, other_faces: Ints) -> int:
    """Number of (edge, face) pairs in which an edge of the first mesh passes through a face of the second."""
    joined = np.ascontiguousarray(np.concatenate([vertices, other_vertices]), np.float64)
    return len(_crossings(joined, _i32(edges), _i32(other_faces + len(vertices)), False))


def _i32(array: Ints) -> Ints:
    return np.ascontiguousarray(array, np.int32)


@njit(cache=True)
def _crossings(x, edges, faces, same):
    """Hashes faces by the cells their boxes touch, then tests each edge against the faces of its cells."""
    pairs = np.zeros((256, 2), np.int32)
    if len(edges) == 0 or len(faces) == 0:
        return pairs[:0]
    cell = 2.0
    size = 16
    while size < 8 * len(faces):
        size *= 2
    mask = size - 1
    start = np.zeros(size + 1, np.int64)
    fill = start[:-1].copy()
    ids = np.zeros(0, np.int32)
    low, high = np.zeros(3, np.int64), np.zeros(3, np.int64)
    for sweep in range(2):
        for f in range(len(faces)):
            a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
            for k in range(3):
                low[k] = math.floor(min(x[a, k], x[b, k], x[c, k]) / cell)
                high[k] = math.floor(max(x[a, k], x[b, k], x[c, k]) / cell)
            for i in range(low[0], high[0] + 1):
                for j in range(low[1], high[1] + 1):
                    for k in range(low[2], high[2] + 1):
                        h = hash_cell(i, j, k, mask)
                        if sweep == 0:
                            start[h + 1] += 1
                        else:
                            ids[fill[h]] = f
                            fill[h] += 1
        if sweep == 0:
            for h in range(size):
                start[h + 1] += start[h]
            fill = start[:-1].copy()
            ids = np.zeros(start[-1], np.int32)
    total = 0
    seen = np.full(len(faces), -1, np.int64)
    for e in range(len(edges)):
        p, q = edges[e, 0], edges[e, 1]
        for k in range(3):
            low[k] = math.floor(min(x[p, k], x[q, k]) / cell)
            high[k] = math.floor(max(x[p, k], x[q, k]) / cell)
        for i in range(low[0], high[0] + 1):
            for j in range(low[1], high[1] + 1):
                for k in range(low[2], high[2] + 1):
                    h = hash_cell(i, j, k, mask)
                    for r in range(start[h], start[h + 1]):
                        f = ids[r]
                        if seen[f] == e:
                            continue
                        seen[f] = e
                        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
                        if same and (p == a or p == b or p == c or q == a or q == b or q == c):
                            continue
                        hit, _ = edge_hits_face(x, p, q, a, b, c)
                        if hit:
                            if total == len(pairs):
                                larger = np.zeros((2 * total, 2), np.int32)
                                larger[:total] = pairs
                                pairs = larger
                            pairs[total, 0], pairs[total, 1] = e, f
                            total += 1
    return pairs[:total]
