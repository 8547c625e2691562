"""How far what is stretched around some points reaches."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array

if TYPE_CHECKING:
    from scipy.spatial import ConvexHull

_FACING = 1e-9


def hull_reach(hull: ConvexHull, middle: Array, ways: Array) -> Array:
    """(k,) how far the border of a convex hull in the plane lies from a place in some directions.

    Args:
        hull: Of points (n, 2).
        middle: (2,) in it; from outside, reaches are negative somewhere, or too short.
        ways: (k, 2) of unit length.
    """
    along = ways @ hull.equations[:, :2].T
    room = -(hull.equations[:, :2] @ middle + hull.equations[:, 2])
    facing = along > _FACING
    reach: Array = np.where(facing, room / np.where(facing, along, 1.0), np.inf).min(axis=1)
    return reach
