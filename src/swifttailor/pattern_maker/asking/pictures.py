"""Pictures as the network sees them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.render.pixels import require_picture

_MEAN = np.array([0.485, 0.456, 0.406], np.float32)
_SPREAD = np.array([0.229, 0.224, 0.225], np.float32)
"""InternVL's, of ImageNet."""


def picture_for_network(pixels: Pixels, size: int) -> NDArray[np.float32]:
    """A picture of any size as the network takes it: made square, resized, its colours normalised.

    Args:
        pixels: (h, w, 3) sRGB, row 0 at the top.
        size: Pixels along each side of the result; what a picture lacks to a square is filled with the
            middle colour of its border.

    Returns:
        (3, size, size).

    Raises:
        InputError: It is no picture of three colours.
    """
    from PIL import Image

    require_picture(pixels)
    height, width, _ = pixels.shape
    image: Any = Image.fromarray(pixels)
    if height != width:
        border = np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]])
        side = max(height, width)
        fill = tuple(int(c) for c in np.median(border, axis=0))
        square = Image.new("RGB", (side, side), fill)
        square.paste(image, ((side - width) // 2, (side - height) // 2))
        image = square
    if image.size != (size, size):
        image = image.resize((size, size), Image.Resampling.BICUBIC)
    values = (np.asarray(image, np.float32) / 255 - _MEAN) / _SPREAD
    return np.ascontiguousarray(values.transpose(2, 0, 1), np.float32)
