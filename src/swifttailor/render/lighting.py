"""Light on a surface: a key, a fill and a rim light that stand with the camera, and the sky of the room."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array


@dataclass(frozen=True)
class Light:
    """A distant light."""

    direction: tuple[float, float, float]
    """Towards the light, in the camera's frame: right, up, towards the camera."""
    color: tuple[float, float, float]
    """Linear RGB."""
    wrap: float = 0.0
    """How far it reaches around the shape: 0 a point, 1 a sky."""

    def unit(self) -> Array:
        """The direction (3,) with length 1."""
        direction = np.asarray(self.direction)
        return direction / np.linalg.norm(direction)


KEY = Light((-0.80, 0.80, 0.62), (1.02, 0.98, 0.92), wrap=0.10)
"""From the upper left, before the figure; it casts the shadows."""
FILL = Light((0.85, 0.15, 0.50), (0.13, 0.15, 0.19), wrap=0.30)
"""Low, from the right, a little cooler."""
RIM = Light((0.70, 0.55, -0.75), (0.26, 0.28, 0.30))
"""From behind, drawing the outline on the shadow side."""
SKY = (0.36, 0.37, 0.40)
"""Light from above."""
GROUND = (0.17, 0.165, 0.16)
"""Light thrown back by the floor."""


@dataclass(frozen=True)
class Lighting:
    """All light in a picture."""

    key: Light = KEY
    """The strongest; it casts the shadows."""
    fill: Light = FILL
    rim: Light = RIM
    sky: tuple[float, float, float] = SKY
    """Linear RGB from above."""
    ground: tuple[float, float, float] = GROUND
    """Linear RGB from below."""

    def table(self, axes: Array | None = None) -> Array:
        """(9, 4) float32 as `shading_kernels.light_samples` takes it.

        Rows: direction and wrap of key, fill and rim; their colours; sky, ground; direction of the highlight.

        Args:
            axes: See `Camera.axes`; given, directions are those of the world, else of the camera's frame.
        """
        lights = self.key, self.fill, self.rim
        half = self.key.unit() + np.array([0.0, 0.0, 1.0])
        half = half / max(float(np.linalg.norm(half)), 1e-6)
        rows = np.zeros((9, 4), np.float32)
        for k, light in enumerate(lights):
            rows[k, :3], rows[k, 3], rows[3 + k, :3] = light.unit(), light.wrap, light.color
        rows[6, :3], rows[7, :3], rows[8, :3] = self.sky, self.ground, half
        if axes is not None:
            for k in (0, 1, 2, 8):
                rows[k, :3] = rows[k, :3] @ axes
        return rows


STUDIO = Lighting()
