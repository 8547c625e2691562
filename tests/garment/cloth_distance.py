"""How far points lie from a garment's cloth: a plain reference."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from swifttailor.garment.garment import Garment

_STEPS = 20
_NEAR = 4.0


def away_from_cloth(garment: Garment, points: np.ndarray) -> np.ndarray:
    """(n,) cm from points (n, 3) to dense samples of the triangles around them."""
    corners = garment.vertices[garment.faces]
    middles = corners.mean(axis=1)
    near = cKDTree(points).query(middles, distance_upper_bound=_NEAR)[0] < np.inf
    b, c = np.meshgrid(np.linspace(0, 1, _STEPS + 1), np.linspace(0, 1, _STEPS + 1))
    inside = b + c <= 1 + 1e-9
    weights = np.stack([1 - b - c, b, c], axis=-1)[inside]
    samples = np.einsum("sk,fkc->fsc", weights, corners[near]).reshape(-1, 3)
    return cKDTree(samples).query(points)[0]
