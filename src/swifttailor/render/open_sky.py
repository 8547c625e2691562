"""Darkness of folds and corners, judged from the depth picture alone."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array

_SCALES = ((1.1, 1.4, 0.50), (4.5, 6.0, 0.45))
"""Neighbourhood cm, depth in cm at which it is darkest, and how dark: for folds; for arms, hems and chin."""
_DARKEST = np.float32(0.3)
_LEAST_BLUR = 0.4
_BLOCK = 1.8
"""Wide blurs are made of blocks of pixels, with at least this many blocks in a deviation."""


def open_sky(depth: Array, pixels_per_cm: float) -> Array:
    """Share (h, w) of the room's light that reaches each pixel.

    A pixel that lies deeper than the mean of its neighbourhood sits in a fold or beside something nearer
    (unsharp masking of the depth buffer).

    Args:
        depth: (h, w) float32 distance from the camera, cm; infinite where nothing is.
        pixels_per_cm: Scale of the picture.

    Returns:
        (h, w) float32, 1 where nothing is there.
    """
    from swifttailor.render.shading_kernels import darken_deep

    sky = np.ones(depth.shape, np.float32)
    for radius, reach, strength in _SCALES:
        sigma = radius * pixels_per_cm
        if sigma < _LEAST_BLUR:
            continue
        step = max(1, int(sigma / _BLOCK))
        tap = np.arange(int(2.5 * sigma / step + 0.5) + 1)
        taps = np.exp(-0.5 * (tap * step / sigma) ** 2).astype(np.float32)
        blocks = np.zeros((2, 2, -(-depth.shape[0] // step), -(-depth.shape[1] // step)), np.float32)
        darken_deep(sky, depth, step, taps, blocks, np.float32(reach), np.float32(strength))
    return np.maximum(sky, _DARKEST)
