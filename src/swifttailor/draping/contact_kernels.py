"""Self-collision of the cloth: vertex-face contacts kept apart, crossings of edges and faces untangled."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.draping.compile_options import FAST
from swifttailor.draping.neighbor_lists import MARGIN

CLOTH_FRICTION = 0.3
"""Coulomb friction between layers of cloth."""
MAX_LIFT = 0.02
"""Layers already too close move apart by at most this much per substep, cm: more would make them jump."""


@njit(**FAST)
def find_contacts(x, cloth, contacts, lists):
    """Picks the listed vertices that are close to their face, with the side they are on. Returns how many.

    Pairs between vertices marked as tangled are left out: their side cannot be trusted, and
    `shrink_crossings` moves them apart.
    """
    faces, radius = cloth.faces, cloth.radius
    limit = contacts.vertex.shape[0]
    found = 0
    last = -1
    a, b, c = 0, 0, 0
    ux, uy, uz, wx, wy, wz, nx, ny, nz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    uu, uw, ww, inverse, square, thickest = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    is_clear = True
    for q in range(lists.count):
        p, f = lists.vertex[q], lists.face[q]
        if f != last:
            last = f
            a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
            ux, uy, uz = x[b, 0] - x[a, 0], x[b, 1] - x[a, 1], x[b, 2] - x[a, 2]
            wx, wy, wz = x[c, 0] - x[a, 0], x[c, 1] - x[a, 1], x[c, 2] - x[a, 2]
            nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
            square = nx * nx + ny * ny + nz * nz
            thickest = max(radius[a], radius[b], radius[c])
            is_clear = contacts.tangled[a] + contacts.tangled[b] + contacts.tangled[c] == 0
            uu, uw, ww = (
                ux * ux + uy * uy + uz * uz,
                ux * wx + uy * wy + uz * wz,
                wx * wx + wy * wy + wz * wz,
            )
            inverse = 1.0 / (uu * ww - uw * uw + 1e-20)
        dx, dy, dz = x[p, 0] - x[a, 0], x[p, 1] - x[a, 1], x[p, 2] - x[a, 2]
        d = dx * nx + dy * ny + dz * nz
        reach = min(radius[p], thickest) + MARGIN * cloth.spacing
        pu, pw = dx * ux + dy * uy + dz * uz, dx * wx + dy * wy + dz * wz
        s = (ww * pu - uw * pw) * inverse
        t = (uu * pw - uw * pu) * inverse
        # Without branches, which would be mispredicted: every pair is written, and the next one over it
        # unless it is kept.
        near = (d * d <= reach * reach * square) & (s >= -0.3) & (t >= -0.3) & (s + t <= 1.3)
        kept = near & ((contacts.tangled[p] == 0) | is_clear)
        contacts.vertex[found] = p
        contacts.face[found] = f
        contacts.side[found] = 1.0 if d >= 0 else -1.0
        found += 1 if kept else 0
        if found == limit:
            break
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
def _longest_half_edges(x, cloth):
    """(v,) half the length of each vertex's longest edge, and a little more, cm."""
    edges = cloth.edges
    longest = np.zeros(x.shape[0])
    for e in range(edges.shape[0]):
        p, q = edges[e, 0], edges[e, 1]
        dx, dy, dz = x[q, 0] - x[p, 0], x[q, 1] - x[p, 1], x[q, 2] - x[p, 2]
        half = 0.5001 * math.sqrt(dx * dx + dy * dy + dz * dz)
        longest[p] = max(longest[p], half)
        longest[q] = max(longest[q], half)
    return longest


@njit(**FAST)
def _pairs_within(x, faces, half_edge, lists, near):
    """Numbers of the listed pairs whose vertex may be the nearer end of an edge through the face.

    That end is within half the edge of where it passes through, so of the face's plane and of its box. There
    are no branches, which would be mispredicted. Returns how many `near` is filled with.
    """
    count = 0
    last = -1
    ax, ay, az, nx, ny, nz, square = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    low0, low1, low2, high0, high1, high2 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for r in range(lists.count):
        p, f = lists.vertex[r], lists.face[r]
        if f != last:
            last = f
            a, b, c = faces[f, 0], faces[f, 1], faces[f, 2]
            ax, ay, az = x[a, 0], x[a, 1], x[a, 2]
            ux, uy, uz = x[b, 0] - ax, x[b, 1] - ay, x[b, 2] - az
            wx, wy, wz = x[c, 0] - ax, x[c, 1] - ay, x[c, 2] - az
            nx, ny, nz = uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx
            square = nx * nx + ny * ny + nz * nz
            low0, high0 = min(ax, x[b, 0], x[c, 0]), max(ax, x[b, 0], x[c, 0])
            low1, high1 = min(ay, x[b, 1], x[c, 1]), max(ay, x[b, 1], x[c, 1])
            low2, high2 = min(az, x[b, 2], x[c, 2]), max(az, x[b, 2], x[c, 2])
        px, py, pz = x[p, 0], x[p, 1], x[p, 2]
        d = (px - ax) * nx + (py - ay) * ny + (pz - az) * nz
        off = max(max(low0 - px, px - high0), max(low1 - py, py - high1))
        off = max(off, max(low2 - pz, pz - high2))
        near[count] = r
        count += 1 if (off <= half_edge[p]) & (d * d <= half_edge[p] * half_edge[p] * square) else 0
    return count


@njit(**FAST)
def find_crossings(x, cloth, contacts, lists):
    """Finds edges of listed vertices that pass through the listed face, with the push that mends it.

    Returns how many; marks the vertices around them as tangled.
    """
    faces = cloth.faces
    contacts.tangled[:] = 0
    limit = contacts.crossing_edge.shape[0]
    found = 0
    half_edge = _longest_half_edges(x, cloth)
    near = np.zeros(lists.count + 1, np.int32)
    near_count = _pairs_within(x, faces, half_edge, lists, near)
    last = -1
    a, b, c = 0, 0, 0
    nx, ny, nz = 0.0, 0.0, 0.0
    for s in range(near_count):
        r = near[s]
        p, f = lists.vertex[r], lists.face[r]
        if f != last:
            last = f
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
            for i in (p, q):
                contacts.tangled[i] = 1
            for k in range(3):
                contacts.tangled[faces[f, k]] = 1
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
