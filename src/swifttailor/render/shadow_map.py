"""Shadows cast by the key light."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.render.camera import Camera
from swifttailor.render.rasterize import depth_picture

_arriving_key_light = CompiledLoop("swifttailor.render.shading_kernels", "arriving_key_light")
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
        self._axes = _axes_towards(towards_light)
        # Coordinates in rows: least and most of each are then found several times faster.
        seen = self._axes @ triangles.reshape(-1, 3).T
        low, high = seen[:2].min(axis=1), seen[:2].max(axis=1)
        self._cell = max(_CELL, float((high - low).max()) / _MAX_CELLS)
        self._low = low - 3 * self._cell
        width, height = (int(n) for n in np.ceil((high - low) / self._cell) + 6)
        seen[:2] = (seen[:2] - self._low[:, None]) / self._cell
        seen[2] *= -1.0
        self._depth = depth_picture(seen.T.reshape(-1, 3, 3), (width, height), fill=1e9).astype(np.float32)

    def light(self, camera: Camera, distance: Array, normal: Array, samples: int) -> Array:
        """Share (h, w) float32 of the key light, 0 to 1, that arrives at the middles of a picture's pixels.

        Args:
            camera: That took the picture.
            distance: (H, W) float32 of each sample from the camera, cm; infinite where nothing is.
            normal: (H, W, 3) float32 of each sample, in the camera's frame.
            samples: Samples along each side of a pixel.
        """
        to_map = self._axes @ camera.axes.T
        origin = self._axes @ (np.asarray(camera.target) + camera.distance * camera.axes[2])
        origin[:2] -= self._low
        origin[:2] /= self._cell
        to_map[:2] /= self._cell
        perspective = camera.distance if camera.perspective else 0.0
        geometry = camera.height / distance.shape[0], perspective, _OFFSET, _BIAS
        key = np.ones((distance.shape[0] // samples, distance.shape[1] // samples), np.float32)
        _arriving_key_light(key, distance, normal, samples, geometry, to_map, origin, self._depth, _FADE)
        return key


def _axes_towards(direction: Array) -> Array:
    """(3, 3) orthonormal rows whose last one is the unit `direction`."""
    helper = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(helper, direction)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first), direction])
