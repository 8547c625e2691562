"""Pictures as arrays."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.errors import InputError


def require_picture(pixels: Pixels) -> None:
    """Refuses arrays that are no picture.

    Args:
        pixels: Should be (h, w, 3) uint8, at least one pixel.

    Raises:
        InputError: It is no picture of three colours.
    """
    if pixels.ndim != 3 or pixels.shape[2] != 3 or min(pixels.shape) < 1 or pixels.dtype != np.uint8:
        raise InputError(f"A picture is (h, w, 3) of bytes; got {pixels.shape} of {pixels.dtype}.")
