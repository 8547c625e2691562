"""Gaussian blur of single pictures."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop

_correlate_columns = CompiledLoop("swifttailor.render.blur_kernels", "correlate_columns")


def gaussian_blur(picture: Array, sigma: float, *, truncate: float = 4.0, reflects: bool = True) -> Array:
    """What `scipy.ndimage.gaussian_filter` gives, whose package takes as long to load as a preview to blur.

    Args:
        picture: (h, w) float32 or float64.
        sigma: Standard deviation, pixels.
        truncate: Where the bell ends, in standard deviations.
        reflects: Whether the picture is mirrored at its rims; zero lies beyond them otherwise.
    """
    radius = int(truncate * sigma + 0.5)
    at = np.arange(-radius, radius + 1)
    bell = np.exp(-0.5 / (sigma * sigma) * at**2)
    weights = bell / bell.sum()
    for _ in range(2):
        given = np.ascontiguousarray(picture)
        blurred = np.empty_like(given)
        _correlate_columns(blurred, given, weights, reflects, np.zeros(given.shape[1]))
        picture = blurred.T
    return np.ascontiguousarray(picture)
