"""A belt that draws cloth in while it falls: around the waist of a garment that is tied there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from swifttailor.arrays import Array, Floats, Ints
from swifttailor.body import Body
from swifttailor.garment.hull_reach import hull_reach

if TYPE_CHECKING:
    from swifttailor.draping.simulation import Simulation

_ROOM_CM, _ABOVE_CM = 1.0, 1.3
"""How far off the body a belt lies, and how far above and below it cloth is drawn in with it, cm."""
_TIGHT_AFTER = 0.6
"""In this part of the time a belt is drawn tight; afterwards cloth settles in it."""
_DRAWN_TO = 0.76
"""To no less than this part of its girth is cloth drawn in: more would not fold, but tangle."""
_TRUNK = 1.45
"""Arms lie so many times as far from the middle as the radius of the hips."""
_NEAR_CM = 2.0
"""Cloth so near to a height tells how far around it is there, cm."""
_SIDES = 72


@dataclass(frozen=True, eq=False)
class Tie:
    """What draws a garment in."""

    vertices: Ints
    """(k,) welded vertices of the cloth around the trunk."""
    height: float
    """Of its middle above the floor, cm."""
    width: float
    """cm."""
    middle: Array
    """(2,) x and z of the body there, cm."""
    loose: Array
    """(`_SIDES`,) how far from it cloth reaches around it, before it is tied, cm."""
    tied: Array
    """(`_SIDES`,) and afterwards."""

    def __call__(self, simulation: Simulation, share: float) -> None:
        """Moves cloth that lies outside of the belt into it, when a share of the time is over."""
        share = min(share / _TIGHT_AFTER, 1.0)
        points = simulation.positions[self.vertices]
        reach = 0.5 * self.width + _ABOVE_CM
        own = self.vertices[np.abs(points[:, 1] - self.height) <= reach]
        away = simulation.positions[own][:, [0, 2]] - self.middle
        far = np.linalg.norm(away, axis=1)
        within = (1.0 - share) * self.loose + share * self.tied
        turn = np.arctan2(away[:, 0], away[:, 1]) % (2 * np.pi) * (_SIDES / (2 * np.pi))
        most = np.interp(turn, np.arange(_SIDES + 1), np.append(within, within[0]))
        out = far > most
        rows = own[out]
        ways = away[out] / far[out, None]
        simulation.positions[rows[:, None], [0, 2]] = self.middle + most[out, None] * ways
        speed = simulation.velocities[rows[:, None], [0, 2]]
        outward = np.maximum((speed * ways).sum(axis=1, keepdims=True), 0.0)
        simulation.velocities[rows[:, None], [0, 2]] = speed - outward * ways


def tie_around(vertices: Floats, trunk: Ints, height: float, width: float, body: Body) -> Tie | None:
    """A belt around a garment at a height; None where the cloth does not go around the body there.

    Args:
        vertices: (v, 3) of the garment, cm.
        trunk: (k,) those of the cloth around the trunk.
        height: Of the belt above the floor, cm.
        width: Of the belt, cm.
        body: Who wears it.
    """
    levels = body.measurements
    widest = _TRUNK * max(levels.hips, levels.waist) / (2 * np.pi)
    skin = body.vertices[np.abs(body.vertices[:, 0]) < widest]
    skin = skin[np.abs(skin[:, 1] - height) < 0.5 * width][:, [0, 2]]
    cloth = vertices[trunk]
    cloth = cloth[np.abs(cloth[:, 1] - height) < _NEAR_CM][:, [0, 2]]
    middle = skin.mean(axis=0) if len(skin) else np.zeros(2)
    inner, outer = (_reaches(points, middle) for points in (skin, cloth))
    if inner is None or outer is None or (outer < inner).any():
        return None
    tied = np.minimum(np.maximum(inner + _ROOM_CM, _DRAWN_TO * outer), outer)
    return Tie(trunk, height, width, middle, outer, tied)


def _reaches(points: Floats, middle: Array) -> Array | None:
    """(`_SIDES`,) how far the hull of points (n, 2) lies from a place; None where that is outside."""
    try:
        hull = ConvexHull(points)
    except (QhullError, ValueError):
        return None
    angle = np.arange(_SIDES) * (2 * np.pi / _SIDES)
    reach = hull_reach(hull, middle, np.stack([np.sin(angle), np.cos(angle)], axis=1))
    return None if (hull.equations @ np.append(middle, 1.0) >= 0.0).any() else reach
