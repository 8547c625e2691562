"""Whether a bodice leaves the bust bare, before it is made: by the drape that the network begins with."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.sewer import Prepared
from swifttailor.garment_sewer.tightness import worn_coarsely
from swifttailor.pattern.check.covering import hangs_from_shoulders

REACH_CM = 4.0
"""A bust point is covered where the middle of a face is as near as this; most lie within 2.5 cm."""
_DEEPEST_CM, _STEPS = 40.0, 81


def bares_bust(prepared: Prepared, body: BodyDistance) -> bool:
    """Whether one of the bust points has no cloth over it: a neckline below it, or a strap that slid.

    Args:
        prepared: With a prior that hangs.
        body: Who wears it.

    Returns:
        False of what covers no upper part of the body, such as skirts.
    """
    if not hangs_from_shoulders(prepared.layout.pattern):
        return False
    middles = worn_coarsely(prepared)[prepared.mesh.faces].mean(axis=1)
    points = bust_points(body)
    nearest = np.linalg.norm(points[:, None] - middles, axis=2).min(axis=1)
    return bool((nearest > REACH_CM).any())


def bust_points(body: BodyDistance) -> Floats:
    """(2, 3) the wearer's left and right bust point: as far in front as there is body, cm."""
    measurements = body.measurements
    depths = np.linspace(0.0, _DEEPEST_CM, _STEPS)
    found = []
    for side in (0.5, -0.5):
        line = np.zeros((_STEPS, 3))
        line[:, 0], line[:, 1], line[:, 2] = (
            side * measurements.bust_points,
            measurements.bust_level,
            depths,
        )
        distance, _ = body.sample(line, np.ones(_STEPS, dtype=bool))
        found.append(line[np.flatnonzero(distance < 0).max(initial=0)])
    return np.array(found)
