"""Which vertices may come to touch which faces: found seldom, looked through often."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numba import njit

from swifttailor.draping.compile_options import FAST
from swifttailor.draping.spatial_grid import clamped_cell, sort_into_cells

CELL = 1.0
"""Size of a cell of the search. This, skins and the margin are in units of `ClothArrays.spacing`: the longer
lists of a finer mesh would make its cost grow faster than its vertices."""
SKIN = 0.5
"""Neighbour lists reach this much further than needed and stay valid until a vertex has moved half of it."""
AHEAD = 1 / 60
"""Vertices too fast for that get a longer skin, for so many seconds: else one of them would cost all others
new lists several times a frame."""
MAX_SKIN = 0.75
"""Longest skin."""
MARGIN = 0.25
"""Contacts are noticed this much before they act."""
FOLDED = -0.6
"""Barycentric coordinate beyond which a surface neighbour counts as lying beside the face, not on it."""
MAX_REACH = 2.0
"""Longer edges, still stretched between two panels, are searched for only this far from their ends, cm."""


class NeighborLists(NamedTuple):
    """Vertex-face pairs that may come to touch, and where the vertices were when they were listed."""

    vertex: np.ndarray
    """(at least count,); the arrays are used again for the next lists: taking memory anew took a tenth of a
    drape's time."""
    face: np.ndarray
    """(at least count,) ascending"""
    count: int
    anchor: np.ndarray
    """(v, 3) cm; an empty array means that nothing is listed yet"""
    skin: np.ndarray
    """(v,) how much further each vertex was looked for, cm"""


def no_neighbors() -> NeighborLists:
    """Lists to begin with."""
    return NeighborLists(np.zeros(4096, np.int32), np.zeros(4096, np.int32), 0, np.zeros((0, 3)), np.zeros(0))


@njit(**FAST)
def has_moved(x, lists):
    """Whether the lists are empty or a vertex has moved more than half its skin since they were made."""
    if lists.anchor.shape[0] == 0:
        return True
    for i in range(x.shape[0]):
        dx, dy, dz = x[i, 0] - lists.anchor[i, 0], x[i, 1] - lists.anchor[i, 1], x[i, 2] - lists.anchor[i, 2]
        if dx * dx + dy * dy + dz * dz > 0.25 * lists.skin[i] * lists.skin[i]:
            return True
    return False


@njit(**FAST)
def _grown(array):
    """The array with room for twice as many entries."""
    larger = np.zeros(2 * len(array), array.dtype)
    larger[: len(array)] = array
    return larger


