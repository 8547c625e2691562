"""Seams and hems: edges of a surface drawn as thin lines where the surface shows them."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.render.surface import LineSet

_dim_along = CompiledLoop("swifttailor.render.shading_kernels", "dim_along")
_LIFT = 0.5
"""A line is seen when it lies less than this behind what the pixel shows, cm."""


def draw_lines(light: Array, pixels: Array, line: LineSet, depth: Array, samples: int) -> None:
    """Takes light away along a set of edges, in place.

    Args:
        light: (height, width) float32 share of light kept at each sample.
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
    _dim_along(light, start, end, depth, line.strength, line.width * samples / 2, _LIFT)
