"""Points sorted into the cells of the box around them, for the compiled loops."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numba import njit

_FURTHEST = 1e6
"""Points further out, or not finite, are left out, cm."""
_CELLS_PER_POINT = 64


class Grid(NamedTuple):
    """Cells in a row along z lie next to each other, so one look-up finds a whole row of them."""

    start: np.ndarray
    """(nx ny nz + 1,) where the points of each cell begin in `ids`."""
    ids: np.ndarray
    """Points, cell by cell, ascending within a cell."""
    low: np.ndarray
    """(3,) corner of the box, cm."""
    size: np.ndarray
    """(3,) number of cells along each axis."""
    cell: float
    """Size of a cell, cm."""


@njit(cache=True)
def clamped_cell(value, low, cell, count):
    """Number of the cell along one axis; the outermost for what lies outside."""
    return min(max(math.floor((value - low) / cell), 0), count - 1)


@njit(cache=True)
def sort_into_cells(points, chosen, cell):
    """Sorts the chosen (n,) of the points (n, 3) into cells of at least the given size, cm."""
    n = points.shape[0]
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    kept = np.zeros(n, np.bool_)
    for i in range(n):
        # Written so that it is false for what is not a number.
        kept[i] = chosen[i] and (
            abs(points[i, 0]) < _FURTHEST and abs(points[i, 1]) < _FURTHEST and abs(points[i, 2]) < _FURTHEST
        )
        if kept[i]:
            for k in range(3):
                low[k] = min(low[k], points[i, k])
                high[k] = max(high[k], points[i, k])
    size = np.ones(3, np.int64)
    if low[0] <= high[0]:
        while True:
            for k in range(3):
                size[k] = math.floor((high[k] - low[k]) / cell) + 1
            if size[0] * size[1] * size[2] <= _CELLS_PER_POINT * n + 4096:
                break
            cell *= 1.26
    else:
        low[:] = 0.0
    start = np.zeros(size[0] * size[1] * size[2] + 1, np.int32)
    cell_of = np.zeros(n, np.int32)
    for i in range(n):
        if not kept[i]:
            continue
        q = clamped_cell(points[i, 0], low[0], cell, size[0])
        q = q * size[1] + clamped_cell(points[i, 1], low[1], cell, size[1])
        q = q * size[2] + clamped_cell(points[i, 2], low[2], cell, size[2])
        cell_of[i] = q
        start[q + 1] += 1
    for q in range(len(start) - 1):
        start[q + 1] += start[q]
    fill = start[:-1].copy()
    ids = np.zeros(start[-1], np.int32)
    for i in range(n):
        if kept[i]:
            ids[fill[cell_of[i]]] = i
            fill[cell_of[i]] += 1
    return Grid(start, ids, low, size, cell)
