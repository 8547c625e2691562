"""Compiled queries on a triangle surface: closest point, inside or outside, and both on a lattice.

The triangles are sorted along a space-filling curve and grouped by a complete binary tree: node ``i`` has
the children ``2 i`` and ``2 i + 1``, the root is node 1, and leaf ``k`` is node ``leaf_count + k``. Whether
a point is inside is decided by the generalised winding number (Jacobson et al. 2013), far groups of
triangles being replaced by one dipole (Barill et al. 2018), so small holes, overlapping limbs and closed
shells inside the body do no harm.

All arrays are C-contiguous. ``corners`` (T, 9) float64 holds the sorted triangles; ``boxes`` (2 L, 6)
float64 the lower and upper bounds of each node; ``dipoles`` (2 L, 7) float64 its area vector, its centre
and the radius about it.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit

STACK_SIZE = 128
STRIDE = 4  # nodes from one coarse lattice point to the next
FAR_FACTOR = 2.5  # a group further away than this many radii is taken as a dipole


@njit(cache=True)
def squared_distance_to_triangle(px, py, pz, corners, t):
    """Squared distance from a point to triangle `t` (Ericson, Real-Time Collision Detection, 5.1.5)."""
    ax, ay, az = corners[t, 0], corners[t, 1], corners[t, 2]
    abx, aby, abz = corners[t, 3] - ax, corners[t, 4] - ay, corners[t, 5] - az
    acx, acy, acz = corners[t, 6] - ax, corners[t, 7] - ay, corners[t, 8] - az
    apx, apy, apz = px - ax, py - ay, pz - az
    d1 = abx * apx + aby * apy + abz * apz
    d2 = acx * apx + acy * apy + acz * apz
    v = 0.0
    w = 0.0
    if d1 > 0.0 or d2 > 0.0:
        bb = abx * abx + aby * aby + abz * abz
        cc = acx * acx + acy * acy + acz * acz
        bc = abx * acx + aby * acy + abz * acz
        d3, d4 = d1 - bb, d2 - bc
        d5, d6 = d1 - bc, d2 - cc
        vc = d1 * d4 - d3 * d2
        vb = d5 * d2 - d1 * d6
        va = d3 * d6 - d5 * d4
        if d3 >= 0.0 and d4 <= d3:
            v = 1.0
        elif d6 >= 0.0 and d5 <= d6:
            w = 1.0
        elif vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
            v = d1 / (d1 - d3)
        elif vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
            w = d2 / (d2 - d6)
        elif va <= 0.0 and d4 - d3 >= 0.0 and d5 - d6 >= 0.0:
            w = (d4 - d3) / ((d4 - d3) + (d5 - d6))
            v = 1.0 - w
        else:
            total = va + vb + vc
            if total > 0.0:
                v = vb / total
                w = vc / total
    dx = apx - v * abx - w * acx
    dy = apy - v * aby - w * acy
    dz = apz - v * abz - w * acz
    return dx * dx + dy * dy + dz * dz


@njit(cache=True)
def squared_distance_to_box(px, py, pz, boxes, node):
    """Squared distance from a point to the box of `node`, 0 inside."""
    dx = max(boxes[node, 0] - px, 0.0, px - boxes[node, 3])
    dy = max(boxes[node, 1] - py, 0.0, py - boxes[node, 4])
    dz = max(boxes[node, 2] - pz, 0.0, pz - boxes[node, 5])
    return dx * dx + dy * dy + dz * dz


@njit(cache=True)
def closest_triangle(px, py, pz, corners, boxes, guess, stack, far):
    """Nearest triangle, starting from the bound that triangle `guess` gives.

    Returns:
        Squared distance and index of the nearest sorted triangle.
    """
    count = corners.shape[0]
    leaves = boxes.shape[0] // 2
    best = guess
    best_d2 = squared_distance_to_triangle(px, py, pz, corners, guess)
    stack[0] = 1
    far[0] = squared_distance_to_box(px, py, pz, boxes, 1)
    top = 1
    while top > 0:
        top -= 1
        if far[top] >= best_d2:
            continue
        node = stack[top]
        while node < leaves:
            near = 2 * node
            other = near + 1
            near_d2 = squared_distance_to_box(px, py, pz, boxes, near)
            other_d2 = squared_distance_to_box(px, py, pz, boxes, other)
            if other_d2 < near_d2:
                near, other = other, near
                near_d2, other_d2 = other_d2, near_d2
            if other_d2 < best_d2:
                stack[top] = other
                far[top] = other_d2
                top += 1
            if near_d2 >= best_d2:
                node = -1
                break
            node = near
        if node < 0:
            continue
        leaf = node - leaves
        for t in range(leaf * count // leaves, (leaf + 1) * count // leaves):
            d2 = squared_distance_to_triangle(px, py, pz, corners, t)
            if d2 < best_d2:
                best_d2 = d2
                best = t
    return best_d2, best


@njit(cache=True)
def solid_angle(px, py, pz, corners, t):
    """Signed solid angle of triangle `t` seen from a point (Van Oosterom and Strackee 1983)."""
    ax, ay, az = corners[t, 0] - px, corners[t, 1] - py, corners[t, 2] - pz
    bx, by, bz = corners[t, 3] - px, corners[t, 4] - py, corners[t, 5] - pz
    cx, cy, cz = corners[t, 6] - px, corners[t, 7] - py, corners[t, 8] - pz
    a = math.sqrt(ax * ax + ay * ay + az * az)
    b = math.sqrt(bx * bx + by * by + bz * bz)
    c = math.sqrt(cx * cx + cy * cy + cz * cz)
    triple = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    denominator = (
        a * b * c
        + (ax * bx + ay * by + az * bz) * c
        + (bx * cx + by * cy + bz * cz) * a
        + (cx * ax + cy * ay + cz * az) * b
    )
    return 2.0 * math.atan2(triple, denominator)


@njit(cache=True)
def winding_number(px, py, pz, corners, dipoles, stack):
    """Generalised winding number of the surface about a point: 1 inside, 0 outside, if it is closed."""
    count = corners.shape[0]
    leaves = dipoles.shape[0] // 2
    total = 0.0
    stack[0] = 1
    top = 1
    while top > 0:
        top -= 1
        node = stack[top]
        dx, dy, dz = dipoles[node, 3] - px, dipoles[node, 4] - py, dipoles[node, 5] - pz
        d2 = dx * dx + dy * dy + dz * dz
        reach = FAR_FACTOR * dipoles[node, 6]
        if d2 > reach * reach:
            dot = dx * dipoles[node, 0] + dy * dipoles[node, 1] + dz * dipoles[node, 2]
            total += dot / (d2 * math.sqrt(d2))
        elif node < leaves:
            stack[top] = 2 * node
            stack[top + 1] = 2 * node + 1
            top += 2
        else:
            leaf = node - leaves
            for t in range(leaf * count // leaves, (leaf + 1) * count // leaves):
                total += solid_angle(px, py, pz, corners, t)
    return total / (4.0 * math.pi)


@njit(cache=True)
def signed_distances(points, corners, boxes, dipoles):
    """Signed distance and nearest sorted triangle of each of `points` (P, 3) float64."""
    stack = np.zeros(STACK_SIZE, np.int64)
    far = np.zeros(STACK_SIZE, np.float64)
    distance = np.zeros(points.shape[0], np.float64)
    nearest = np.zeros(points.shape[0], np.int64)
    guess = 0
    for p in range(points.shape[0]):
        x, y, z = points[p, 0], points[p, 1], points[p, 2]
        d2, guess = closest_triangle(x, y, z, corners, boxes, guess, stack, far)
        inside = winding_number(x, y, z, corners, dipoles, stack) > 0.5
        distance[p] = -math.sqrt(d2) if inside else math.sqrt(d2)
        nearest[p] = guess
    return distance, nearest


@njit(cache=True)
def lattice_distances(origin, spacing, shape, band, corners, boxes, dipoles):
    """Signed distances at the nodes ``origin + spacing * (i, j, k)``.

    A lattice `STRIDE` times coarser is computed first. Near the surface each node is then searched for
    exactly, starting from its neighbour's nearest triangle, and takes over its neighbour's side of the
    surface whenever the surface is too far away to pass between the two. Elsewhere the nearest triangles
    of the eight coarse nodes around stand for all: an upper bound, wrong by millimetres.

    Args:
        origin: (3,) float64, cm.
        spacing: Distance between nodes, cm.
        shape: (3,) int64 node counts.
        band: Nodes up to this distance from the surface are exact, cm.
        corners: Sorted triangles, see the module's text.
        boxes: Bounds of the tree's nodes.
        dipoles: Dipoles of the tree's nodes.

    Returns:
        (nx, ny, nz) float32, cm, negative inside.
    """
    coarse_shape = (shape - 1) // STRIDE + 2
    coarse_points = np.zeros((coarse_shape.prod(), 3), np.float64)
    nx, ny, nz = coarse_shape[0], coarse_shape[1], coarse_shape[2]
    for i in range(nx):
        for j in range(ny):
            for k in range(nz):
                n = (i * ny + j) * nz + k
                coarse_points[n, 0] = origin[0] + spacing * STRIDE * i
                coarse_points[n, 1] = origin[1] + spacing * STRIDE * j
                coarse_points[n, 2] = origin[2] + spacing * STRIDE * k
    coarse, nearest = signed_distances(coarse_points, corners, boxes, dipoles)

    stack = np.zeros(STACK_SIZE, np.int64)
    far = np.zeros(STACK_SIZE, np.float64)
    values = np.zeros((shape[0], shape[1], shape[2]), np.float32)
    clear = spacing * 1.001
    for i in range(shape[0]):
        x = origin[0] + spacing * i
        for j in range(shape[1]):
            y = origin[1] + spacing * j
            guess = -1
            for k in range(shape[2]):
                z = origin[2] + spacing * k
                cell = ((i // STRIDE) * ny + j // STRIDE) * nz + k // STRIDE
                bound = -1.0
                side = 1.0
                for corner in range(8):
                    n = cell + (corner >> 2) * ny * nz + ((corner >> 1) & 1) * nz + (corner & 1)
                    dx, dy, dz = x - coarse_points[n, 0], y - coarse_points[n, 1], z - coarse_points[n, 2]
                    gap = abs(coarse[n]) - math.sqrt(dx * dx + dy * dy + dz * dz)
                    if gap > bound:
                        bound = gap
                        side = -1.0 if coarse[n] < 0.0 else 1.0
                if bound > band:
                    d2 = math.inf
                    last = -1
                    for corner in range(8):
                        n = cell + (corner >> 2) * ny * nz + ((corner >> 1) & 1) * nz + (corner & 1)
                        if nearest[n] != last:
                            last = nearest[n]
                            d2 = min(d2, squared_distance_to_triangle(x, y, z, corners, last))
                    values[i, j, k] = side * math.sqrt(d2)
                    guess = last
                    continue
                if guess < 0:
                    guess = nearest[cell]
                d2, guess = closest_triangle(x, y, z, corners, boxes, guess, stack, far)
                d = math.sqrt(d2)
                if bound > 0.0:
                    inside = side < 0.0
                elif k > 0 and (d > clear or abs(values[i, j, k - 1]) > clear):
                    inside = values[i, j, k - 1] < 0.0
                elif j > 0 and (d > clear or abs(values[i, j - 1, k]) > clear):
                    inside = values[i, j - 1, k] < 0.0
                elif i > 0 and (d > clear or abs(values[i - 1, j, k]) > clear):
                    inside = values[i - 1, j, k] < 0.0
                else:
                    inside = winding_number(x, y, z, corners, dipoles, stack) > 0.5
                values[i, j, k] = -d if inside else d
    return values


@njit(cache=True)
def fill_tree(corners, boxes, dipoles):
    """Fills bounds, area vectors, centres and radii of all nodes of the tree, leaves first."""
    count = corners.shape[0]
    leaves = boxes.shape[0] // 2
    weight = np.zeros(2 * leaves, np.float64)
    for node in range(2 * leaves - 1, 0, -1):
        for c in range(3):
            boxes[node, c] = math.inf
            boxes[node, 3 + c] = -math.inf
        if node < leaves:
            for child in (2 * node, 2 * node + 1):
                for c in range(3):
                    boxes[node, c] = min(boxes[node, c], boxes[child, c])
                    boxes[node, 3 + c] = max(boxes[node, 3 + c], boxes[child, 3 + c])
                    dipoles[node, c] += dipoles[child, c]
                    dipoles[node, 3 + c] += weight[child] * dipoles[child, 3 + c]
                weight[node] += weight[child]
        else:
            leaf = node - leaves
            for t in range(leaf * count // leaves, (leaf + 1) * count // leaves):
                ux = corners[t, 3] - corners[t, 0]
                uy = corners[t, 4] - corners[t, 1]
                uz = corners[t, 5] - corners[t, 2]
                vx = corners[t, 6] - corners[t, 0]
                vy = corners[t, 7] - corners[t, 1]
                vz = corners[t, 8] - corners[t, 2]
                nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
                area = 0.5 * math.sqrt(nx * nx + ny * ny + nz * nz)
                dipoles[node, 0] += 0.5 * nx
                dipoles[node, 1] += 0.5 * ny
                dipoles[node, 2] += 0.5 * nz
                weight[node] += area
                for c in range(3):
                    low = min(corners[t, c], corners[t, 3 + c], corners[t, 6 + c])
                    high = max(corners[t, c], corners[t, 3 + c], corners[t, 6 + c])
                    boxes[node, c] = min(boxes[node, c], low)
                    boxes[node, 3 + c] = max(boxes[node, 3 + c], high)
                    middle = (corners[t, c] + corners[t, 3 + c] + corners[t, 6 + c]) / 3.0
                    dipoles[node, 3 + c] += area * middle
        radius2 = 0.0
        for c in range(3):
            if weight[node] > 0.0:
                dipoles[node, 3 + c] /= weight[node]
            elif boxes[node, c] <= boxes[node, 3 + c]:
                dipoles[node, 3 + c] = 0.5 * (boxes[node, c] + boxes[node, 3 + c])
            reach = max(dipoles[node, 3 + c] - boxes[node, c], boxes[node, 3 + c] - dipoles[node, 3 + c])
            if reach > 0.0:
                radius2 += reach * reach
        dipoles[node, 6] = math.sqrt(radius2)
