"""Flared skirts and coats as wide from the front as they are deep from the side.

Cloth that hangs from bust and shoulder blades is predicted to hang before and behind the body, and flat at
its sides: a swing coat would be seen to swing from the side alone.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.garment.garment import Garment
from swifttailor.garment.trunk_cloth import around_trunk

_NEAR_HEM_CM = 8.0
"""Height above the lowest point of what tells how wide and deep the hem is, cm."""
_FLARED = 1.2
"""Hems of less than so many times the hips are not flared."""
_WIDER = 1.12
"""How much wider than deep such a hem is."""
_SHORTEST_CM = 12.0
"""What ends less far below the hips is a top, cm."""


def flare_evened(garment: Garment, body: Body) -> Floats | None:
    """(v, 3) cm: moved outward at the sides and inward before and behind; None where nothing needs it.

    Args:
        garment: As it was predicted.
        body: Who wears it.
    """
    levels = body.measurements
    own = np.unique(garment.mesh.weld[around_trunk(garment)])
    vertices = garment.vertices
    x, y, z = vertices[own].T
    low, high = float(y.min()), levels.armpit_level
    if any(panel.name.startswith("pant") for panel in garment.pattern.panels):  # legs
        return None
    if low > levels.hips_level - _SHORTEST_CM or float(vertices[:, 1].max()) < high:
        return None
    hem = own[y < low + _NEAR_HEM_CM]
    wide = float(np.quantile(np.abs(vertices[hem, 0]), 0.95))
    front, back = (float(np.quantile(vertices[hem, 2], part)) for part in (0.95, 0.05))
    deep, middle = (front - back) / 2, (front + back) / 2
    if 2 * np.pi * np.sqrt((wide**2 + deep**2) / 2) < _FLARED * levels.hips or wide >= _WIDER * deep:
        return None
    even = (wide + deep) / (1.0 + _WIDER)
    share = np.clip((high - y) / (high - low), 0.0, 1.0)
    moved = vertices.copy()
    moved[own, 0] = x * (1.0 + share * (_WIDER * even / wide - 1.0))
    moved[own, 2] = middle + (z - middle) * (1.0 + share * (even / deep - 1.0))
    return moved
