"""The same garment in other pictures: nearer, aside, tilted, in other light.

From thousands of garments a vision transformer learns the pictures by heart; these are not the same twice.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Pixels

SHIFT = 0.05
"""Share of the side that the picture is moved by at most, to all sides."""
SCALE = 0.1
TILT = np.deg2rad(4.0)
LIGHT = 0.1
"""By how much each colour, and all together, become stronger or weaker, and lighter or darker, of white."""
NOISE = 0.02
"""Standard deviation at most, of white."""


def vary_picture(pixels: Pixels, chance: np.random.Generator, strength: float = 1.0) -> Pixels:
    """Another picture of the same thing.

    Args:
        pixels: (h, w, 3) sRGB. What comes in from outside has the middle colour of its border.
        chance: Decides.
        strength: Factor on how different it is; 0 leaves it as it is.

    Returns:
        The same shape.
    """
    from PIL import Image

    if not strength:
        return pixels
    height, width, _ = pixels.shape
    scale = 1 + strength * SCALE * chance.uniform(-1, 1)
    angle = strength * TILT * chance.uniform(-1, 1)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) / scale
    middle, size = np.array([width / 2, height / 2]), np.array([width, height])
    offset = middle - turn @ (middle + strength * SHIFT * size * chance.uniform(-1, 1, size=2))
    border = np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]])
    moved = Image.fromarray(pixels).transform(
        (width, height),
        Image.Transform.AFFINE,
        tuple(np.column_stack([turn, offset]).ravel()),
        Image.Resampling.BILINEAR,
        fillcolor=tuple(int(c) for c in np.median(border, axis=0)),
    )
    gain = 1 + strength * LIGHT * (chance.uniform(-1, 1) + chance.uniform(-1, 1, size=3))
    bias = 255 * strength * LIGHT * (chance.uniform(-1, 1) + chance.uniform(-1, 1, size=3)) / 2
    lit = np.asarray(moved, np.float32) * gain.astype(np.float32) + bias.astype(np.float32)
    noise = chance.standard_normal(pixels.shape, np.float32)
    lit += np.float32(255 * strength * NOISE * chance.random()) * noise
    return lit.clip(0, 255).round().astype(np.uint8)
