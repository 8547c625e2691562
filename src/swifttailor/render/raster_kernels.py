"""Compiled loops that find what is seen: triangles at samples, and their depth.

All arrays are C-contiguous. Rounding is kept as written in `fill`, so that triangles sharing an edge never
both claim a pixel nor leave one unclaimed.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.render.compile_options import EXACT, FAST, HELPER

NOTHING = np.iinfo(np.int64).max
"""The key of a sample that shows no triangle."""


@njit(**EXACT)
def add_normals(vertices, faces, normals):
    """Fills `normals` (n, 3) float32 with unit normals, area-weighted; zero where no face has any area."""
    for t in range(len(faces)):
        a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
        x1, x2 = vertices[b, 0] - vertices[a, 0], vertices[c, 0] - vertices[a, 0]
        y1, y2 = vertices[b, 1] - vertices[a, 1], vertices[c, 1] - vertices[a, 1]
        z1, z2 = vertices[b, 2] - vertices[a, 2], vertices[c, 2] - vertices[a, 2]
        nx, ny, nz = y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2
        for k in range(3):
            v = faces[t, k]
            normals[v, 0] += nx
            normals[v, 1] += ny
            normals[v, 2] += nz
    for v in range(len(normals)):
        x, y, z = normals[v, 0], normals[v, 1], normals[v, 2]
        norm = math.sqrt(x * x + y * y + z * z)
        inverse = 1.0 / norm if norm > 1e-12 else 0.0
        for k in range(3):
            normals[v, k] *= inverse


@njit(**EXACT)
def fill(nearest, front, points, depth, faces, surface, hidden_turn, low_z, steps, height, width):
    """Lowers the keys `nearest` (height x width,) int64 at pixel centres: `rasterize.rasterize`.

    A key is a depth, in whole steps of which `steps` make a unit above `low_z`, times 2^32, and a triangle.

    Args:
        nearest: Keys; `NOTHING` before.
        front: (m,) bool, set where a face turns anticlockwise in a picture whose rows run down.
        points: (n, 2 or more) x and y in pixels.
        depth: (n,) affine over the picture, NaN for what cannot be drawn.
        faces: (m, 3) int32.
        surface: (m,) int16 of each face.
        hidden_turn: Of each surface the sign of the turn whose triangles are left out, or 0.
        low_z: Depth where steps begin.
        steps: In a unit of depth.
        height: Of the picture.
        width: Of the picture.
    """
    for t in range(len(faces)):
        a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
        xa, ya, xb, yb, xc, yc = (
            points[a, 0],
            points[a, 1],
            points[b, 0],
            points[b, 1],
            points[c, 0],
            points[c, 1],
        )
        x1, y1, x2, y2 = xb - xa, yb - ya, xc - xa, yc - ya
        area = x1 * y2 - x2 * y1
        if area * hidden_turn[surface[t]] > 0.0:
            continue
        # Row r has its pixel centres at r + 0.5 and is covered when y_min <= r + 0.5 < y_max.
        y_min, y_max = min(ya, yb, yc), max(ya, yb, yc)
        top = int(min(max(math.ceil(y_min - 0.5), 0.0), height))
        bottom = int(min(max(math.ceil(y_max - 0.5), 0.0), height))
        if top >= bottom:
            continue
        least, most = min(xa, xb, xc), max(xa, xb, xc)
        if math.ceil(least - 0.5) >= math.ceil(most - 0.5) or most <= 0.0 or least >= width:
            continue
        front[t] = area < 0.0
        z0, z1, z2 = (depth[a] - low_z) * steps, (depth[b] - low_z) * steps, (depth[c] - low_z) * steps
        if not (z0 + z1 + z2 < np.inf):
            continue
        inverse = 1.0 / area if abs(area) > 1e-12 else 0.0
        slope = ((z1 - z0) * y2 - (z2 - z0) * y1) * inverse
        down = ((z2 - z0) * x1 - (z1 - z0) * x2) * inverse
        start = z0 - slope * xa - down * ya
        low, high = min(z0, z1, z2), max(z0, z1, z2)
        # Upper corner first.
        if ya > yb:
            xa, ya, xb, yb = xb, yb, xa, ya
        if yb > yc:
            xb, yb, xc, yc = xc, yc, xb, yb
        if ya > yb:
            xa, ya, xb, yb = xb, yb, xa, ya
        # Each edge runs from its upper to its lower end in every triangle that has it: equal bits.
        long_slope = (xc - xa) / (yc - ya)
        upper_slope = (xb - xa) / (yb - ya) if yb > ya else 0.0
        lower_slope = (xc - xb) / (yc - yb) if yc > yb else 0.0
        for row in range(top, bottom):
            center = row + 0.5
            one = xa + (center - ya) * long_slope
            other = xa + (center - ya) * upper_slope if center < yb else xb + (center - yb) * lower_slope
            first = int(min(max(math.ceil(min(one, other) - 0.5), 0.0), width))
            last = int(min(max(math.ceil(max(one, other) - 0.5), 0.0), width))
            along = slope * (first + 0.5) + down * center + start
            for column in range(first, last):
                # The plane of a sliver can leave the range of its corners within the row.
                held = min(max(along + (column - first) * slope, low), high)
                key = (np.int64(held) << 32) | t
                at = row * width + column
                if key < nearest[at]:
                    nearest[at] = key


@njit(**HELPER)
def weigh(t, x, y, points, faces, perspective):
    """Weights of the three corners of triangle t at the picture's x, y."""
    a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
    x0, y0 = points[a, 0], points[a, 1]
    x1, y1, x2, y2 = points[b, 0] - x0, points[b, 1] - y0, points[c, 0] - x0, points[c, 1] - y0
    area = x1 * y2 - x2 * y1
    inverse = 1.0 / area if abs(area) > 1e-12 else 0.0
    x, y = x - x0, y - y0
    w1 = min(max((x * y2 - y * x2) * inverse, 0.0), 1.0)
    w2 = min(max((y * x1 - x * y1) * inverse, 0.0), 1.0)
    w0 = max(1.0 - w1 - w2, 0.0)
    if perspective:
        d0, d1, d2 = points[a, 2], points[b, 2], points[c, 2]
        w0, w1, w2 = w0 * (d1 * d2), w1 * (d0 * d2), w2 * (d0 * d1)
    total = 1.0 / (w0 + w1 + w2)
    return w0 * total, w1 * total, w2 * total


