"""Squares of pictures, as networks are shown them."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Pixels


def cut_square(pixels: Pixels, square: tuple[int, int, int], size: int) -> Pixels:
    """(size, size, 3): a square of a picture (left, top, side); outside, its border goes on.

    Args:
        pixels: (h, w, 3).
        square: In pixels; may lie outside.
        size: Pixels along each side of the result.
    """
    from PIL import Image

    left, top, side = square
    height, width = pixels.shape[:2]
    first_row, first_column = min(max(top, 0), height - 1), min(max(left, 0), width - 1)
    last_row, last_column = min(max(top + side, 1), height), min(max(left + side, 1), width)
    shown = pixels[first_row:last_row, first_column:last_column]
    beyond = (
        (max(-top, 0), max(top + side - height, 0)),
        (max(-left, 0), max(left + side - width, 0)),
    )
    if any(map(any, beyond)):
        # What lies outside is the border again, however far outside the square begins.
        around = [
            (min(a, side - n), min(b, side - n)) for (a, b), n in zip(beyond, shown.shape, strict=False)
        ]
        shown = np.pad(shown, (*around, (0, 0)), mode="edge")
    image = Image.fromarray(np.ascontiguousarray(shown))
    if image.size != (size, size):
        image = image.resize(
            (size, size), Image.Resampling.BOX if side > 2 * size else Image.Resampling.BICUBIC
        )
    return np.asarray(image)
