"""Self-collision of the cloth: vertex-face contacts kept apart, crossings of edges and faces untangled."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numba import njit

from swifttailor.draping.spatial_hash import grown, hash_cell, hash_points

FAST: dict[str, Any] = {
    "cache": True,
    "fastmath": {"reassoc", "contract", "arcp", "nsz"},
    "error_model": "numpy",
}

CELL = 1.5
"""Size of a hash cell. This and the next two are in units of `ClothArrays.spacing`: the longer lists of a
finer mesh would make its cost grow faster than its vertices."""
SKIN = 0.5
"""Neighbour lists reach this much further than needed and stay valid until a vertex has moved half of it."""
MARGIN = 0.25
"""Contacts are noticed this much before they act."""
FOLDED = -0.6
"""Barycentric coordinate beyond which a surface neighbour counts as lying beside the face, not on it."""
CLOTH_FRICTION = 0.3
"""Coulomb friction between layers of cloth."""
MAX_LIFT = 0.02
"""Layers already too close move apart by at most this much per substep, cm: more would make them jump."""
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


def no_neighbors() -> NeighborLists:
    """Lists to begin with."""
    return NeighborLists(np.zeros(4096, np.int32), np.zeros(4096, np.int32), 0, np.zeros((0, 3)))


@njit(**FAST)
def has_moved(x, cloth, lists):
    """Whether the lists are empty or a vertex has moved more than half the skin since they were made."""
    if lists.anchor.shape[0] == 0:
        return True
    limit = 0.25 * (SKIN * cloth.spacing) ** 2
    for i in range(x.shape[0]):
        dx, dy, dz = x[i, 0] - lists.anchor[i, 0], x[i, 1] - lists.anchor[i, 1], x[i, 2] - lists.anchor[i, 2]
        if dx * dx + dy * dy + dz * dz > limit:
            return True
    return False


@njit(**FAST)
def list_neighbors(x, cloth, lists):
    """Lists vertices near faces, surface neighbours only where the cloth is folded; overwrites old lists.

    An edge that passes through a face has an end within half its length of the face, so a vertex is listed
    as far out as half its longest edge; the same list then serves contacts and crossings.
    """
    faces, edges = cloth.faces, cloth.edges
    cell, skin = CELL * cloth.spacing, SKIN * cloth.spacing
    reach_of = cloth.radius + MARGIN * cloth.spacing
    longest = min(0.65 * cloth.rest.mean(), MAX_REACH)
    for e in range(edges.shape[0]):
        p, q = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[q, 0] - x[p, 0], x[q, 1] - x[p, 1], x[q, 2] - x[p, 2]
        half = min(0.5 * math.sqrt(dx * dx + dy * dy + dz * dz), longest)
        reach_of[p] = max(reach_of[p], half)
        reach_of[q] = max(reach_of[q], half)
    furthest = reach_of.max() + skin
    start, ids, mask = hash_points(x, cell)
    vertex, face, anchor = lists.vertex, lists.face, lists.anchor
    count = 0
    for f in range(faces.shape[0]):
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        low0, high0 = min(x[a, 0], x[b, 0], x[c, 0]), max(x[a, 0], x[b, 0], x[c, 0])
        low1, high1 = min(x[a, 1], x[b, 1], x[c, 1]), max(x[a, 1], x[b, 1], x[c, 1])
        low2, high2 = min(x[a, 2], x[b, 2], x[c, 2]), max(x[a, 2], x[b, 2], x[c, 2])
        if max(high0 - low0, high1 - low1, high2 - low2) > 4 * MAX_REACH:
            continue  # a triangle still stretched between two panels
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
        norm = math.sqrt(nx * nx + ny * ny + nz * nz) + 1e-15
        nx, ny, nz = nx / norm, ny / norm, nz / norm
        uu, uw, ww = ux * ux + uy * uy + uz * uz, ux * wx + uy * wy + uz * wz, wx * wx + wy * wy + wz * wz
        inverse = 1.0 / (uu * ww - uw * uw + 1e-20)
        for i in range(math.floor((low0 - furthest) / cell), math.floor((high0 + furthest) / cell) + 1):
            for j in range(math.floor((low1 - furthest) / cell), math.floor((high1 + furthest) / cell) + 1):
                for k in range(
                    math.floor((low2 - furthest) / cell), math.floor((high2 + furthest) / cell) + 1
                ):
                    h = hash_cell(i, j, k, mask)
                    for r in range(start[h], start[h + 1]):
                        p = ids[r]
                        reach = reach_of[p] + skin
                        px, py, pz = x[p, 0], x[p, 1], x[p, 2]
                        d = (px - x[a, 0]) * nx + (py - x[a, 1]) * ny + (pz - x[a, 2]) * nz
                        if d > reach or d < -reach:
                            continue
                        if px < low0 - reach or px > high0 + reach or py < low1 - reach or py > high1 + reach:
                            continue
                        if pz < low2 - reach or pz > high2 + reach or p == a or p == b or p == c:
                            continue
                        if math.floor(px / cell) != i or math.floor(py / cell) != j:
                            continue  # from another cell in the same bucket
                        near = False
                        for m in range(cloth.neighbor_start[p], cloth.neighbor_start[p + 1]):
                            o = cloth.neighbors[m]
                            if o == a or o == b or o == c:
                                near = True
                                break
                        if near:
                            # A surface neighbour matters only where the cloth is folded over onto itself;
                            # lying flat it has a barycentric coordinate of about -1.
                            dx, dy, dz = px - x[a, 0], py - x[a, 1], pz - x[a, 2]
                            pu, pw = dx * ux + dy * uy + dz * uz, dx * wx + dy * wy + dz * wz
                            g = (ww * pu - uw * pw) * inverse
                            t = (uu * pw - uw * pu) * inverse
                            if g < FOLDED or t < FOLDED or g + t > 1.0 - FOLDED:
                                continue
                        if count == len(vertex):
                            vertex, face = grown(vertex), grown(face)
                        vertex[count], face[count] = p, f
                        count += 1
    if anchor.shape[0] == 0:
        anchor = np.empty_like(x)
    anchor[:] = x
    return NeighborLists(vertex, face, count, anchor)


@njit(**FAST)
def find_contacts(x, cloth, contacts, lists):
    """Picks the listed vertices that are close to their face, with the side they are on. Returns how many.

    Pairs between vertices marked as tangled are left out: their side cannot be trusted, and
    `shrink_crossings` moves them apart.
    """
    faces, radius = cloth.faces, cloth.radius
    limit = contacts.vertex.shape[0]
    found = 0
    for q in range(lists.count):
        p, f = lists.vertex[q], lists.face[q]
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
        dx, dy, dz = x[p, 0] - x[a, 0], x[p, 1] - x[a, 1], x[p, 2] - x[a, 2]
        d = dx * nx + dy * ny + dz * nz
        reach = min(radius[p], max(radius[a], radius[b], radius[c])) + MARGIN * cloth.spacing
        if d * d > reach * reach * (nx * nx + ny * ny + nz * nz):
            continue
        uu, uw, ww = ux * ux + uy * uy + uz * uz, ux * wx + uy * wy + uz * wz, wx * wx + wy * wy + wz * wz
        inverse = 1.0 / (uu * ww - uw * uw + 1e-20)
        pu, pw = dx * ux + dy * uy + dz * uz, dx * wx + dy * wy + dz * wz
        s = (ww * pu - uw * pw) * inverse
        t = (uu * pw - uw * pu) * inverse
        if s < -0.3 or t < -0.3 or s + t > 1.3:
            continue
        if contacts.tangled[p] > 0 and contacts.tangled[a] + contacts.tangled[b] + contacts.tangled[c] > 0:
            continue
        if found < limit:
            contacts.vertex[found] = p
            contacts.face[found] = f
            contacts.side[found] = 1.0 if d >= 0 else -1.0
            found += 1
    return found


@njit(**FAST)
def resolve_contacts(x, previous, cloth, contacts, count):
    """Keeps each listed vertex on its side of the face, one thickness away."""
    faces, im, radius = cloth.faces, cloth.inverse_mass, cloth.radius
    for q in range(count):
        p, f = contacts.vertex[q], contacts.face[q]
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
        norm = contacts.side[q] / (math.sqrt(nx * nx + ny * ny + nz * nz) + 1e-15)
        nx, ny, nz = nx * norm, ny * norm, nz * norm
        dx, dy, dz = x[p, 0] - x[a, 0], x[p, 1] - x[a, 1], x[p, 2] - x[a, 2]
        d = dx * nx + dy * ny + dz * nz
        thickness = min(radius[p], max(radius[a], radius[b], radius[c]))
        if d >= thickness or d < -1.5:
            continue
        uu, uw, ww = ux * ux + uy * uy + uz * uz, ux * wx + uy * wy + uz * wz, wx * wx + wy * wy + wz * wz
        pu, pw = dx * ux + dy * uy + dz * uz, dx * wx + dy * wy + dz * wz
        inverse = 1.0 / (uu * ww - uw * uw + 1e-20)
        s = (ww * pu - uw * pw) * inverse
        t = (uu * pw - uw * pu) * inverse
        r = 1.0 - s - t
        if r < -0.05 or s < -0.05 or t < -0.05:
            continue
        # Motion of the vertex relative to the point of the face below it, in this substep.
        mx = (x[p, 0] - previous[p, 0]) - r * (x[a, 0] - previous[a, 0])
        my = (x[p, 1] - previous[p, 1]) - r * (x[a, 1] - previous[a, 1])
        mz = (x[p, 2] - previous[p, 2]) - r * (x[a, 2] - previous[a, 2])
        mx -= s * (x[b, 0] - previous[b, 0]) + t * (x[c, 0] - previous[c, 0])
        my -= s * (x[b, 1] - previous[b, 1]) + t * (x[c, 1] - previous[c, 1])
        mz -= s * (x[b, 2] - previous[b, 2]) + t * (x[c, 2] - previous[c, 2])
        along = mx * nx + my * ny + mz * nz
        tx, ty, tz = mx - along * nx, my - along * ny, mz - along * nz
        slide = math.sqrt(tx * tx + ty * ty + tz * tz) + 1e-12
        push = min(0.5 * (thickness - d), max(-along, 0.0) + MAX_LIFT)
        # As off the body: the part of the push that does more than stop the approach is no velocity.
        lift = max(push - max(-along, 0.0), 0.0)
        rub = -min(CLOTH_FRICTION * push, 0.5 * slide) / slide
        share = 1.0 / (im[p] + r * r * im[a] + s * s * im[b] + t * t * im[c])
        for corner in range(4):
            if corner == 0:
                i, w = p, share * im[p]
            elif corner == 1:
                i, w = a, -share * r * im[a]
            elif corner == 2:
                i, w = b, -share * s * im[b]
            else:
                i, w = c, -share * t * im[c]
            x[i, 0] += w * (push * nx + rub * tx)
            x[i, 1] += w * (push * ny + rub * ty)
            x[i, 2] += w * (push * nz + rub * tz)
            previous[i, 0] += w * lift * nx
            previous[i, 1] += w * lift * ny
            previous[i, 2] += w * lift * nz


@njit(**FAST)
def edge_hits_face(x, p, q, a, b, c):
    """Whether segment pq passes through triangle abc, and where along pq (0 to 1)."""
    dx, dy, dz = x[q, 0] - x[p, 0], x[q, 1] - x[p, 1], x[q, 2] - x[p, 2]
    ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
    wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
    hx, hy, hz = dy * wz - dz * wy, dz * wx - dx * wz, dx * wy - dy * wx
    det = ux * hx + uy * hy + uz * hz
    if abs(det) < 1e-10:
        return False, 0.0
    inverse = 1.0 / det
    sx, sy, sz = x[p, 0] - x[a, 0], x[p, 1] - x[a, 1], x[p, 2] - x[a, 2]
    u = inverse * (sx * hx + sy * hy + sz * hz)
    if u < 0.0 or u > 1.0:
        return False, 0.0
    gx, gy, gz = sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux
    v = inverse * (dx * gx + dy * gy + dz * gz)
    if v < 0.0 or u + v > 1.0:
        return False, 0.0
    t = inverse * (wx * gx + wy * gy + wz * gz)
    return 0.0 <= t <= 1.0, t


@njit(**FAST)
def contour_gradient(x, cloth, e, f):
    """Direction (3,) in which moving edge e against face f shortens the line in which the cloth crosses.

    P. Volino, N. Magnenat-Thalmann, "Resolving surface collisions through intersection contour
    minimization", 2006.
    """
    faces = cloth.faces
    p, q = cloth.edges[e, 0], cloth.edges[e, 1]
    a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
    ex, ey, ez = x[q, 0] - x[p, 0], x[q, 1] - x[p, 1], x[q, 2] - x[p, 2]
    norm = math.sqrt(ex * ex + ey * ey + ez * ez) + 1e-12
    ex, ey, ez = ex / norm, ey / norm, ez / norm
    ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
    wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
    nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
    norm = math.sqrt(nx * nx + ny * ny + nz * nz) + 1e-12
    nx, ny, nz = nx / norm, ny / norm, nz / norm
    slope = ex * nx + ey * ny + ez * nz
    if abs(slope) < 0.1:  # an edge almost in the face would ask for a huge motion
        slope = 0.1 if slope >= 0 else -0.1
    gx, gy, gz = 0.0, 0.0, 0.0
    for side in range(2):
        t = cloth.edge_faces[e, side]
        if t < 0:
            continue
        o = faces[t, 0] + faces[t, 1] + faces[t, 2] - p - q
        ox, oy, oz = x[o, 0] - x[p, 0], x[o, 1] - x[p, 1], x[o, 2] - x[p, 2]
        mx, my, mz = ey * oz - ez * oy, ez * ox - ex * oz, ex * oy - ey * ox
        rx, ry, rz = my * nz - mz * ny, mz * nx - mx * nz, mx * ny - my * nx
        norm = math.sqrt(rx * rx + ry * ry + rz * rz)
        if norm < 1e-9:
            continue
        # The contour leaves the edge into this triangle: away from the edge towards o.
        along = ox * ex + oy * ey + oz * ez
        if rx * (ox - along * ex) + ry * (oy - along * ey) + rz * (oz - along * ez) < 0:
            norm = -norm
        rx, ry, rz = rx / norm, ry / norm, rz / norm
        k = (ex * rx + ey * ry + ez * rz) / slope
        gx += rx - k * nx
        gy += ry - k * ny
        gz += rz - k * nz
    return gx, gy, gz


@njit(**FAST)
def find_crossings(x, cloth, contacts, lists):
    """Finds edges of listed vertices that pass through the listed face, with the push that mends it.

    Returns how many; marks the vertices around them as tangled.
    """
    faces = cloth.faces
    contacts.tangled[:] = 0
    limit = contacts.crossing_edge.shape[0]
    found = 0
    for r in range(lists.count):
        p, f = lists.vertex[r], lists.face[r]
        a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
        ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
        wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
        nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
        dp = (x[p, 0] - x[a, 0]) * nx + (x[p, 1] - x[a, 1]) * ny + (x[p, 2] - x[a, 2]) * nz
        for m in range(cloth.neighbor_start[p], cloth.neighbor_start[p + 1]):
            q = cloth.neighbors[m]
            dq = (x[q, 0] - x[a, 0]) * nx + (x[q, 1] - x[a, 1]) * ny + (x[q, 2] - x[a, 2]) * nz
            if dp * dq > 0 or q == a or q == b or q == c:
                continue
            # Both ends may be listed with this face: the end nearer to the face's plane reports the edge.
            if abs(dq) < abs(dp) or (abs(dq) == abs(dp) and q < p):
                continue
            hit, _ = edge_hits_face(x, p, q, a, b, c)
            if not hit or found >= limit:
                continue
            e = cloth.neighbor_edge[m]
            contacts.crossing_edge[found] = e
            contacts.crossing_face[found] = f
            gx, gy, gz = contour_gradient(x, cloth, e, f)
            contacts.crossing_push[found, 0] = gx
            contacts.crossing_push[found, 1] = gy
            contacts.crossing_push[found, 2] = gz
            found += 1
            for i in (p, q, a, b, c):
                contacts.tangled[i] = 1
    return found


@njit(**FAST)
def shrink_crossings(x, previous, cloth, contacts, count, largest):
    """Moves crossing edges and faces apart a little; the motion is not turned into velocity."""
    faces, edges = cloth.faces, cloth.edges
    for q in range(count):
        e, f = contacts.crossing_edge[q], contacts.crossing_face[q]
        gx, gy, gz = contacts.crossing_push[q, 0], contacts.crossing_push[q, 1], contacts.crossing_push[q, 2]
        norm = math.sqrt(gx * gx + gy * gy + gz * gz)
        s = 0.5 * largest / math.sqrt(norm * norm + 0.09)
        gx, gy, gz = s * gx, s * gy, s * gz
        for k in range(2):
            i = edges[e, k]
            x[i, 0] += gx
            x[i, 1] += gy
            x[i, 2] += gz
            previous[i, 0] += gx
            previous[i, 1] += gy
            previous[i, 2] += gz
        for k in range(3):
            i = faces[f, k]
            x[i, 0] -= gx
            x[i, 1] -= gy
            x[i, 2] -= gz
            previous[i, 0] -= gx
            previous[i, 1] -= gy
            previous[i, 2] -= gz
