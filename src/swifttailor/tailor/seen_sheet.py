"""What was looked at, to look at: the garment that was read set off, and which panel was seen where."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Pixels
from swifttailor.picture_reader.cut_square import cut_square
from swifttailor.picture_reader.panel_kinds import PANEL_KINDS
from swifttailor.tailor.looking import SeenPicture

SIZE = 384
"""Pixels along each side of a crop."""
_DIM, _LINE = 0.45, (255, 64, 0)
_LEAST_CELLS = 3
"""Kinds of panels that fewer cells show have no name in the picture."""
_KIND_COLORS = (
    *("#0072b2", "#56b4e9", "#009e73", "#cc79a7", "#d55e00", "#e69f00", "#5b3a26", "#f0e442"),
    *("#7f3c8d", "#3969ac", "#80ba5a", "#e73f74", "#a5aa99", "#e68310", "#008695"),
)


def draw_seen(pictures: Sequence[SeenPicture], part: str | None) -> Pixels:
    """The crops side by side, what is not the garment dimmed; and which kind of panel each cell shows.

    Args:
        pictures: At least one.
        part: Of the body; without it nothing is set off.
    """
    tiles = [tile for one in pictures for tile in (_drawn(one, part), _panels_drawn(one, part))]
    return np.concatenate([tile for tile in tiles if tile is not None], axis=1)


def _drawn(picture: SeenPicture, part: str | None) -> Pixels:
    found = next((p for p in picture.reading.parts if p.part == part), None)
    left, top, right, _ = picture.reading.box if found is None or found.cells is None else found.cells.box
    square = left, top, right - left
    shown = cut_square(picture.pixels, square, SIZE).copy()
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


def _panels_drawn(picture: SeenPicture, part: str | None) -> Pixels | None:
    """The crop with its cells in the colours of the kinds of panels, and their names."""
    from PIL import Image, ImageColor, ImageDraw

    cells = next((p.cells for p in picture.reading.parts if p.part == part), None)
    if cells is None:
        return None
    left, top, right, _ = cells.box
    shown = cut_square(picture.pixels, (left, top, right - left), SIZE)
    paper = np.repeat(shown.mean(axis=2, keepdims=True) * _DIM + 255 * (1 - _DIM) * 0.6, 3, axis=2)
    there = cells.mask > 0.5
    rows = np.arange(SIZE) * len(there) // SIZE
    colors = np.array([ImageColor.getrgb(color) for color in _KIND_COLORS], np.float64)
    tinted = 0.35 * paper + 0.65 * colors[cells.kinds[rows[:, None], rows]]
    image = Image.fromarray(np.where(there[rows[:, None], rows, None], tinted, paper).astype(np.uint8))
    pen = ImageDraw.Draw(image)
    kinds = np.bincount(cells.kinds[there], minlength=len(PANEL_KINDS))
    for line, kind in enumerate(k for k in np.argsort(-kinds) if kinds[k] >= _LEAST_CELLS):
        y = 8 + 17 * line
        pen.rectangle((8, y, 20, y + 12), fill=_KIND_COLORS[kind])
        pen.text((26, y), PANEL_KINDS[kind], fill=(20, 20, 20))
    return np.asarray(image)


def _crop(mask: NDArray[np.float32], square: tuple[int, int, int]) -> NDArray[np.float32]:
    """(SIZE, SIZE) of a mask (h, w); nothing outside."""
    levels = np.repeat(np.round(255 * mask).astype(np.uint8)[:, :, None], 3, axis=2)
    padded = np.pad(levels, ((1, 1), (1, 1), (0, 0)))
    left, top, side = square
    return cut_square(padded, (left + 1, top + 1, side), SIZE)[:, :, 0].astype(np.float32) / 255
