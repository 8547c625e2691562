"""What was looked at, to look at: the crop of a picture with the garment that was read set off."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.reader import cut_square
from swifttailor.tailor.looking import SeenPicture

SIZE = 384
"""Pixels along each side of a crop."""
_DIM, _LINE = 0.45, (255, 64, 0)


def draw_seen(pictures: Sequence[SeenPicture], part: str | None) -> Pixels:
    """The crops side by side; what is not the garment is dimmed, its outline drawn.

    Args:
        pictures: At least one.
        part: Of the body; without it nothing is set off.
    """
    return np.concatenate([_drawn(one, part) for one in pictures], axis=1)


def _drawn(picture: SeenPicture, part: str | None) -> Pixels:
    left, top, right, _ = picture.reading.box
    square = left, top, right - left
    shown = cut_square(picture.pixels, square, SIZE).copy()
    found = next((p for p in picture.reading.parts if p.part == part), None)
    if found is None:
        return shown
    inside = _crop(found.mask, square) > 0.5
    grey = shown.mean(axis=2, keepdims=True) * _DIM + 255 * (1 - _DIM) * 0.6
    shown = np.where(inside[:, :, None], shown, grey).astype(np.uint8)
    grown = inside.copy()
    for axis in (0, 1):
        for step in (-2, -1, 1, 2):
            grown |= np.roll(inside, step, axis)
    shown[grown & ~inside] = _LINE
    return shown


def _crop(mask: NDArray[np.float32], square: tuple[int, int, int]) -> NDArray[np.float32]:
    """(SIZE, SIZE) of a mask (h, w); nothing outside."""
    levels = np.repeat(np.round(255 * mask).astype(np.uint8)[:, :, None], 3, axis=2)
    padded = np.pad(levels, ((1, 1), (1, 1), (0, 0)))
    left, top, side = square
    return cut_square(padded, (left + 1, top + 1, side), SIZE)[:, :, 0].astype(np.float32) / 255
