"""Faces that lie together, and the vertices around them: looked for once for all of a block's faces."""

from __future__ import annotations

import numpy as np
from numba import njit

from swifttailor.draping.compile_options import FAST
from swifttailor.draping.spatial_grid import clamped_cell, sort_into_cells


@njit(**FAST)
def blocks_of_faces(x, faces, cell, longest):
    """A `Grid` of the middles of those faces that are not longer than `longest` along an axis, cm."""
    middles = np.zeros((faces.shape[0], 3))
    is_whole = np.zeros(faces.shape[0], np.bool_)
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        size = 0.0
        for k in range(3):
            low, high = min(x[a, k], x[b, k], x[c, k]), max(x[a, k], x[b, k], x[c, k])
            size = max(size, high - low)
            middles[f, k] = 0.5 * (low + high)
        is_whole[f] = size <= longest
    return sort_into_cells(middles, is_whole, cell)


@njit(**FAST)
def gather(grid, x, reach_of, low, high, furthest, extra, near, ids, count):
    """Copies the grid's vertices around a box next to each other, behind the `count` that are there.

    Args:
        grid: Vertices.
        x: (v, 3) where they are, cm.
        reach_of: (v,) how far from the box each may be, beside `extra`, cm; at most `furthest`.
        low: (3,) corner of the box, cm.
        high: (3,) the other corner.
        furthest: See `reach_of`.
        extra: Added to all reaches, cm.
        near: (4, at least v + 1) filled with position and reach of each that is found, cm.
        ids: (at least v + 1,) filled with their numbers.
        count: How many were found before.

    Returns:
        How many are found now.
    """
    if len(grid.ids) == 0:
        return count
    furthest += extra
    i_first = clamped_cell(low[0] - furthest, grid.low[0], grid.cell, grid.size[0])
    i_last = clamped_cell(high[0] + furthest, grid.low[0], grid.cell, grid.size[0])
    j_first = clamped_cell(low[1] - furthest, grid.low[1], grid.cell, grid.size[1])
    j_last = clamped_cell(high[1] + furthest, grid.low[1], grid.cell, grid.size[1])
    k_first = clamped_cell(low[2] - furthest, grid.low[2], grid.cell, grid.size[2])
    k_last = clamped_cell(high[2] + furthest, grid.low[2], grid.cell, grid.size[2])
    low0, low1, low2, high0, high1, high2 = low[0], low[1], low[2], high[0], high[1], high[2]
    for i in range(i_first, i_last + 1):
        for j in range(j_first, j_last + 1):
            row = (i * grid.size[1] + j) * grid.size[2]
            for r in range(grid.start[row + k_first], grid.start[row + k_last + 1]):
                p = grid.ids[r]
                px, py, pz = x[p, 0], x[p, 1], x[p, 2]
                off = max(max(low0 - px, px - high0), max(low1 - py, py - high1))
                off = max(off, max(low2 - pz, pz - high2))
                near[0, count], near[1, count], near[2, count] = px, py, pz
                near[3, count] = reach_of[p]
                ids[count] = p
                count += 1 if off <= reach_of[p] + extra else 0
    return count
