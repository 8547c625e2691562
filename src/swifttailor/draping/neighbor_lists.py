"""Which vertices may come to touch which faces: found seldom, looked through often."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numba import njit

from swifttailor.draping.compile_options import FAST
from swifttailor.draping.neighbor_blocks import blocks_of_faces, gather
from swifttailor.draping.spatial_grid import sort_into_cells

CELL = 1.0
"""Size of a cell of the search. This, blocks, skins and the margin are in units of `ClothArrays.spacing`: the
longer lists of a finer mesh would make its cost grow faster than its vertices."""
BLOCK = 2.0
"""Size of the cells by which faces are taken together in the search."""
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
    found: np.ndarray
    """Room for vertices as they are found, block by block."""
    anchor: np.ndarray
    """(v, 3) cm; an empty array means that nothing is listed yet"""
    skin: np.ndarray
    """(v,) how much further each vertex was looked for, cm"""


def no_neighbors() -> NeighborLists:
    """Lists to begin with."""
    vertex, face, found = (np.zeros(4096, np.int32) for _ in range(3))
    return NeighborLists(vertex, face, 0, found, np.zeros((0, 3)), np.zeros(0))


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
def _with_room(array, count):
    """The array, or a longer copy of it, so that it holds at least so many entries."""
    if len(array) >= count:
        return array
    larger = np.zeros(2 * count, array.dtype)
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
    # A triangle still stretched between two panels is in no block.
    blocks = blocks_of_faces(x, faces, BLOCK * cloth.spacing, 4 * MAX_REACH)
    near, ids = np.zeros((4, x.shape[0] + 1)), np.zeros(x.shape[0] + 1, np.int32)
    hit, chosen = np.zeros(x.shape[0], np.uint8), np.zeros(x.shape[0] + 1, np.int32)
    first, many = np.zeros(faces.shape[0], np.int32), np.zeros(faces.shape[0], np.int32)
    low, high = np.zeros(3), np.zeros(3)
    found = lists.found
    count = 0
    for block in range(len(blocks.start) - 1):
        begin, end = blocks.start[block], blocks.start[block + 1]
        if begin == end:
            continue
        low[:], high[:] = np.inf, -np.inf
        extra = 0.0
        for r in range(begin, end):
            for corner in range(3):
                p = faces[blocks.ids[r], corner]
                extra = max(extra, 0.5 * skin[p])
                for k in range(3):
                    low[k], high[k] = min(low[k], x[p, k]), max(high[k], x[p, k])
        around = gather(slow_grid, x, reach_of, low, high, furthest_slow, extra, near, ids, 0)
        around = gather(fast_grid, x, reach_of, low, high, furthest_fast, extra, near, ids, around)
        found = _with_room(found, count + around * (end - begin) + 1)
        for r in range(begin, end):
            f = blocks.ids[r]
            a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
            ax, ay, az = x[a, 0], x[a, 1], x[a, 2]
            low0, high0 = min(ax, x[b, 0], x[c, 0]), max(ax, x[b, 0], x[c, 0])
            low1, high1 = min(ay, x[b, 1], x[c, 1]), max(ay, x[b, 1], x[c, 1])
            low2, high2 = min(az, x[b, 2], x[c, 2]), max(az, x[b, 2], x[c, 2])
            ux, uy, uz = x[b, 0] - ax, x[b, 1] - ay, x[b, 2] - az
            wx, wy, wz = x[c, 0] - ax, x[c, 1] - ay, x[c, 2] - az
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
            # These loops have no branches: the first is vectorised, the others would be mispredicted.
            for s in range(around):
                px, py, pz = near[0, s], near[1, s], near[2, s]
                off = abs((px - ax) * nx + (py - ay) * ny + (pz - az) * nz)
                off = max(off, max(low0 - px, px - high0))
                off = max(off, max(low1 - py, py - high1))
                off = max(off, max(low2 - pz, pz - high2))
                hit[s] = 1 if off <= near[3, s] + extra else 0
            hits = 0
            for s in range(around):
                chosen[hits] = s
                hits += hit[s]
            first[f] = count
            for h in range(hits):
                s = chosen[h]
                p = ids[s]
                dx, dy, dz = near[0, s] - ax, near[1, s] - ay, near[2, s] - az
                pu, pw = dx * ux + dy * uy + dz * uz, dx * wx + dy * wy + dz * wz
                g = (ww * pu - uw * pw) * inverse
                t = (uu * pw - uw * pu) * inverse
                # A surface neighbour matters only where the cloth is folded over onto itself; lying flat it
                # has a barycentric coordinate of about -1.
                flat = (p == a) | (p == b) | (p == c) | (g < FOLDED) | (t < FOLDED) | (g + t > 1.0 - FOLDED)
                found[count] = p
                count += 0 if flat & (beside[p] == f) else 1
            many[f] = count - first[f]
    vertex, face = _with_room(lists.vertex, count), _with_room(lists.face, count)
    listed = 0
    for f in range(faces.shape[0]):
        for r in range(first[f], first[f] + many[f]):
            vertex[listed], face[listed] = found[r], f
            listed += 1
    anchor[:] = x
    return NeighborLists(vertex, face, count, found, anchor, skin)
