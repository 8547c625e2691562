"""Hands that stay inside the sleeves which cover them, for pictures: thumbs would come through the cloth."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array, Floats

_FROM, _TO = 0.72, 1.05
"""Where hands are, in lengths of the arm from its joint to the tip of the hand: from above the wrist on."""
_BESIDE_CM = 13.0
"""A sleeve further from the arm than this is the other one, cm."""
_SLICE_CM, _SECTORS, _WINDOW = 1.0, 16, 2
"""How thick a slice across the arm is, in how many sectors it is looked at, and how many slices on either
side tell of it: cloth has a vertex every 2 cm."""
_AROUND = 0.7
"""A sleeve is there where cloth lies in so much of the circle."""
_ROOM_CM, _LEAST_CM = 0.7, 0.6
"""How far a hand stays off the vertices of the cloth, whose triangles cut its curves; how thin it may get."""


@dataclass(frozen=True, eq=False)
class Arm:
    """An arm in the pose that it has."""

    joint: Array
    """(3,) its upper end, cm."""
    axis: Array
    """(3,) unit direction from there to the tip of the hand."""
    length: float
    """How far away that is, cm."""
    vertices: Array
    """(k,) which vertices of the body are this arm's."""


def hands_in_sleeves(vertices: Floats, sleeves: Floats, arms: Iterable[Arm]) -> Floats:
    """Makes hands narrower wherever they would come through a sleeve that goes around them.

    Args:
        vertices: (n, 3) of a body, cm.
        sleeves: (k, 3) of the sleeves alone, cm: beside hanging arms there is other cloth.
        arms: Of the body.

    Returns:
        (n, 3) moved towards the middle of the sleeve; the vertices themselves where none has to be.
    """
    for arm in arms:
        across = np.linalg.svd(arm.axis[None])[2][1:]
        first = _FROM * arm.length
        count = int((_TO * arm.length - first) / _SLICE_CM)
        slices, at = _places(sleeves - arm.joint, arm.axis, across, first)
        near = (slices >= -_WINDOW) & (slices < count + _WINDOW) & (np.linalg.norm(at, axis=1) < _BESIDE_CM)
        if not near.any():
            continue
        middles, radii = _rings(slices[near], at[near], count)
        own, where = _places(vertices[arm.vertices] - arm.joint, arm.axis, across, first)
        inside = np.flatnonzero((own >= 0) & (own < count))
        inside = inside[np.isfinite(radii[own[inside], 0])]
        off = where[inside] - middles[own[inside]]
        allowed = _allowed(off, radii[own[inside]])
        reach = np.linalg.norm(off, axis=1)
        out = reach > allowed
        if not out.any():
            continue
        share = (allowed[out] / reach[out] - 1.0)[:, None]
        vertices = vertices.copy()
        vertices[arm.vertices[inside[out]]] += (share * off[out]) @ across
    return vertices


def _places(points: Floats, axis: Array, across: Array, first: float) -> tuple[Array, Floats]:
    """Slices (k,) along an arm in which points (k, 3) lie, and where in these (k, 2), cm."""
    return np.floor((points @ axis - first) / _SLICE_CM).astype(int), points @ across.T


def _rings(slices: Array, at: Floats, count: int) -> tuple[Floats, Floats]:
    """Middle (count, 2) of the sleeve in each slice and how far away it is in each sector; NaN for none."""
    middles, radii = np.zeros((count, 2)), np.full((count, _SECTORS), np.nan)
    for k in range(count):
        ring = at[np.abs(slices - k) <= _WINDOW]
        if len(ring) < _SECTORS // 2:
            continue
        middle = (ring.min(axis=0) + ring.max(axis=0)) / 2
        off = ring - middle
        sector = _sectors(off).astype(int) % _SECTORS
        nearest = np.full(_SECTORS, np.inf)
        np.minimum.at(nearest, sector, np.linalg.norm(off, axis=1))
        there = np.flatnonzero(np.isfinite(nearest))
        gaps = np.diff(np.append(there, there[0] + _SECTORS))
        if gaps.max() > (1 - _AROUND) * _SECTORS:
            continue
        middles[k] = middle
        radii[k] = np.interp(np.arange(_SECTORS), there, nearest[there], period=_SECTORS)
    return middles, radii


def _sectors(off: Floats) -> Array:
    """(n,) in which sector of a circle points (n, 2) lie, 0 to `_SECTORS`."""
    return np.arctan2(off[:, 1], off[:, 0]) / (2 * np.pi) % 1.0 * _SECTORS


def _allowed(off: Floats, radii: Floats) -> Floats:
    """How far (n,) from the middle a hand may reach at places (n, 2), by the radii (n, sectors) there."""
    turn = _sectors(off) - 0.5
    low = np.floor(turn).astype(int)
    share, rows = turn - low, np.arange(len(off))
    reach = (1 - share) * radii[rows, low % _SECTORS] + share * radii[rows, (low + 1) % _SECTORS]
    return np.maximum(reach - _ROOM_CM, _LEAST_CM)
