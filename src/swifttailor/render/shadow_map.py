"""Shadows cast by the key light."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.rasterize import depth_at, rasterize

_CELL = 0.6
"""Size of a cell, cm; grown for wide scenes."""
_MAX_CELLS = 450
_BIAS = 0.5
"""Distance behind the occluder at which shadow begins, cm."""
_FADE = 1.2
"""Distance over which it then becomes full, cm."""
_OFFSET = 0.7
"""Receivers are taken this far out along their normal, so that they do not shade themselves, cm."""


class ShadowMap:
    """The distance of what a distant light sees of a scene."""

    def __init__(self, triangles: Array, towards_light: Array) -> None:
        """Looks at world triangles (m, 3, 3), cm, from the unit direction `towards_light` (3,)."""
        self._axes = _axes_towards(towards_light).astype(np.float32)
        corners = triangles.reshape(-1, 3) @ self._axes.T
        low, high = corners[:, :2].min(axis=0), corners[:, :2].max(axis=0)
        self._cell = max(_CELL, float((high - low).max()) / _MAX_CELLS)
        self._low = low - 3 * self._cell
        width, height = (int(n) for n in np.ceil((high - low) / self._cell) + 6)
        corners[:, :2] = (corners[:, :2] - self._low) / self._cell
        corners[:, 2] *= -1.0
        corners = corners.reshape(-1, 3, 3)
        self._depth = depth_at(corners, rasterize(corners, (width, height)), fill=1e9).astype(np.float32)

    def light(self, points: Array, normals: Array) -> Array:
        """Share (n,) of the key light, 0 to 1, that arrives at world points with normals, both (n, 3), cm."""
        seen = (points + np.float32(_OFFSET) * normals).astype(np.float32) @ self._axes.T
        rows, columns = self._depth.shape
        x = np.clip((seen[:, 0] - self._low[0]) / self._cell - 0.5, 1.0, columns - 2.001)
        y = np.clip((seen[:, 1] - self._low[1]) / self._cell - 0.5, 1.0, rows - 2.001)
        i, j = x.astype(np.int32), y.astype(np.int32)
        # Sixteen comparisons around the point, weighted so that the sum changes smoothly between cells.
        across, down = _tent(x - i), _tent(y - j)
        limit = (-seen[:, 2] - np.float32(_BIAS)) / np.float32(_FADE)
        depth = (self._depth / np.float32(_FADE)).ravel()
        corner = (j - 1) * columns + (i - 1)
        arriving = np.zeros(len(points), np.float32)
        for row in range(4):
            line = np.zeros(len(points), np.float32)
            for column in range(4):
                ahead = depth[corner + (row * columns + column)] - limit
                line += across[column] * np.clip(1.0 + ahead, 0.0, 1.0)
            arriving += down[row] * line
        return arriving


def _tent(fraction: Array) -> list[Array]:
    """Weights of four neighbouring cells for a box of width 3 at `fraction` between the middle two."""
    third = np.float32(1 / 3)
    return [
        (1 - fraction) * third,
        np.full_like(fraction, third),
        np.full_like(fraction, third),
        fraction * third,
    ]


def _axes_towards(direction: Array) -> Array:
    """(3, 3) orthonormal rows whose last one is the unit `direction`."""
    helper = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(helper, direction)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first), direction])
