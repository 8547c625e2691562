"""Darkness of folds and corners, judged from the depth picture alone."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.render.blur import gaussian_blur

_add_blocks = CompiledLoop("swifttailor.render.shading_kernels", "add_blocks")
_darken_deep = CompiledLoop("swifttailor.render.shading_kernels", "darken_deep")
_SCALES = ((1.1, 1.4, 0.50), (4.5, 6.0, 0.45))
"""Neighbourhood cm, depth in cm at which it is darkest, and how dark: for folds; for arms, hems and chin."""
_DARKEST = np.float32(0.3)
_LEAST_BLUR = 0.4
_TRUNCATE = 2.5
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
    sky = np.ones(depth.shape, np.float32)
    for radius, reach, strength in _SCALES:
        sigma = radius * pixels_per_cm
        if sigma < _LEAST_BLUR:
            continue
        step = max(1, int(sigma / _BLOCK))
        blocks = -(-depth.shape[0] // step), -(-depth.shape[1] // step)
        sums, counts = np.zeros(blocks, np.float32), np.zeros(blocks, np.float32)
        _add_blocks(sums, counts, depth, step)
        sums, counts = (
            gaussian_blur(b, sigma / step, truncate=_TRUNCATE, reflects=False) for b in (sums, counts)
        )
        _darken_deep(sky, depth, step, sums, counts, reach, strength)
    return np.maximum(sky, _DARKEST)
