"""From what files hold to the light that scenes are put together of."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.render.color import decode_srgb

_TO_LINEAR = decode_srgb(np.arange(256) / 255).astype(np.float32)


def linear_light(pixels: Pixels) -> NDArray[np.float32]:
    """(h, w, 3) linear light of sRGB pixels."""
    return _TO_LINEAR[pixels]
