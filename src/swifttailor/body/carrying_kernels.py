"""Points carried along by the joints of a rig, compiled."""

from __future__ import annotations

import numpy as np
from numba import njit


@njit(cache=True, fastmath={"contract", "arcp", "nsz"}, error_model="numpy")
def carry_points(points, carrier, share, maps, result):
    """Linear blend skinning.

    Args:
        points: (P, 3) float64, cm.
        carrier: (P, K) uint8 index among the maps.
        share: (P, K) float32, each row sums to 1.
        maps: (C, 12) float64 affine maps, row by row: three numbers and the shift of each coordinate.
        result: (P, 3) float64, written.

    Returns:
        The smallest y written.
    """
    lowest = np.inf
    carriers = carrier.shape[1]
    for p in range(len(points)):
        x, y, z = points[p, 0], points[p, 1], points[p, 2]
        a, b, c = 0.0, 0.0, 0.0
        for k in range(carriers):
            w = np.float64(share[p, k])
            if w == 0.0:
                continue
            m = maps[carrier[p, k]]
            a += w * (m[0] * x + m[1] * y + m[2] * z + m[3])
            b += w * (m[4] * x + m[5] * y + m[6] * z + m[7])
            c += w * (m[8] * x + m[9] * y + m[10] * z + m[11])
        result[p, 0], result[p, 1], result[p, 2] = a, b, c
        lowest = min(lowest, b)
    return lowest