@njit(**FAST)
def find_middles(keys, front, samples, points, faces, normals, perspective, distance, normal):
    """Fills what lies at the middle sample of each pixel, wherever it shows a triangle.

    Args:
        keys: (H, W) int64 as `fill` makes them.
        front: (m,) as it makes them.
        samples: Along each side of a pixel.
        points: (n, 3) see `scene.Projection`.
        faces: (m, 3) int32.
        normals: (n, 3) float32 unit normals in the world.
        perspective: Whether near things look larger.
        distance: (h, w) float32 from the camera, cm; left alone where nothing is seen.
        normal: (h, w, 3) float32 unit normals in the world, turned towards the camera.
    """
    height, width = distance.shape
    for j in range(height):
        for i in range(width):
            row, column = j * samples + samples // 2, i * samples + samples // 2
            if keys[row, column] == NOTHING:
                continue
            t = np.int32(keys[row, column])
            w0, w1, w2 = weigh(t, column + 0.5, row + 0.5, points, faces, perspective)
            a, b, c = faces[t, 0], faces[t, 1], faces[t, 2]
            distance[j, i] = w0 * points[a, 2] + w1 * points[b, 2] + w2 * points[c, 2]
            nx = w0 * normals[a, 0] + w1 * normals[b, 0] + w2 * normals[c, 0]
            ny = w0 * normals[a, 1] + w1 * normals[b, 1] + w2 * normals[c, 1]
            nz = w0 * normals[a, 2] + w1 * normals[b, 2] + w2 * normals[c, 2]
            size = 1.0 / max(math.sqrt(nx * nx + ny * ny + nz * nz), 1e-6)
            if not front[t]:
                size = -size
            normal[j, i, 0], normal[j, i, 1], normal[j, i, 2] = nx * size, ny * size, nz * size
