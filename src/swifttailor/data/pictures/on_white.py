"""People on white as they come out when they are cut out of a photograph, with what goes wrong at that."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.data.pictures.linear_light import linear_light
from swifttailor.data.renders.backdrops import random_scenery
from swifttailor.render.color import encode_srgb

_SOFT, _WAVES, _ROUGHEST = (0.004, 0.03), (0.02, 0.12), 0.4
"""How far edges of people who are cut out may move, and how long the waves are in which they do, in sides;
and how far they reach at most: at 0.5 a piece in the middle may be missing."""
_FADE, _SLOPE = 0.012, 0.4
"""How wide an edge is, in sides; and how steep a blurred edge, in its blur."""
_OTHER_BEHIND = 0.8
"""How often something else than the photograph's white is seen where the edge is too wide."""


def on_white(pixels: Pixels, cover: NDArray[np.float32], chance: np.random.Generator) -> Pixels:
    """(s, s, 3): somebody as `person_finder` cuts people out, a little too wide here and too narrow there.

    What is behind comes along where the edge is too wide; where the photograph has white behind, a place by
    lot does. Now and then a piece is missing.

    Args:
        pixels: (s, s, 3).
        cover: (s, s) how much of each pixel shows somebody.
        chance: Decides where.
    """
    from scipy import ndimage

    size = len(pixels)
    far = float(chance.uniform(*_SOFT))
    waves = ndimage.gaussian_filter(chance.normal(0, 1, (size, size)), size * float(chance.uniform(*_WAVES)))
    waves *= float(chance.uniform(0, _ROUGHEST)) / max(float(np.abs(waves).max()), 1e-9)
    soft = ndimage.gaussian_filter(cover, size * far) + waves
    found = np.clip((soft - 0.5) * far / (_SLOPE * _FADE) + 0.5, 0.0, 1.0)[:, :, None]
    light = linear_light(pixels)
    if chance.random() < _OTHER_BEHIND:
        shown = cover[:, :, None]
        light = shown * light + (1 - shown) * random_scenery(chance).light(size)
    return encode_srgb(light * found + (1 - found))
