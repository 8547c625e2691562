"""Compiled loops that find what is seen: triangles at pixels, their depth, and what varies across them.

All arrays are C-contiguous. Rounding is kept as written in `fill`, so that triangles sharing an edge never
both claim a pixel nor leave one unclaimed.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from swifttailor.render.compile_options import FAST


@njit(cache=True, error_model="numpy")
def fill(nearest, corners, low_z, steps, height, width, work):
    """Lowers the keys `nearest` (height x width,) int64 at pixel centres: `rasterize.rasterize`.

    A key is a depth, in whole steps of which `steps` make a unit above `low_z`, times 2^32, and a
    triangle. `work` (3, 3) is overwritten.
    """
    x, y, z = work[0], work[1], work[2]
    for t in range(len(corners)):
        for k in range(3):
            x[k], y[k], z[k] = corners[t, k, 0], corners[t, k, 1], (corners[t, k, 2] - low_z) * steps
        least, most = min(x[0], x[1], x[2]), max(x[0], x[1], x[2])
        # Row r has its pixel centres at r + 0.5 and is covered when y_min <= r + 0.5 < y_max.
        top = int(min(max(math.ceil(min(y[0], y[1], y[2]) - 0.5), 0.0), height))
        bottom = int(min(max(math.ceil(max(y[0], y[1], y[2]) - 0.5), 0.0), height))
        if top >= bottom or most <= 0.0 or least >= width:
            continue
        x1, y1, x2, y2 = x[1] - x[0], y[1] - y[0], x[2] - x[0], y[2] - y[0]
        area = x1 * y2 - x2 * y1
        inverse = 1.0 / area if abs(area) > 1e-12 else 0.0
        slope = ((z[1] - z[0]) * y2 - (z[2] - z[0]) * y1) * inverse
        down = ((z[2] - z[0]) * x1 - (z[1] - z[0]) * x2) * inverse
        start = z[0] - slope * x[0] - down * y[0]
        low, high = min(z[0], z[1], z[2]), max(z[0], z[1], z[2])
        for a, b in ((0, 1), (1, 2), (0, 1)):  # upper corner first
            if y[a] > y[b]:
                x[a], x[b] = x[b], x[a]
                y[a], y[b] = y[b], y[a]
        # Each edge runs from its upper to its lower end in every triangle that has it: equal bits.
        long_slope = (x[2] - x[0]) / (y[2] - y[0])
        upper_slope = (x[1] - x[0]) / (y[1] - y[0]) if y[1] > y[0] else 0.0
        lower_slope = (x[2] - x[1]) / (y[2] - y[1]) if y[2] > y[1] else 0.0
        for row in range(top, bottom):
            center = row + 0.5
            one = x[0] + (center - y[0]) * long_slope
            if center < y[1]:
                other = x[0] + (center - y[0]) * upper_slope
            else:
                other = x[1] + (center - y[1]) * lower_slope
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


@njit(**FAST)
def interpolate(face, corners, distances, normals, front, perspective, distance, normal, weight):
    """Fills what varies across the triangles (height, width) int32 `face`, wherever a sample shows one.

    Args:
        face: As `rasterize` gives it.
        corners: As it takes them.
        distances: (k, 3) of the corners from the camera, cm.
        normals: (k, 3, 3) float32 unit normals at the corners, in the camera's frame.
        front: (k,) whether the right side is seen.
        perspective: Whether near things look larger.
        distance: (height, width) float32 from the camera, cm; left alone where nothing is seen.
        normal: (height, width, 3) float32 unit normals turned towards the camera.
        weight: (height, width, 2) float32 weights of corners 1 and 2; or (0, 0, 2) where nobody asks.
    """
    height, width = face.shape
    for row in range(height):
        for column in range(width):
            t = face[row, column]
            if t < 0:
                continue
            x0, y0 = corners[t, 0, 0], corners[t, 0, 1]
            x1, y1 = corners[t, 1, 0] - x0, corners[t, 1, 1] - y0
            x2, y2 = corners[t, 2, 0] - x0, corners[t, 2, 1] - y0
            area = x1 * y2 - x2 * y1
            inverse = 1.0 / area if abs(area) > 1e-12 else 0.0
            x, y = column + 0.5 - x0, row + 0.5 - y0
            w1 = min(max((x * y2 - y * x2) * inverse, 0.0), 1.0)
            w2 = min(max((y * x1 - x * y1) * inverse, 0.0), 1.0)
            w0 = max(1.0 - w1 - w2, 0.0)
            d0, d1, d2 = distances[t, 0], distances[t, 1], distances[t, 2]
            if perspective:
                w0, w1, w2 = w0 / d0, w1 / d1, w2 / d2
            total = 1.0 / (w0 + w1 + w2)
            w0, w1, w2 = w0 * total, w1 * total, w2 * total
            distance[row, column] = w0 * d0 + w1 * d1 + w2 * d2
            if len(weight):
                weight[row, column, 0], weight[row, column, 1] = w1, w2
            nx = w0 * normals[t, 0, 0] + w1 * normals[t, 1, 0] + w2 * normals[t, 2, 0]
            ny = w0 * normals[t, 0, 1] + w1 * normals[t, 1, 1] + w2 * normals[t, 2, 1]
            nz = w0 * normals[t, 0, 2] + w1 * normals[t, 1, 2] + w2 * normals[t, 2, 2]
            size = 1.0 / max(math.sqrt(nx * nx + ny * ny + nz * nz), 1e-6)
            if not front[t]:
                size = -size
            normal[row, column, 0] = nx * size
            normal[row, column, 1] = ny * size
            normal[row, column, 2] = nz * size
