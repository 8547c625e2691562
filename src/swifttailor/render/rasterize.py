"""Which triangle is seen at which pixel: span filling and a depth buffer, compiled (`raster_kernels`).

A pixel belongs to a triangle when its centre lies inside. Borders are half open, so that two triangles
sharing an edge never both claim a pixel nor leave one unclaimed.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop

_fill = CompiledLoop("swifttailor.render.raster_kernels", "fill")
_NOTHING = np.iinfo(np.int64).max
_DEPTH_STEPS = float(2**31 - 1)


def rasterize(corners: Array, size: tuple[int, int]) -> Array:
    """Finds the nearest triangle at every pixel centre.

    Args:
        corners: (m, 3, 3) triangle corners: x right and y down in pixels, and a depth that is affine over the
            picture, larger farther away. Must be finite.
        size: Width and height in pixels.

    Returns:
        (height, width) int32 triangle indices, -1 where there is none. Of two triangles at the same depth
        the one listed first wins.
    """
    keys, _, _ = _nearest(corners, size)
    return keys.astype(np.int32)  # the lower half: the triangle, or -1


def depth_picture(corners: Array, size: tuple[int, int], *, fill: float) -> Array:
    """Depth (height, width) of the nearest triangles; `fill` where none is. See `rasterize`."""
    keys, low, steps = _nearest(corners, size)
    return np.where(keys == _NOTHING, fill, (keys >> 32) / steps + low)


def _nearest(corners: Array, size: tuple[int, int]) -> tuple[Array, float, float]:
    """Keys (height, width) as the loop makes them, the depth where steps begin, and steps in a unit."""
    width, height = size
    keys = np.full((height, width), _NOTHING)
    if not len(corners):
        return keys, 0.0, 1.0
    corners = np.ascontiguousarray(corners, np.float64)
    low, high = float(corners[:, :, 2].min()), float(corners[:, :, 2].max())
    steps = _DEPTH_STEPS / max(high - low, 1e-12)
    _fill(keys.reshape(-1), corners, low, steps, height, width, np.zeros((3, 3)))
    return keys, low, steps
