"""A spatial hash for the compiled loops: points sorted into buckets by the cell of space they lie in."""

from __future__ import annotations

import math

import numpy as np
from numba import njit


@njit(cache=True)
def hash_cell(i, j, k, mask):
    """Bucket of a lattice cell."""
    return ((i * 73856093) ^ (j * 19349663) ^ (k * 83492791)) & mask


@njit(cache=True)
def hash_points(points, cell):
    """Sorts points into buckets by their cell: (bucket starts, point ids, mask)."""
    n = points.shape[0]
    size = 16
    while size < 2 * n:
        size *= 2
    mask = size - 1
    start = np.zeros(size + 1, np.int32)
    bucket = np.zeros(n, np.int32)
    for i in range(n):
        h = hash_cell(
            math.floor(points[i, 0] / cell),
            math.floor(points[i, 1] / cell),
            math.floor(points[i, 2] / cell),
            mask,
        )
        bucket[i] = h
        start[h + 1] += 1
    for h in range(size):
        start[h + 1] += start[h]
    fill = start[:-1].copy()
    ids = np.zeros(n, np.int32)
    for i in range(n):
        ids[fill[bucket[i]]] = i
        fill[bucket[i]] += 1
    return start, ids, mask


@njit(cache=True)
def grown(array):
    """The array with room for twice as many entries."""
    larger = np.zeros(2 * len(array), array.dtype)
    larger[: len(array)] = array
    return larger
