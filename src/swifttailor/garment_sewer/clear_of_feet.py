"""Hems that reach the feet, laid over the toes before they fall: behind these they crumple on the insteps."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body

_INSTEP_SHARE = 0.055
"""Height of the insteps as a part of the body's: cloth that ends above them hangs clear."""
_FROM_SHARE = 0.22
"""From this part of the height down the front leans forward to the toes."""
_SHIN = 0.1, 0.18
"""Between these parts of the height the fronts of the shins are measured."""
_TOES_CM = 1.5
"""So far before the toes cloth is laid."""
_BESIDE_CM = 8.0
"""Beside the feet it is laid forward less and less over so much."""
_WIDE_CM, _ASIDE_CM = 19.0, 2.0
"""Narrower legs and skirts, from front to back, do not reach over the toes; how far from the middle that is
measured."""


def clear_of_feet(vertices: Floats, body: Body) -> Floats:
    """Lays the front of a long garment before the toes.

    Args:
        vertices: (v, 3) where it lies, cm.
        body: What it is worn by.

    Returns:
        (v, 3) where it lies then, longer in front than it was cut; the vertices themselves where it ends
        above the feet, or is too narrow to reach over them.
    """
    tall = body.measurements.height
    instep, top = _INSTEP_SHARE * tall, _FROM_SHARE * tall
    x, y, z = vertices.T
    if y.min() > instep or not _is_wide(vertices[y < _SHIN[0] * tall]):
        return vertices
    feet = body.vertices[body.vertices[:, 1] < instep]
    height = body.vertices[:, 1]
    shin = float(body.vertices[(height > _SHIN[0] * tall) & (height < _SHIN[1] * tall), 2].max())
    toes, outer = float(feet[:, 2].max()) + _TOES_CM, float(np.abs(feet[:, 0]).max())
    down = np.clip((top - y) / (top - instep), 0.0, 1.0)
    beside = np.clip(1.0 - (np.abs(x) - outer) / _BESIDE_CM, 0.0, 1.0)
    least = shin + (toes - shin) * down * beside
    in_front = (y < top) & (z > shin - 1.0)
    moved = vertices.copy()
    moved[in_front, 2] = np.maximum(z, least)[in_front]
    return moved


def _is_wide(low: Floats) -> bool:
    """Whether what lies low down (n, 3) reaches far enough from back to front, on both sides."""
    sides = [low[way * low[:, 0] > _ASIDE_CM, 2] for way in (1, -1)]
    return all(len(depth) > 0 and float(np.ptp(depth)) >= _WIDE_CM for depth in sides)
