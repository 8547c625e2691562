"""Seams and hems: edges of a surface drawn as thin lines where the surface shows them."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.surface import LineSet

_STEP = 0.6
"""Distance between the points that make a line, pixels."""
_LIFT = 0.5
"""A line is seen when it lies less than this behind what the pixel shows, cm."""


def draw_lines(light: Array, pixels: Array, line: LineSet, depth: Array, samples: int) -> None:
    """Takes light away along a set of edges, in place.

    Args:
        light: (height, width) share of light kept at each sample.
        pixels: (n, 3) projected vertices: x, y in samples and distance from the camera, cm.
        line: The edges.
        depth: (height, width) distance of what each sample shows, cm.
        samples: Samples along a side of a finished pixel.
    """
    height, width = depth.shape
    edges = np.asarray(line.edges).reshape(-1, 2)
    start, end = pixels[edges[:, 0]], pixels[edges[:, 1]]
    low, high = np.minimum(start, end), np.maximum(start, end)
    inside = (high[:, 0] >= 0) & (low[:, 0] < width) & (high[:, 1] >= 0) & (low[:, 1] < height)
    inside &= low[:, 2] > 0
    start, end = start[inside], end[inside]
    length = np.hypot(*(end - start)[:, :2].T)
    count = np.minimum(np.ceil(length / _STEP).astype(np.int64), 4 * (width + height)) + 1
    which = np.repeat(np.arange(len(count)), count)
    along = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    t = (along + 0.5) / np.repeat(count, count)
    points = start[which] + t[:, None] * (end - start)[which]
    radius = line.width * samples / 2
    reach = np.arange(-int(np.ceil(radius)), int(np.ceil(radius)) + 1)
    for dy in reach:
        for dx in reach:
            if dx * dx + dy * dy > radius * radius:
                continue
            x, y = (points[:, :2] + (dx, dy)).astype(np.int64).T
            on = (x >= 0) & (x < width) & (y >= 0) & (y < height)
            x, y, z = x[on], y[on], points[on, 2]
            shown = z - _LIFT <= depth[y, x]
            light[y[shown], x[shown]] = np.minimum(light[y[shown], x[shown]], 1.0 - line.strength)
