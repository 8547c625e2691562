"""Compiled loop that blurs. Rounding is kept as written: it is that of `scipy.ndimage.correlate1d`."""

from __future__ import annotations

from numba import njit

from swifttailor.render.compile_options import EXACT


@njit(**EXACT)
def correlate_columns(result, picture, weights, reflects, line):
    """Fills `result` (h, w) with weighted sums of (h, w) `picture` along its columns.

    Args:
        result: Of the picture's type.
        picture: float32 or float64.
        weights: (2 r + 1,) the same in both directions.
        reflects: Whether the picture is mirrored at its rims; zero lies beyond them otherwise.
        line: (w,) float64 to work with.
    """
    height, width = picture.shape
    radius = len(weights) // 2
    for row in range(height):
        for column in range(width):
            line[column] = picture[row, column] * weights[radius]
        for step in range(radius, 0, -1):
            above, below = row - step, row + step
            weight = weights[radius - step]
            if reflects:
                above, below = above % (2 * height), below % (2 * height)
                above = 2 * height - 1 - above if above >= height else above
                below = 2 * height - 1 - below if below >= height else below
            for column in range(width):
                first = float(picture[above, column]) if above >= 0 else 0.0
                last = float(picture[below, column]) if below < height else 0.0
                line[column] += (first + last) * weight
        for column in range(width):
            result[row, column] = line[column]
