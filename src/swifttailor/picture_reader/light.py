"""Which light a picture was taken in, by what is nearly white around a garment."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.color import GREY
from swifttailor.render.lab import lab_of_linear

_LIGHT_FROM = 62.0
"""Lightness from which a wall or a sheet may be white."""
_CHROMA = 15.0
"""What is more colourful is coloured, and not white in warm light: floors of wood are."""
_LEAST = 0.05
"""Share of the picture, or of the garment, that has to be nearly white."""
_WHITER = 3.0
"""By how much less colourful a garment is that is whiter."""
_MOST = 1.6
"""How much brighter one of red, green and blue becomes at most."""


def under_white_light(linear: Array, mask: Array) -> Array:
    """A picture as it is in white light; as it is where nothing tells which light it was taken in.

    A garment that looks whiter than what lies around it speaks against coloured light.

    Args:
        linear: (h, w, 3) linear light.
        mask: (h, w) 0 to 1: where the garment is.
    """
    lab = lab_of_linear(linear)
    chroma = np.hypot(lab[..., 1], lab[..., 2])
    white = (lab[..., 0] >= _LIGHT_FROM) & (chroma <= _CHROMA)
    around, worn = white & (mask < 0.1), white & (mask > 0.5)
    if around.mean() < _LEAST:
        return linear
    if worn.mean() >= _LEAST * (mask > 0.5).mean():
        if np.median(chroma[worn]) < np.median(chroma[around]) - _WHITER:
            return linear
    around &= chroma <= np.median(chroma[around])
    light = np.median(linear[around], axis=0)
    gains = np.clip(light @ np.array(GREY) / np.maximum(light, 1e-3), 1 / _MOST, _MOST)
    return np.clip(linear * gains, 0.0, 1.0)
