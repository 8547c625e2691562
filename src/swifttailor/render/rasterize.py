"""Which triangle is seen at which pixel: span filling and a depth buffer, compiled (`raster_kernels`).

A pixel belongs to a triangle when its centre lies inside. Borders are half open, so that two triangles
sharing an edge never both claim a pixel nor leave one unclaimed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop

_fill = CompiledLoop("swifttailor.render.raster_kernels", "fill")
_NOTHING = np.iinfo(np.int64).max
_DEPTH_STEPS = float(2**31 - 1)


@dataclass(frozen=True, eq=False)
class Triangles:
    """Triangles in a picture, as the loops take them."""

    points: Array
    """(n, 2 or more) float64 x right and y down in pixels."""
    depth: Array
    """(n,) float64, affine over the picture and larger farther away; NaN for what cannot be drawn."""
    faces: Array
    """(m, 3) int32."""
    surface: Array
    """(m,) int16 which surface a face belongs to."""
    hidden_turn: Array
    """Of each surface: the sign of the turn, 1 for clockwise as seen, whose triangles are left out, or 0."""


@dataclass(frozen=True, eq=False)
class DepthKeys:
    """What the loop finds: the nearest triangle of each pixel and its depth."""

    keys: Array
    """(height, width) int64: whole steps of depth times 2^32, and the triangle; the largest for none."""
    front: Array
    """(m,) bool of the triangles that cover pixels: whether they turn anticlockwise as seen."""
    low: float
    """Depth where steps begin."""
    steps: float
    """In a unit of depth."""

    @property
    def face(self) -> Array:
        """(height, width) int32 triangle, or -1."""
        return self.keys.astype(np.int32)

    def depth(self, fill: float) -> Array:
        """(height, width) depth of the nearest triangles; `fill` where there is none."""
        return np.where(self.keys == _NOTHING, fill, (self.keys >> 32) / self.steps + self.low)


def nearest_triangles(
    triangles: Triangles, size: tuple[int, int], depths: tuple[float, float] | None = None
) -> DepthKeys:
    """Finds the nearest triangle at every pixel centre.

    Args:
        triangles: What may be seen.
        size: Width and height in pixels.
        depths: The least and the most depth; found here when None.
    """
    width, height = size
    keys, front = np.full((height, width), _NOTHING), np.zeros(len(triangles.faces), np.bool_)
    if not len(triangles.faces):
        return DepthKeys(keys, front, 0.0, 1.0)
    if depths is None:
        depths = float(triangles.depth.min()), float(triangles.depth.max())
    low, high = depths
    if not low <= high:
        return DepthKeys(keys, front, 0.0, 1.0)
    steps = _DEPTH_STEPS / max(high - low, 1e-12)
    _fill(
        keys.reshape(-1),
        front,
        triangles.points,
        triangles.depth,
        triangles.faces,
        triangles.surface,
        triangles.hidden_turn,
        low,
        steps,
        height,
        width,
    )
    return DepthKeys(keys, front, low, steps)


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
    return nearest_triangles(_loose(corners), size).face


def depth_picture(corners: Array, size: tuple[int, int], *, fill: float) -> Array:
    """Depth (height, width) of the nearest triangles; `fill` where none is. See `rasterize`."""
    return nearest_triangles(_loose(corners), size).depth(fill)


def _loose(corners: Array) -> Triangles:
    """Triangles that share no corners."""
    points = np.ascontiguousarray(corners, np.float64).reshape(-1, 3)
    faces = np.arange(len(points), dtype=np.int32).reshape(-1, 3)
    return Triangles(
        points, points[:, 2].copy(), faces, np.zeros(len(faces), np.int16), np.zeros(1, np.float64)
    )