@njit(**FAST)
def list_neighbors(x, v, cloth, lists):
    """Lists vertices near faces, surface neighbours only where the cloth is folded; overwrites old lists.

    An edge that passes through a face has an end within half its length of the face, so a vertex is listed
    as far out as half its longest edge; the same list then serves contacts and crossings.
    """
    faces, edges = cloth.faces, cloth.edges
    cell, usual = CELL * cloth.spacing, SKIN * cloth.spacing
    reach_of = cloth.radius + MARGIN * cloth.spacing
    longest = min(0.65 * cloth.rest.mean(), MAX_REACH)
    for e in range(edges.shape[0]):
        p, q = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[q, 0] - x[p, 0], x[q, 1] - x[p, 1], x[q, 2] - x[p, 2]
        half = min(0.5 * math.sqrt(dx * dx + dy * dy + dz * dz), longest)
        reach_of[p] = max(reach_of[p], half)
        reach_of[q] = max(reach_of[q], half)
    anchor, skin = lists.anchor, lists.skin
    if anchor.shape[0] == 0:
        anchor, skin = np.zeros_like(x), np.zeros(x.shape[0])
    slow = np.zeros(x.shape[0], np.bool_)
    furthest_slow, furthest_fast = 0.0, 0.0
    for i in range(x.shape[0]):
        speed = math.sqrt(v[i, 0] * v[i, 0] + v[i, 1] * v[i, 1] + v[i, 2] * v[i, 2])
        skin[i] = max(usual, min(2 * AHEAD * speed, MAX_SKIN * cloth.spacing))
        slow[i] = skin[i] == usual
        reach_of[i] += 0.5 * skin[i]
        if slow[i]:
            furthest_slow = max(furthest_slow, reach_of[i])
        else:
            furthest_fast = max(furthest_fast, reach_of[i])
    slow_grid, fast_grid = sort_into_cells(x, slow, cell), sort_into_cells(x, ~slow, cell)
    beside = np.full(x.shape[0], -1, np.int32)  # the last face that a vertex is a surface neighbour of
    vertex, face = lists.vertex, lists.face
    count = 0
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        low0, high0 = min(x[a, 0], x[b, 0], x[c, 0]), max(x[a, 0], x[b, 0], x[c, 0])
        low1, high1 = min(x[a, 1], x[b, 1], x[c, 1]), max(x[a, 1], x[b, 1], x[c, 1])
        low2, high2 = min(x[a, 2], x[b, 2], x[c, 2]), max(x[a, 2], x[b, 2], x[c, 2])
        if not max(high0 - low0, high1 - low1, high2 - low2) <= 4 * MAX_REACH:
            continue  # a triangle still stretched between two panels
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
        norm = math.sqrt(nx * nx + ny * ny + nz * nz) + 1e-15
        nx, ny, nz = nx / norm, ny / norm, nz / norm
        uu, uw, ww = ux * ux + uy * uy + uz * uz, ux * wx + uy * wy + uz * wz, wx * wx + wy * wy + wz * wz
        inverse = 1.0 / (uu * ww - uw * uw + 1e-20)
        for corner in range(3):
            p = faces[f, corner]
            for m in range(cloth.neighbor_start[p], cloth.neighbor_start[p + 1]):
                beside[cloth.neighbors[m]] = f
        extra = 0.5 * max(skin[a], skin[b], skin[c])
        for k in range(2):
            grid, furthest = (slow_grid, furthest_slow) if k == 0 else (fast_grid, furthest_fast)
            if len(grid.ids) == 0:
                continue
            furthest += extra
            i_last = clamped_cell(high0 + furthest, grid.low[0], grid.cell, grid.size[0])
            j_first = clamped_cell(low1 - furthest, grid.low[1], grid.cell, grid.size[1])
            j_last = clamped_cell(high1 + furthest, grid.low[1], grid.cell, grid.size[1])
            k_first = clamped_cell(low2 - furthest, grid.low[2], grid.cell, grid.size[2])
            k_last = clamped_cell(high2 + furthest, grid.low[2], grid.cell, grid.size[2])
            for i in range(clamped_cell(low0 - furthest, grid.low[0], grid.cell, grid.size[0]), i_last + 1):
                for j in range(j_first, j_last + 1):
                    row = (i * grid.size[1] + j) * grid.size[2]
                    for r in range(grid.start[row + k_first], grid.start[row + k_last + 1]):
                        p = grid.ids[r]
                        reach = reach_of[p] + extra
                        px, py, pz = x[p, 0], x[p, 1], x[p, 2]
                        dx, dy, dz = px - x[a, 0], py - x[a, 1], pz - x[a, 2]
                        d = dx * nx + dy * ny + dz * nz
                        if d > reach or d < -reach:
                            continue
                        if px < low0 - reach or px > high0 + reach or py < low1 - reach or py > high1 + reach:
                            continue
                        if pz < low2 - reach or pz > high2 + reach:
                            continue
                        if beside[p] == f:
                            # A surface neighbour matters only where the cloth is folded over onto itself;
                            # lying flat it has a barycentric coordinate of about -1.
                            if p == a or p == b or p == c:
                                continue
                            pu, pw = dx * ux + dy * uy + dz * uz, dx * wx + dy * wy + dz * wz
                            g = (ww * pu - uw * pw) * inverse
                            t = (uu * pw - uw * pu) * inverse
                            if g < FOLDED or t < FOLDED or g + t > 1.0 - FOLDED:
                                continue
                        if count == len(vertex):
                            vertex, face = _grown(vertex), _grown(face)
                        vertex[count], face[count] = p, f
                        count += 1
    anchor[:] = x
    return NeighborLists(vertex, face, count, anchor, skin)
