"""Dynamic time warping of many pairs of seam sides at once.

Each side is a row of places along the seam, ascending from 0 to 1. A warping pairs the places of both sides
in order, the first with the first and the last with the last, every place at least once, so that the paired
places differ as little as possible in sum. H. Sakoe and S. Chiba, "Dynamic programming algorithm
optimization for spoken word recognition", 1978. It is solved for all seams together, row by row of the longer
sides; only a band around the nearest places is looked at, which no best warping of ascending places leaves.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Longs

_MARGIN = 2
"""Places that the band reaches beyond the nearest ones."""
_TIE = 1e-9
"""Sums that differ by less are equal. Of equals the step along both sides is taken, so that no place is
paired with two others of which one has a second partner itself."""
_DIAGONAL, _ALONG_LONGER, _ALONG_SHORTER = 0, 1, 2


def warp(places: Floats, start: Longs) -> Longs:
    """Pairs the places of the two sides of every seam.

    Args:
        places: (n,) places, ascending within each side.
        start: (2 s + 1,) where side b of seam k begins: ``start[2 * k + b]``. A seam with an empty side has
            no pairs.

    Returns:
        (m, 2) indices into `places`: of the first side and of the second, seam after seam, along the seam.
    """
    start = np.asarray(start, np.int64)
    sizes = np.diff(start).reshape(-1, 2)
    seams = np.flatnonzero(sizes.all(axis=1))
    if not len(seams):
        return np.zeros((0, 2), np.int64)
    longer = np.argmax(sizes[seams], axis=1)
    rows, columns = sizes[seams, longer], sizes[seams, 1 - longer]
    first_row, first_column = start[2 * seams + longer], start[2 * seams + 1 - longer]
    band = _Band.around_nearest(places, first_row, rows, first_column, columns)
    low, high = _matched_columns(places, first_row, rows, first_column, columns, band)

    seam, row = np.nonzero(np.arange(low.shape[1]) < rows[:, None])
    count = (high - low + 1)[seam, row]
    which = np.repeat(np.arange(len(seam)), count)
    step = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    seam, row = seam[which], row[which]
    pairs = np.stack([first_row[seam] + row, first_column[seam] + low[seam, row] + step], axis=1)
    return np.where((longer[seam] == 1)[:, None], pairs[:, ::-1], pairs)


class _Band:
    """The columns that are looked at in each row."""

    def __init__(self, start: Longs, width: int) -> None:
        self.start, self.width = start, width
        """(s, r) first column, which may be negative, and the number of columns."""

    @classmethod
    def around_nearest(
        cls, places: Floats, first_row: Longs, rows: Longs, first_column: Longs, columns: Longs
    ) -> _Band:
        count = len(rows)
        row = np.minimum(np.arange(int(rows.max())), (rows - 1)[:, None])
        # Seams lie 3 apart on one ascending axis, so that one search serves all.
        column_seam = np.repeat(np.arange(count), columns)
        column = np.arange(len(column_seam)) - np.repeat(np.cumsum(columns) - columns, columns)
        axis = places[first_column[column_seam] + column] + 3.0 * column_seam
        wanted = places[first_row[:, None] + row] + 3.0 * np.arange(count)[:, None]
        before = np.searchsorted(axis, wanted.ravel(), side="right").reshape(wanted.shape) - 1
        before -= (np.cumsum(columns) - columns)[:, None]
        nearest = np.clip(before, 0, (columns - 1)[:, None])
        nearest[:, 0] = 0
        nearest[row == (rows - 1)[:, None]] = np.repeat(columns - 1, (row == (rows - 1)[:, None]).sum(axis=1))
        widest = int(np.diff(nearest, axis=1).max(initial=0))
        return cls(nearest - widest - _MARGIN, 2 * (widest + _MARGIN) + 2)


def _matched_columns(
    places: Floats, first_row: Longs, rows: Longs, first_column: Longs, columns: Longs, band: _Band
) -> tuple[Longs, Longs]:
    """First and last column (s, r) that each row is paired with."""
    count, height = band.start.shape
    steps = np.zeros((height, count, band.width), np.int8)
    column = band.start[:, :, None] + np.arange(band.width)
    outside = (column < 0) | (column >= columns[:, None, None])
    row = np.minimum(np.arange(height), (rows - 1)[:, None])
    cost = np.abs(
        places[first_row[:, None] + row][:, :, None]
        - places[first_column[:, None, None] + np.clip(column, 0, (columns - 1)[:, None, None])]
    )
    cost[outside] = np.inf
    moved = np.diff(band.start, axis=1)
    padded = np.full((count, 2 * band.width + 1), np.inf)
    every, at = np.arange(count)[:, None], np.arange(band.width)
    reached = _along_row(np.where(column[:, 0] == 0, 0.0, np.inf), cost[:, 0], outside[:, 0])
    steps[0] = np.where(column[:, 0] > 0, _ALONG_SHORTER, _DIAGONAL)
    for k in range(1, height):
        padded[:, 1 : band.width + 1] = reached
        place = np.minimum(at + moved[:, k - 1, None], band.width)
        diagonal, above = padded[every, place], padded[every, place + 1]
        straight = diagonal <= above + _TIE
        base = np.where(straight, diagonal, above)
        reached = _along_row(base, cost[:, k], outside[:, k])
        left = np.concatenate([np.full((count, 1), np.inf), reached[:, :-1]], axis=1)
        step = np.where(straight, _DIAGONAL, _ALONG_LONGER)
        step[left + _TIE < base] = _ALONG_SHORTER
        steps[k] = step

    # The place in its row from which each place is reached along the row.
    begins = np.maximum.accumulate(np.where(steps != _ALONG_SHORTER, np.arange(band.width), 0), axis=2)
    low, high = np.zeros((2, count, height), np.int64)
    last = columns - 1
    seam = np.arange(count)
    for k in range(height - 1, -1, -1):
        within = k < rows
        end = np.clip(last - band.start[:, k], 0, band.width - 1)
        begin = begins[k, seam, end]
        low[:, k], high[:, k] = band.start[:, k] + begin, last
        before = low[:, k] - (steps[k, seam, begin] == _DIAGONAL)
        last = np.where(within, before, last)
    return low, high


def _along_row(base: Floats, cost: Floats, outside: NDArray[np.bool_]) -> Floats:
    """Least sums (s, w) in a row that is entered with sums `base` and walked from left to right."""
    passed = np.where(outside, 0.0, cost)
    way = np.cumsum(passed, axis=1)
    reached = np.minimum.accumulate(base - way + passed, axis=1) + way
    reached[outside] = np.inf
    return reached
