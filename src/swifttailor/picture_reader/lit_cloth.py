"""The colour of cloth in full light, of pixels in shadow and shine."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.color import encode_srgb
from swifttailor.render.lab import linear_of_lab

_LIT = (0.4, 0.9)
"""Quantiles of lightness between which cloth is neither in shadow nor shines."""
_GREYISH = 8.0
"""Chroma up to which cloth may be white or black."""
_WHITISH, _WHITER, _WHITE = 80.0, 2.2, 97.0
_BLACKISH, _BLACKER = 20.0, 1.5


def lit(lab: Array) -> Array:
    """The colour (3,) of cloth in full light, of what is seen of it (n, 3), CIE Lab."""
    low, high = np.quantile(lab[:, 0], _LIT)
    kept = lab[(lab[:, 0] >= low) & (lab[:, 0] <= high)]
    return _as_white_and_black(np.median(kept, axis=0))


def _as_white_and_black(lab: Array) -> Array:
    """White cloth in a picture is greyer than it is, and black cloth, too: they move towards their ends."""
    lightness, red, yellow = (float(value) for value in lab)
    if np.hypot(red, yellow) > _GREYISH:
        return lab
    if lightness > _WHITISH:
        lightness = min(_WHITISH + _WHITER * (lightness - _WHITISH), max(lightness, _WHITE))
    elif lightness < _BLACKISH:
        lightness = max(_BLACKISH - _BLACKER * (_BLACKISH - lightness), 0.0)
    return np.array([lightness, red, yellow])


def hex_of(lab: Array) -> str:
    """A colour (3,) of CIE Lab as ``#rrggbb``."""
    return "#" + "".join([f"{int(value):02x}" for value in encode_srgb(linear_of_lab(lab))])
