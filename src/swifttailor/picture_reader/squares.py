"""Squares of pictures: which is looked at next, and what was found in one as part of the whole picture."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.view import Square

_MARGIN = 0.35
"""Around the garment, as a share of its larger extent: what hangs where is told by the body around it."""
_LEAST_PIXELS, _SMALLER = 8, 0.85


def around(mask: NDArray[np.bool_], square: Square) -> Square | None:
    """A square around a garment, where it is a good deal smaller; None where it is not, or none is seen.

    Args:
        mask: (n, n) cells of a square that show it.
        square: That was looked at.
    """
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if len(rows) < 2 or len(columns) < 2:
        return None
    left, top, side = square
    cell = side / mask.shape[0]
    low = np.array([columns[0], rows[0]]) * cell
    high = np.array([columns[-1] + 1, rows[-1] + 1]) * cell
    new = round(float((high - low).max()) * (1 + 2 * _MARGIN))
    if not _LEAST_PIXELS <= new < _SMALLER * side:
        return None
    across, down = np.round((low + high) / 2 - new / 2).astype(int)
    return left + int(across), top + int(down), new


def halves(shape: tuple[int, int]) -> list[Square]:
    """Squares of half the longer side all over a picture (h, w), to look for somebody small.

    They overlap by half, and reach beyond the picture only where that is narrower than they are.
    """
    side = max(max(shape) // 2, 1)
    rows, columns = (
        [(size - side) // 2] if size <= side else sorted({0, (size - side) // 2, size - side})
        for size in shape
    )
    return [(left, top, side) for top in rows for left in columns]


def scaled(square: Square, scale: float) -> Square:
    """A square with the same middle."""
    left, top, side = square
    new = max(round(side * scale), _LEAST_PIXELS)
    return left + (side - new) // 2, top + (side - new) // 2, new


def box_of(square: Square) -> tuple[int, int, int, int]:
    """Left, top, right and bottom."""
    left, top, side = square
    return left, top, left + side, top + side


def mask_of(cells: NDArray[Any], square: Square, shape: tuple[int, int]) -> NDArray[np.float32]:
    """(h, w) of a whole picture, from the cells of a square of it."""
    from PIL import Image

    left, top, side = square
    image = Image.fromarray(cells.astype(np.float32))
    grown = np.asarray(image.resize((side, side), Image.Resampling.BILINEAR))
    height, width = shape
    mask = np.zeros(shape, np.float32)
    y0, y1, x0, x1 = max(top, 0), min(top + side, height), max(left, 0), min(left + side, width)
    if y0 < y1 and x0 < x1:
        mask[y0:y1, x0:x1] = grown[y0 - top : y1 - top, x0 - left : x1 - left]
    return mask
