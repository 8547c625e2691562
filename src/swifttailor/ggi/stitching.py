"""The stitching image (paper, Alg. 3): which pixels of the contours are sewn to which.

The paper gives both edges of a stitch one colour, which says what is sewn together but not which way round.
Here every stitch has two sides, and each side lists its pixels in the order of the seam: the first pixels of
both sides meet, and so do the last. That covers plain and ``right_wrong`` stitches and darts alike, and a
pixel may be in several sides: at corners, and where a panel is thinner than a pixel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Ints
from swifttailor.ggi.layout import Layout


@dataclass(frozen=True, eq=False)
class StitchingImage:
    """The sewn pixels of all stitches."""

    ids: NDArray[np.uint16]
    """(N, N) 0 where nothing is sewn, else one more than the index of a stitch that passes the pixel."""
    pixels: Ints
    """(n,) sewn pixels, row * N + column: for each stitch its first side, then its second, along the seam."""
    fraction: NDArray[np.float32]
    """(n,) where along the seam, 0 to 1; equal values of both sides meet."""
    start: Ints
    """(2 s + 1,) where side b of stitch k begins in `pixels`: ``start[2 * k + b]``."""

    @property
    def stitch_count(self) -> int:
        """Number of stitches."""
        return len(self.start) // 2

    def side(self, stitch: int, side: int) -> tuple[Ints, NDArray[np.float32]]:
        """Pixels and fractions along one side (0 or 1) of a stitch."""
        run = slice(self.start[2 * stitch + side], self.start[2 * stitch + side + 1])
        return self.pixels[run], self.fraction[run]

    def partners(self) -> Ints:
        """(n,) for each of `pixels` the pixel on the stitch's other side that meets it most closely."""
        partner = np.zeros_like(self.pixels)
        sides = len(self.start) - 1
        number = np.repeat(np.arange(sides), np.diff(self.start))
        # Sides are intervals [3 k, 3 k + 1] of one increasing axis, so that one search serves all.
        axis = 3.0 * number + self.fraction
        wanted = 3.0 * (number ^ 1) + self.fraction
        right = np.clip(np.searchsorted(axis, wanted), 0, max(len(axis) - 1, 0))
        left = np.maximum(right - 1, 0)
        if len(partner):
            nearer = np.abs(axis[left] - wanted) <= np.abs(axis[right] - wanted)
            partner[:] = self.pixels[np.where(nearer, left, right)]
        return partner


def stitching_image(layout: Layout) -> StitchingImage:
    """Draws the stitches of a layout's pattern (paper, Alg. 3)."""
    pattern, outlines, raster = layout.pattern, layout.outlines, layout.raster
    pixels, fractions, counts = [], [], [0]
    stitch_of_edge = np.zeros(len(outlines.edge_panel), np.uint16)
    for k, stitch in enumerate(pattern.stitches):
        for second, ref in enumerate(stitch.sides):
            number = outlines.number(pattern, ref)
            stitch_of_edge[number] = k + 1
            run = slice(raster.contour_start[number], raster.contour_start[number + 1])
            along, fraction = raster.contour_pixels[run], raster.contour_fraction[run]
            if second and not stitch.right_wrong:  # a plain stitch joins start to end
                along, fraction = along[::-1], 1.0 - fraction[::-1]
            pixels.append(along)
            fractions.append(fraction)
            counts.append(len(along))
    start = np.cumsum(counts).astype(np.int32)
    sewn = np.concatenate(pixels) if pixels else np.zeros(0, np.int32)
    ids = np.zeros(layout.resolution**2, np.uint16)
    number = np.repeat(np.arange(len(start) - 1) // 2 + 1, np.diff(start))
    ids[sewn[::-1]] = number[::-1]  # of several the first stitch stays,
    nearest = np.where(raster.edge >= 0, stitch_of_edge[raster.edge], 0)
    ids[raster.pixels[nearest > 0]] = nearest[nearest > 0]  # unless the pixel shows a point of another one
    return StitchingImage(
        ids.reshape(layout.resolution, layout.resolution),
        sewn,
        np.concatenate(fractions).astype(np.float32) if fractions else np.zeros(0, np.float32),
        start,
    )
