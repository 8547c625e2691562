"""Packing boxes of whole pixels into a square (paper, Alg. 1): how well is decided here, how large is not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]

Packing = Callable[[Ints, int], "Ints | None"]
"""Sizes (n, 2) of boxes and the side of the square, all in pixels, to lower left corners (n, 2) or None."""


def pack_rows(sizes: Ints, side: int) -> Ints | None:
    """Places boxes from left to right in rows, and rows from bottom to top, in the order given.

    With boxes in order of decreasing height this is the paper's heuristic. It is monotone: what fits into a
    square fits into any larger one, and boxes that fit still fit when they shrink without changing their
    order of heights, since every row then ends no earlier and is no higher.

    Args:
        sizes: (n, 2) widths and heights, free space around each included.
        side: Side of the square.

    Returns:
        Lower left corners (n, 2), or None when the boxes do not fit.
    """
    corners = []
    x = y = height = 0
    for w, h in sizes.tolist():
        if x + w > side:
            x, y, height = 0, y + height, 0
        height = max(height, h)
        if x + w > side or y + height > side:
            return None
        corners.append((x, y))
        x += w
    return np.array(corners, np.int64).reshape(-1, 2)
