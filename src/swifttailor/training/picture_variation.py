"""The same garment in other pictures: nearer, aside, tilted, in other light.

From thousands of garments a vision transformer learns the pictures by heart; these are not the same twice.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

SHIFT = 0.05
"""Share of the side that the picture is moved by at most, to all sides."""
SCALE = 0.1
TILT = np.deg2rad(4.0)
LIGHT = 0.2
"""By how much each colour, and all together, become stronger or weaker, of their range."""
NOISE = 0.04

Picture = NDArray[np.float32]


def vary_picture(picture: Picture, chance: np.random.Generator, strength: float = 1.0) -> Picture:
    """Another picture of the same thing.

    Args:
        picture: (3, size, size) from -1 to 1. What comes in from outside repeats its border.
        chance: Decides.
        strength: Factor on how different it is.

    Returns:
        The same shape and range.
    """
    if not strength:
        return picture
    scale = 1 + strength * SCALE * chance.uniform(-1, 1)
    angle = strength * TILT * chance.uniform(-1, 1)
    side = picture.shape[-1]
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]) / scale
    middle = np.full(2, (side - 1) / 2)
    offset = middle - turn @ (middle + strength * SHIFT * side * chance.uniform(-1, 1, size=2))
    moved = np.stack([ndimage.affine_transform(c, turn, offset, order=1, mode="nearest") for c in picture])
    gain = 1 + strength * LIGHT * (chance.uniform(-1, 1) + chance.uniform(-1, 1, size=3)) / 2
    bias = strength * LIGHT * (chance.uniform(-1, 1) + chance.uniform(-1, 1, size=3)) / 2
    noise = chance.normal(scale=strength * NOISE * chance.random(), size=picture.shape)
    lit = moved * gain[:, None, None] + bias[:, None, None] + noise
    return lit.clip(-1, 1).astype(np.float32)
