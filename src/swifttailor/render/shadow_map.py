"""Shadows cast by the key light."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.render.camera import Camera
from swifttailor.render.rasterize import nearest_triangles

if TYPE_CHECKING:
    from swifttailor.render.scene import Scene

_arriving_key_light = CompiledLoop("swifttailor.render.shading_kernels", "arriving_key_light")
_CELL = 0.6
"""Size of a cell, cm; grown for wide scenes and for small pictures."""
_PIXELS, _LARGEST_CELL = 1.0, 1.2
"""A cell is this many pixels of the picture wide, but at most so many cm."""
_MAX_CELLS = 450
_BIAS = 0.5
"""Distance behind the occluder at which shadow begins, cm."""
_FADE = 1.2
"""Distance over which it then becomes full, cm."""
_OFFSET = 0.7
"""Receivers are taken this far out along their normal, so that they do not shade themselves, cm."""


class ShadowMap:
    """The distance of what a distant light sees of a scene."""

    def __init__(self, scene: Scene, towards_light: Array, pixel: float = 0.0) -> None:
        """Looks at a scene from a direction.

        Args:
            scene: What throws shadows.
            towards_light: (3,) unit direction.
            pixel: Centimetres that a pixel of the picture shows; larger ones need no finer shadow.
        """
        self._axes = _axes_towards(towards_light)
        # Coordinates in rows: least and most of each are then found several times faster.
        seen = self._axes @ scene.rows
        low, high = seen.min(axis=1), seen.max(axis=1)
        cell = min(max(_CELL, _PIXELS * pixel), _LARGEST_CELL)
        self._cell = max(cell, float((high - low)[:2].max()) / _MAX_CELLS)
        self._low = low[:2] - 3 * self._cell
        width, height = (int(n) for n in np.ceil((high - low)[:2] / self._cell) + 6)
        points = np.zeros((seen.shape[1], 2))
        for k in range(2):
            np.subtract(seen[k], self._low[k], out=points[:, k])
        points /= self._cell
        triangles = scene.seen_from_afar(points, -seen[2], cull=-1.0)
        nearest = nearest_triangles(triangles, (width, height), (-float(high[2]), -float(low[2])))
        self._depth = nearest.depth(1e9).astype(np.float32)

    def light(self, camera: Camera, distance: Array, normal: Array, samples: int) -> Array:
        """Share (h, w) float32 of the key light, 0 to 1, that arrives at the middles of a picture's pixels.

        Args:
            camera: That took the picture.
            distance: (h, w) float32 of each pixel's middle sample from the camera, cm; infinite where
                nothing is.
            normal: (h, w, 3) float32 of each, in the world.
            samples: Along each side of a pixel.
        """
        to_map = self._axes @ camera.axes.T
        origin = self._axes @ (np.asarray(camera.target) + camera.distance * camera.axes[2])
        out = self._axes * _OFFSET
        origin[:2] -= self._low
        for rows in (origin, to_map, out):
            rows[:2] /= self._cell
        perspective = camera.distance if camera.perspective else 0.0
        middle = (samples // 2 + 0.5) / samples
        geometry = float(camera.height / distance.shape[0]), float(perspective), middle, _BIAS
        key = np.ones(distance.shape, np.float32)
        _arriving_key_light(key, distance, normal, geometry, to_map, out, origin, self._depth, _FADE)
        return key


def _axes_towards(direction: Array) -> Array:
    """(3, 3) orthonormal rows whose last one is the unit `direction`."""
    helper = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(helper, direction)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first), direction])
