"""Fills small holes in panels.

Between the two sides of a narrow slit that is not sewn there is an empty pixel here and there. A panel is one
loop and has no holes: what looks like one is such a slit, most of which the pixels have closed already.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.ggi.stitching import StitchingImage

_LARGEST = 24
"""Pixels; a larger hole is not filled, since nothing is known of what would be in it."""
_AROUND = np.ones((3, 3))


def fill_pockets(
    panel: NDArray[np.integer], geometry: NDArray[np.floating], stitching: StitchingImage
) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Gives the pixels of small holes to the panel around them, each half-way between its neighbours.

    Holes beside sewn pixels are left: sewing closes them.

    Args:
        panel: (N, N) panel index, -1 where there is none.
        geometry: (N, N, 3) positions, cm.
        stitching: Of the same images.

    Returns:
        Panel indices and positions with the holes filled.
    """
    from scipy import ndimage  # takes a twentieth of a second to load

    panel, geometry = panel.astype(np.int64), geometry.astype(np.float64)
    empty = panel < 0
    # What touches at a corner hangs together: between two such pixels there is no triangle.
    hole, count = ndimage.label(empty, _AROUND)
    size = np.bincount(hole.ravel(), minlength=count + 1)
    small = size <= _LARGEST
    small[0] = False
    small[np.unique(np.concatenate([hole[[0, -1]].ravel(), hole[:, [0, -1]].ravel()]))] = False
    inside = small[hole]
    if not inside.any():
        return panel, geometry
    sewn = np.zeros(panel.shape, np.bool_)
    sewn.ravel()[stitching.pixels] = True
    # The least and greatest panel and whether anything sewn is around each hole.
    lowest = np.where(empty, panel.max() + 1, panel)
    low = ndimage.minimum(ndimage.minimum_filter(lowest, footprint=_AROUND), hole, np.arange(count + 1))
    high = ndimage.maximum(ndimage.maximum_filter(panel, footprint=_AROUND), hole, np.arange(count + 1))
    beside_sewn = ndimage.maximum(ndimage.maximum_filter(sewn, footprint=_AROUND), hole, np.arange(count + 1))
    fill = small & (low == high) & ~np.asarray(beside_sewn, np.bool_)
    inside = fill[hole]
    panel[inside] = np.asarray(high)[hole[inside]]
    return panel, _grown(geometry, ~empty, inside)


def _grown(
    geometry: NDArray[np.float64], known: NDArray[np.bool_], wanted: NDArray[np.bool_]
) -> NDArray[np.float64]:
    """Positions of the wanted pixels: the mean of the known ones around each, from the rim inwards."""
    wanted = wanted.copy()
    while wanted.any():
        row, column = np.nonzero(wanted)
        around = [(row + dy, column + dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]
        weight = sum(known[at].astype(np.float64) for at in around)
        total = sum(np.where(known[at][:, None], geometry[at], 0.0) for at in around)
        reached = np.asarray(weight) > 0
        row, column = row[reached], column[reached]
        geometry[row, column] = np.asarray(total)[reached] / np.asarray(weight)[reached, None]
        known[row, column] = True
        wanted[row, column] = False
    return geometry
