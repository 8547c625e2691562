"""What stands behind the figure: a lit wall that runs into the floor, and the figure's shadow on it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.blur import gaussian_blur
from swifttailor.render.camera import Camera
from swifttailor.render.rasterize import Triangles, nearest_triangles


def wall(size: tuple[int, int], color: Array) -> Array:
    """Linear light (height, width, 3) of a backdrop of linear `color` (3,), lightest around the middle."""
    width, height = size
    u = (np.arange(width) + 0.5) / width - 0.5
    v = (np.arange(height) + 0.5) / height - 0.42
    glow = 1.0 - 0.50 * v[:, None] ** 2 - 0.20 * u[None] ** 2
    lit = np.zeros((height, width, 3), np.float32)
    for k in range(3):  # a broadcast along so short an axis is several times slower
        np.multiply(glow, color[k], out=lit[:, :, k], casting="same_kind")
    return lit


class FloorShadow:
    """Darkness on the floor y = 0 under a scene: sharp where something touches it, wide where it hangs."""

    _MARGIN = 40.0
    _CELL, _LARGEST_CELL = 1.5, 4.0
    _PIXELS = 2.0

    @classmethod
    def cell_for(cls, pixel: float) -> float:
        """Size of a cell, cm, for a picture whose pixels show so many cm."""
        return min(max(cls._CELL, cls._PIXELS * pixel), cls._LARGEST_CELL)

    def __init__(self, rows: Array, seen_from_afar: Callable[..., Triangles], cell: float) -> None:
        """Looks at a scene from below.

        Args:
            rows: (3, n) vertices in the world, cm.
            seen_from_afar: See `Scene.seen_from_afar`.
            cell: Size of a cell, cm; grown for wide scenes.
        """
        plan = rows[[0, 2]]
        self._low = plan.min(axis=1) - self._MARGIN
        self._high = plan.max(axis=1) + self._MARGIN
        extent = self._high - self._low
        self._cell = max(cell, float(extent.max()) / 300)
        width, height = (int(n) for n in np.ceil(extent / self._cell))
        points = np.zeros((rows.shape[1], 2))
        for k in range(2):
            np.subtract(plan[k], self._low[k], out=points[:, k])
        points /= self._cell
        nearest = nearest_triangles(seen_from_afar(points, rows[1].copy(), cull=-1.0), (width, height))
        above = np.maximum(nearest.depth(1e6), 0.0).astype(np.float32)
        touching = gaussian_blur(np.exp(-above / 2.5), 2.0 / self._cell, reflects=False)
        hanging = gaussian_blur(np.exp(-above / 45.0), 12.0 / self._cell, truncate=3.0, reflects=False)
        self._map = np.clip(0.55 * touching + 0.50 * hanging, 0.0, 0.8)

    def light(self, camera: Camera, size: tuple[int, int]) -> Array:
        """Share of the light (height, width, 1) float32 that is left in a picture of the floor."""
        width, height = size
        kept = np.ones((height, width, 1), np.float32)
        if camera.elevation <= 0.0:
            return kept  # the floor is seen edge on, or from below
        (x0, z0), (x1, z1) = self._low, self._high
        edge = np.array([[x0, 0.0, z0], [x0, 0.0, z1], [x1, 0.0, z0], [x1, 0.0, z1]])
        seen = camera.project(edge, size)
        if seen[:, 2].min() <= 1.0:
            return kept
        left, top = np.clip(np.floor(seen[:, :2].min(axis=0)), 0, size).astype(int)
        right, bottom = np.clip(np.ceil(seen[:, :2].max(axis=0)), 0, size).astype(int)
        if left >= right or top >= bottom:
            return kept
        points = camera.floor_points(np.arange(left, right) + 0.5, np.arange(top, bottom) + 0.5, size)
        points = points.reshape(-1, 2)
        dark = _bilinear(self._map, (points - self._low) / self._cell - 0.5)
        kept[top:bottom, left:right] -= dark.reshape(bottom - top, right - left, 1)
        return kept


def _bilinear(grid: Array, at: Array) -> Array:
    """Values (n,) of a grid (rows, columns) at positions (n, 2) column, row; 0 outside."""
    rows, columns = grid.shape
    inside = (at[:, 0] >= 0) & (at[:, 0] < columns - 1) & (at[:, 1] >= 0) & (at[:, 1] < rows - 1)
    x, y = at[inside].T
    i, j = x.astype(np.int64), y.astype(np.int64)
    u, v = x - i, y - j
    flat, corner = grid.ravel(), j * columns + i
    upper = (1 - u) * flat[corner] + u * flat[corner + 1]
    lower = (1 - u) * flat[corner + columns] + u * flat[corner + columns + 1]
    value = np.zeros(len(at), np.float32)
    value[inside] = (1 - v) * upper + v * lower
    return value
