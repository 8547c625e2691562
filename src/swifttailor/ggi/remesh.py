"""Panels as triangles between neighbouring pixels (paper, Alg. 5)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Longs


@dataclass(frozen=True, eq=False)
class PixelGrid:
    """The occupied pixels of an image, numbered in ascending order: every other array uses these numbers."""

    resolution: int
    pixels: Longs
    """(n,) row * resolution + column."""
    numbers: Longs
    """(N, N) the number of each occupied pixel, -1 elsewhere."""
    panel: Longs
    """(n,) panel index of each."""

    @classmethod
    def of(cls, panel: NDArray[np.integer]) -> PixelGrid:
        """From an image (N, N) of panel indices, -1 where there is none."""
        pixels = np.flatnonzero(panel.ravel() >= 0)
        numbers = np.full(panel.size, -1, np.int64)
        numbers[pixels] = np.arange(len(pixels))
        return cls(len(panel), pixels, numbers.reshape(panel.shape), panel.ravel()[pixels].astype(np.int64))

    def steps(self, start: Longs, end: Longs) -> tuple[Longs, Longs]:
        """Columns and rows from each pixel to another."""
        a, b = self.pixels[start], self.pixels[end]
        size = self.resolution
        return b % size - a % size, b // size - a // size


def remesh(grid: PixelGrid, positions: Floats, diagonals: Longs | None = None) -> Longs:
    """Joins neighbouring pixels to triangles (Alg. 5).

    A square of four pixels of one panel makes two triangles, parted by the diagonal that is shorter in space;
    one of three makes one. All run anticlockwise, so that their right side is that of the layout.

    Args:
        grid: The pixels.
        positions: (n, 3) of each, cm.
        diagonals: (d, 2) pairs of pixels that touch at a corner and are to be joined, whatever their length.

    Returns:
        (f, 3) faces, numbers of pixels.
    """
    number = grid.numbers
    corner = (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1])  # anticlockwise
    there = [c >= 0 for c in corner]
    count = sum(t.astype(np.int8) for t in there)
    whole, part = (np.stack([c[count == wanted] for c in corner], axis=1) for wanted in (4, 3))
    rising, falling = whole[:, [0, 2]], whole[:, [1, 3]]
    first = _squared_length(positions, rising) <= _squared_length(positions, falling)
    if diagonals is not None and len(diagonals):
        keys = np.unique(_keys(np.concatenate([diagonals, diagonals[:, ::-1]]), len(grid.pixels)))
        first |= np.isin(_keys(rising, len(grid.pixels)), keys)
        first &= ~np.isin(_keys(falling, len(grid.pixels)), keys)
    one, other = whole[first], whole[~first]
    missing = np.argmin(part, axis=1)
    row = np.arange(len(part))
    three = np.stack([part[row, (missing + k) % 4] for k in (1, 2, 3)], axis=1)
    faces = np.concatenate(
        [one[:, [0, 1, 2]], one[:, [0, 2, 3]], other[:, [0, 1, 3]], other[:, [1, 2, 3]], three]
    )
    a, b, c = (grid.panel[faces[:, k]] for k in range(3))
    mixed = (a != b) | (b != c)
    return faces[~mixed] if mixed.any() else faces


def _squared_length(positions: Floats, pairs: Longs) -> Floats:
    step = np.take(positions, pairs[:, 1], axis=0) - np.take(positions, pairs[:, 0], axis=0)
    return np.einsum("ij,ij->i", step, step)


def _keys(pairs: Longs, count: int) -> Longs:
    return pairs[:, 0] * count + pairs[:, 1]
