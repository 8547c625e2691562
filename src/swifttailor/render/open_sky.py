"""Darkness of folds and corners, judged from the depth picture alone."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.blur import gaussian_blur

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
        return gaussian_blur(picture, sigma, truncate=2.5)
    down, across = (_blocks(length, step) for length in picture.shape)
    coarse = gaussian_blur(down.means @ picture @ across.means.T, sigma / step, truncate=2.5)
    return down.between @ coarse @ across.between.T


@dataclass(frozen=True, eq=False)
class _Blocks:
    """A row of pixels in blocks of equal length, and back."""

    means: Array
    """(blocks, pixels) float32: what each pixel adds to the mean of its block."""
    between: Array
    """(pixels, blocks) float32: linear interpolation between the blocks' middles, flat at the ends."""


def _blocks(length: int, step: int) -> _Blocks:
    count = -(-length // step)
    means, between = np.zeros((count, length), np.float32), np.zeros((length, count), np.float32)
    # The last block is filled up with the last pixel.
    np.add.at(
        means, (np.arange(count * step) // step, np.minimum(np.arange(count * step), length - 1)), 1 / step
    )
    pixel = np.arange(length)
    at = np.clip((pixel + 0.5) / step - 0.5, 0, count - 1)
    first = at.astype(np.int64)
    between[pixel, first] = 1 - (at - first)
    between[pixel, np.minimum(first + 1, count - 1)] += at - first
    return _Blocks(means, between)
