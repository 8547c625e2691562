"""Belts of a garment as small meshes: stretched around the cloth, closed by a buckle or a knot."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import ConvexHull, QhullError

from swifttailor.arrays import Array
from swifttailor.garment.hull_reach import hull_reach
from swifttailor.garment.trim_pieces import TrimMesh, ball, front_of
from swifttailor.garment.trunk_cloth import around_trunk
from swifttailor.pattern.trims.shapes import Belt

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_BELT_LIFT, _BELT_SIDES, _BELT_REACH = 0.5, 96, 2.5
_BEYOND_CM = 0.3
"""Cloth so far above and below a belt lies inside of it as well, cm."""
_KEEPS_TO = 0.002
"""By how much narrower, per cm, the cloth must be elsewhere for a belt to slip there."""
_WAISTED = 0.97
"""Cloth whose girth at its narrowest is less than this part of what is above and below has a waist."""
_TAIL, _KNOT = 26.0, 2.2
_BANDS = ("wb_front", "wb_back")
_TIED_BEHIND = ("sash", "apron", "side tie")
"""Bands whose bow is marked elsewhere than in front."""
_BESIDE_CM = 0.22
"""A button whose middle lies so near to the edge of a belt is hidden by it, too, cm."""


def belt_meshes(garment: Garment, belt: Belt) -> list[TrimMesh]:
    """A band stretched around the cloth at its height, with what closes it in front."""
    heights = belt_height(garment, belt) + belt.width * np.array([-0.5, 0.0, 0.5])
    if _is_on_band(garment):  # gathers below it stand out, and the belt does not
        rings = [_around(garment, height, _BEYOND_CM, within=heights[[0, -1]]) for height in heights]
    elif belt.reach:  # cloth that is tied stands out above and below, and the belt does not
        rings = [_around(garment, heights[1], 0.5 * belt.width + _BEYOND_CM)] * len(heights)
    else:
        rings = [_around(garment, height) for height in heights]
    if any(ring is None for ring in rings):
        return []
    rows = [ring for ring in rings if ring is not None]
    vertices = np.concatenate(
        [
            np.stack([row[:, 0], np.full(len(row), y), row[:, 1]], axis=1)
            for row, y in zip(rows, heights, strict=True)
        ]
    )
    grid = np.arange(len(vertices)).reshape(len(rows), -1)
    after = np.roll(grid, -1, axis=1)
    quads = np.stack([grid[:-1], grid[1:], after[1:], after[:-1]], axis=-1).reshape(-1, 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32)
    edges = np.concatenate([np.stack([row, np.roll(row, -1)], axis=1) for row in (grid[0], grid[-1])])
    look = "leather" if belt.trim == "buckle belt" else "cloth"
    band = TrimMesh(belt.trim, look, vertices, faces, edges)
    front = vertices[grid[1, 0]]
    if belt.trim == "buckle belt":
        return [band, _buckle(belt, front)]
    if belt.trim in _TIED_BEHIND:
        return [band]
    return [band, *_knot(garment, belt, front)]


def under_a_belt(belts: Mapping[str, Belt], garment: Garment, button: TrimMesh) -> bool:
    """Whether a button lies below a belt, which slips to where the sewn cloth is narrowest."""
    y = float(button.vertices[:, 1].mean())
    tied = [belt for belt in belts.values() if belt.reach]
    return any(abs(y - belt_height(garment, belt)) < 0.5 * belt.width + _BESIDE_CM for belt in tied)


def on_a_belt(garment: Garment, belt: Belt, at: Array) -> Array:
    """(3,) the place on a belt that is nearest to one on the cloth, where its bow is tied."""
    height = belt_height(garment, belt)
    ring = _around(garment, height, 0.5 * belt.width + _BEYOND_CM)
    if ring is None:
        return at
    x, z = ring[np.linalg.norm(ring - at[[0, 2]], axis=1).argmin()]
    return np.array([x, height, z])


def belt_height(garment: Garment, belt: Belt) -> float:
    """The height at which the cloth is narrowest near to where the belt is to be, cm.

    Cloth that narrows to no waist, as that of robes, is tied where the belt is to be.
    """
    girths: dict[float, float] = {}
    for off in np.arange(-belt.reach, belt.reach + 0.1, 1.0):
        ring = _around(garment, belt.height + off)
        if ring is not None:
            girths[float(off)] = float(np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1).sum())
    if len(girths) < 2:
        return belt.height
    around = list(girths.values())
    if min(around) > _WAISTED * min(around[0], around[-1]):
        return belt.height
    return belt.height + min(girths, key=lambda off: girths[off] * (1 + _KEEPS_TO * abs(off)))


def _buckle(belt: Belt, front: Array) -> TrimMesh:
    """A frame in the middle of the front."""
    half = np.array([0.62, 0.62]) * belt.width
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * half
    flat = np.concatenate([corners, 0.72 * corners])
    vertices = np.stack([flat[:, 0], front[1] + flat[:, 1], np.full(8, front[2] + 0.35)], axis=1)
    k, after = np.arange(4), np.roll(np.arange(4), -1)
    faces = np.concatenate([np.stack([k, after, after + 4], axis=1), np.stack([k, after + 4, k + 4], axis=1)])
    return TrimMesh(
        belt.trim, "metal", vertices, faces.astype(np.int32), np.stack([k, after], axis=1).astype(np.int32)
    )


def _knot(garment: Garment, belt: Belt, front: Array) -> list[TrimMesh]:
    """A knot, and two ends that hang from it before the cloth."""
    pieces = []
    before = garment.vertices[
        (np.abs(garment.vertices[:, 0] - front[0]) < 6.0) & (garment.vertices[:, 2] > 0)
    ]
    hem = float(before[:, 1].min()) if len(before) else front[1] - _TAIL
    # Below the hem they would hang in the air.
    longest = max(min(_TAIL * belt.width / 4.5, front[1] - hem - 1.0), 3.0)
    for side, length in ((-1, 1.0), (1, 0.88)):
        drops = np.linspace(0.0, length * longest, 12)
        middle = front[0] + side * (0.6 + 0.09 * drops)
        half = 0.36 * belt.width
        sides = np.stack([middle - half, middle + half], axis=1)
        depth = np.array(
            [front_of(garment, x, front[1] - drop) for x, drop in zip(middle, drops, strict=True)]
        )
        depth = np.maximum(np.nan_to_num(depth, nan=-np.inf), front[2] - 0.10 * drops) + 0.45
        vertices = np.stack(
            [
                sides,
                np.broadcast_to((front[1] - drops)[:, None], sides.shape),
                np.broadcast_to(depth[:, None], sides.shape),
            ],
            axis=-1,
        ).reshape(-1, 3)
        k = 2 * np.arange(len(drops) - 1)
        faces = np.concatenate([np.stack([k, k + 2, k + 3], axis=1), np.stack([k, k + 3, k + 1], axis=1)])
        edges = np.concatenate(
            [np.stack([k, k + 2], axis=1), np.stack([k + 1, k + 3], axis=1), [[k[-1] + 2, k[-1] + 3]]]
        )
        pieces.append(TrimMesh(belt.trim, "cloth", vertices, faces.astype(np.int32), edges))
    knot = ball(front + np.array([0.0, 0.0, 0.5]), (0.42 * _KNOT, 0.5 * belt.width, 0.55))
    return [*pieces, TrimMesh(belt.trim, "cloth", *knot, np.zeros((0, 2), int))]


def _is_on_band(garment: Garment) -> bool:
    """Whether the waist is a waistband, from which all else hangs."""
    names = {panel.name for panel in garment.pattern.panels}
    return names.issuperset(_BANDS) and not any("torso" in name for name in names)


def _around(
    garment: Garment, height: float, near_by: float = _BELT_REACH, *, within: Array | None = None
) -> Array | None:
    """(`_BELT_SIDES`, 2) x and z of what is stretched around the cloth near to a height, cm.

    Args:
        garment: Any garment.
        height: Above the floor, cm.
        near_by: How far up and down the cloth may be, cm.
        within: The cloth of the waistband between these two heights counts as well.
    """
    trunk = around_trunk(garment)
    points = garment.flat_positions
    own = trunk & (np.abs(points[:, 1] - height) <= near_by)
    if within is not None:
        numbers = [garment.mesh.pattern.panel_index(panel) for panel in _BANDS]
        level = (points[:, 1] >= within.min()) & (points[:, 1] <= within.max())
        own |= level & np.isin(garment.mesh.flat_panel, numbers)
    near = points[own][:, [0, 2]]
    if len(near) < 8:
        return None
    try:
        hull = ConvexHull(near)
    except QhullError:
        return None
    middle = near[hull.vertices].mean(axis=0)
    angle = np.arange(_BELT_SIDES) * (2 * np.pi / _BELT_SIDES)
    ways = np.stack([np.sin(angle), np.cos(angle)], axis=1)
    return middle + (hull_reach(hull, middle, ways) + _BELT_LIFT)[:, None] * ways
