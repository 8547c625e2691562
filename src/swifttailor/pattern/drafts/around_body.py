"""Where narrow panels of a skirt stand before draping: on an ellipse around the body."""

from __future__ import annotations

import math

import numpy as np

from swifttailor.arrays import Floats

_AROUND_X, _AROUND_Z = 28.0, 23.0
"""Half axes of the ellipse, cm."""
_EDGE, _STEPS = 0.012, 720


def around(share: float) -> tuple[Floats, Floats]:
    """Point and direction (2,), x and z, on the front half of the ellipse, at a share of it from -x on."""
    angles = np.linspace(math.pi, 0.0, _STEPS + 1)
    points = np.stack([_AROUND_X * np.cos(angles), _AROUND_Z * np.sin(angles)], axis=1)
    reached = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    share = min(max(share, _EDGE), 1.0 - _EDGE)

    def at(part: float) -> Floats:
        return np.array([np.interp(part * reached[-1], reached, points[:, axis]) for axis in (0, 1)])

    along = at(share + _EDGE) - at(share - _EDGE)
    return at(share), along / np.linalg.norm(along)
