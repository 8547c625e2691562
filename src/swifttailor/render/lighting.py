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


STUDIO = Lighting()


@dataclass(frozen=True)
class Samples:
    """The visible points to be lit, n of them; float32 throughout."""

    normal: Array
    """(n, 3) unit normals turned towards the camera, in the camera's frame."""
    up: Array
    """(n,) the normal's upward part in the world."""
    facing: Array
    """(n,) cosine between the normal and the sight line, 0 to 1."""
    color: Array
    """(n, 3) linear colour of the surface."""
    sheen: Array
    """(n,) see `Surface.sheen`."""
    gloss: Array
    """(n,) see `Surface.gloss`."""
    shadow: Array
    """(n,) share of the key light that arrives."""
    open_sky: Array
    """(n,) share of the room's light that arrives."""


def shade(samples: Samples, lighting: Lighting = STUDIO) -> Array:
    """Linear-light colour (n, 3) of the samples."""
    key = _diffuse(samples.normal, lighting.key) * samples.shadow
    fill = _diffuse(samples.normal, lighting.fill) * samples.open_sky
    edge = (1.0 - samples.facing) ** 2
    rim = _diffuse(samples.normal, lighting.rim) * edge * samples.open_sky
    sky = (0.5 + 0.5 * samples.up) * samples.open_sky
    half = lighting.key.unit() + np.array([0.0, 0.0, 1.0])
    half = (half / max(float(np.linalg.norm(half)), 1e-6)).astype(np.float32)
    highlight = np.maximum(samples.normal @ half, 0.0) ** 24 * samples.gloss * samples.shadow
    sheen = edge * (1.0 - samples.facing) * samples.sheen * samples.open_sky
    lit = np.zeros_like(samples.color)
    for k in range(3):
        sky_part, ground = np.float32(lighting.sky[k] - lighting.ground[k]), np.float32(lighting.ground[k])
        light = key * np.float32(lighting.key.color[k]) + fill * np.float32(lighting.fill.color[k])
        light += sky * sky_part + samples.open_sky * ground
        lit[:, k] = samples.color[:, k] * light + rim * np.float32(lighting.rim.color[k]) * (
            0.35 + 0.65 * samples.color[:, k]
        )
        lit[:, k] += highlight + sheen * (0.3 + 0.7 * samples.color[:, k])
    return lit


def _diffuse(normal: Array, light: Light) -> Array:
    wrap = np.float32(light.wrap)
    return np.maximum((normal @ light.unit().astype(np.float32) + wrap) / (1 + wrap), 0.0)
