"""Which pictures may be plain: before one colour, as those of GarmentCodeData are.

Networks that have learnt from nothing else read these better; they say themselves which pictures are theirs,
and are not even asked of photographs.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels

_ALIKE = 6
"""By how much values of one colour may differ, of 255: JPEG's files are not exact."""
_SHARE = 0.97
"""Of the border; a hem or a hand may touch it."""


_MOSTLY, _NEARLY = 0.4, 16
"""The same of a photograph before a plain ground, with hair and arms at its border."""


def mostly_one_colour_around(pixels: Pixels) -> bool:
    """Whether much of the border of a picture (h, w, 3) has about one colour, as in pictures of shops."""
    border = _border(pixels)
    apart = np.abs(border - np.median(border, axis=0)).max(axis=1)
    return bool((apart <= _NEARLY).mean() >= _MOSTLY)


def one_colour_around(pixels: Pixels) -> bool:
    """Whether the border of a picture (h, w, 3) has one colour."""
    border = _border(pixels)
    apart = np.abs(border - np.median(border, axis=0)).max(axis=1)
    return bool((apart <= _ALIKE).mean() >= _SHARE)


def colour_around(pixels: Pixels) -> NDArray[np.float64]:
    """(3,) the usual colour of the border of a picture (h, w, 3), 0 to 255."""
    return np.asarray(np.median(_border(pixels), axis=0), np.float64)


def _border(pixels: Pixels) -> NDArray[np.int16]:
    return np.concatenate([pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]]).astype(np.int16)
