"""Darkness of folds and corners, judged from the depth picture alone."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter, zoom

from swifttailor.arrays import Array

_SCALES = ((1.1, 1.4, 0.50), (4.5, 6.0, 0.45))
"""Neighbourhood cm, depth in cm at which it is darkest, and how dark: for folds; for arms, hems and chin."""
_DARKEST = 0.3


def open_sky(depth: Array, covered: Array, pixels_per_cm: float) -> Array:
    """Share (h, w) of the room's light that reaches each pixel.

    A pixel that lies deeper than the mean of its neighbourhood sits in a fold or beside something nearer
    (unsharp masking of the depth buffer).

    Args:
        depth: (h, w) distance from the camera, cm; anything where not covered.
        covered: (h, w) whether something is there.
        pixels_per_cm: Scale of the picture.

    Returns:
        (h, w) float32, 1 where nothing is there.
    """
    weight = covered.astype(np.float32)
    value = np.where(covered, depth, 0).astype(np.float32)
    dark = np.zeros_like(value)
    for radius, reach, strength in _SCALES:
        sigma = radius * pixels_per_cm
        if sigma < 0.4:
            continue
        mean = _blur(value, sigma) / np.maximum(_blur(weight, sigma), np.float32(1e-3))
        dark += np.float32(strength) * np.clip((value - mean) / np.float32(reach), 0, 1)
    return np.where(covered, np.maximum(1 - dark, np.float32(_DARKEST)), np.float32(1))


def _blur(picture: Array, sigma: float) -> Array:
    """Gaussian blur; wide ones are made on a coarser picture."""
    step = max(1, int(sigma / 2.5))
    if step == 1:
        return gaussian_filter(picture, sigma, truncate=2.5)
    height, width = picture.shape
    padded = np.pad(picture, ((0, -height % step), (0, -width % step)), mode="edge")
    coarse = box_mean(padded, step)
    coarse = gaussian_filter(coarse, sigma / step, truncate=2.5)
    fine = zoom(coarse, step, order=1, mode="nearest", grid_mode=True)
    return fine[:height, :width]


def box_mean(picture: Array, step: int) -> Array:
    """Means of (h, w, ...) over blocks of `step` by `step`, which must fit; faster than a reduction."""
    total = np.zeros((picture.shape[0] // step, picture.shape[1] // step, *picture.shape[2:]), np.float32)
    for j in range(step):
        for i in range(step):
            total += picture[j::step, i::step]
    return total / np.float32(step * step)
