"""Layers over a skirt and trains as meshes: they are laid around the sewn cloth, outside of its folds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array, Floats
from swifttailor.garment.hull_reach import hull_reach
from swifttailor.garment.trim_pieces import TrimMesh
from swifttailor.garment.trunk_cloth import around_trunk
from swifttailor.pattern.trims.shapes import Layer

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

_APART = 2.0
"""Distance of the columns of a layer, degrees."""
_ROWS = 34
_SLAB = 4.0
"""Cloth so far above and below a height tells how far the skirt reaches there, cm."""
_AT_WAIST = (-0.5, 4.0)
"""The same for the upper edge: from so far above it to so far, cm."""
_OFF, _TUCKED = 0.8, 1.0
"""How far a layer stays off the skirt, and how far under it the sides of a train go, cm."""
_FOLDS, _FINER = 11, 19
"""Folds of two sizes around the body."""
_SWING = 2.6
"""How far folds swing at the hem, cm."""
_BELL = 0.62
"""Layers widen sooner below the waist than a cone does: a power of the way down."""
_CONE = 0.95
"""The same of a skirt over shorts, which lies on the hips."""
_BESIDE, _UNEVEN = 4.0, 9.0
"""A sheer layer ends where cloth so far beside it does, degrees, if that differs by so much, cm."""
_EVEN_ROWS = 5
"""Over so many rows above and below is a skirt over shorts evened."""
_SEWN = 14.0
"""How much of a train goes under at both sides, degrees."""
_LEAVES, _POINTED = 0.5, 1.6
"""Where a train leaves the skirt, as a part of its height; and how much longer it is behind than beside."""
_OVER_LEGS = "outer skirt"
_ABOVE_FLOOR, _RIPPLE = 0.5, 1.2
"""How high a train lies, and how high its folds do, cm."""
_BENDS, _SLOPE = 0.72, 0.2
"""Where on its way down a train leaves the skirt, and how far along the floor it still comes down."""


_PUFFED, _TO_SIDES, _LESS_BELOW, _CREASED, _SAGS = 0.7, 1.3, 0.45, 0.35, 0.12
"""How round puffs are, and how fast they flatten to the sides; by which part of it those at the hem are
smaller, how deep their creases are, and how much lower they hang in the middle."""
_WORN_OVER = ("waist bow", "back bow", "tie belt", "buckle belt")
_OVER_CM, _NEAR_CM, _AROUND_CM = 0.6, 4.0, 25.0
"""How far what is worn over a layer stays off it, how near that is, and the radius of angles, cm."""


def layer_mesh(garment: Garment, layer: Layer) -> TrimMesh | None:
    """A layer around the skirt, None where there is no cloth to lay it around.

    Args:
        garment: What it is on, as it stands on the floor at height 0.
        layer: Its heights and how wide it is.
    """
    half = layer.reach
    count = max(round(2 * half / _APART), 2)
    behind = np.radians(np.linspace(-half, half, count + 1))  # from the middle of the back
    rows = _train(garment, layer, behind) if layer.behind > 0.0 else _over_skirt(garment, layer, behind)
    if rows is None:
        return None
    vertices, places = rows
    down, across = vertices.shape[:2]
    grid = np.arange(down * across).reshape(down, across)
    corners = [grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]]
    quads = np.stack(corners, axis=-1).reshape(-1, 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32)
    hem = np.stack([grid[-1, :-1], grid[-1, 1:]], axis=1)
    is_open = layer.reach < 180.0 and layer.behind <= 0.0
    sides = [np.stack([grid[:-1, k], grid[1:, k]], axis=1) for k in (0, -1)] if is_open else []
    rings = [round(k * (down - 1) / layer.hoops) for k in range(1, layer.hoops)]
    rings += [round(k * (down - 1) / layer.puffs) for k in range(1, layer.puffs)]
    across_it = [np.stack([grid[k, :-1], grid[k, 1:]], axis=1) for k in rings]
    lines = np.concatenate([hem, *sides, *across_it]).astype(np.int32)
    at = places.reshape(-1, 2)[faces]
    return TrimMesh(
        layer.trim,
        "cloth",
        vertices.reshape(-1, 3),
        faces,
        lines,
        at,
        panel=layer.panel,
        opacity=layer.opacity,
    )


def laid_over(layers: Sequence[TrimMesh], pieces: Sequence[TrimMesh]) -> list[TrimMesh]:
    """Bows and belts, where they would be under a layer brought to lie on it.

    Args:
        layers: As `layer_mesh` makes them.
        pieces: Of one garment.
    """
    from scipy.spatial import KDTree

    points = np.concatenate([layer.vertices for layer in layers])
    axis = points[:, [0, 2]].mean(axis=0) * (1.0, 0.0)
    tree = KDTree(_unrolled(points, axis))
    reach = np.hypot(*(points[:, [0, 2]] - axis).T)
    found = []
    for piece in pieces:
        if piece.trim not in _WORN_OVER:
            found.append(piece)
            continue
        away, near = tree.query(_unrolled(piece.vertices, axis))
        own = piece.vertices[:, [0, 2]] - axis
        far = np.maximum(np.hypot(*own.T), 1e-6)
        lacking = np.where(away < _NEAR_CM, np.maximum(reach[near] + _OVER_CM - far, 0.0), 0.0)
        moved = piece.vertices.copy()
        moved[:, [0, 2]] += own * (lacking / far)[:, None]
        found.append(replace(piece, vertices=moved))
    return found


def _unrolled(points: Floats, axis: Array) -> Floats:
    """(n, 2) points (n, 3) by how far around the body they are and how high, about in cm."""
    x, z = (points[:, [0, 2]] - axis).T
    return np.stack([_AROUND_CM * np.arctan2(x, z), points[:, 1]], axis=1)


def _over_skirt(garment: Garment, layer: Layer, behind: Floats) -> tuple[Floats, Floats] | None:
    """Vertices (rows, n, 3), cm, and their places on the cloth (rows, n, 2), of what hangs down."""
    heights = np.linspace(layer.height, layer.low, _ROWS)
    found = _reach(garment, heights, behind)
    if found is None:
        return None
    reach, axis = found
    if layer.trim == _OVER_LEGS:  # it hangs from the hips, whatever is cut out below them
        reach = _evened(np.maximum.accumulate(reach, axis=0))
    share = np.linspace(0.0, 1.0, _ROWS)[:, None]
    first, last = reach[0], np.maximum(reach[-1], reach[-1].mean())
    bell = _CONE if layer.trim == _OVER_LEGS else _BELL
    wide = first + (last + layer.flare - first) * share**bell
    wide = reach + layer.flare * share * _at_sides(layer, behind) if layer.puffs else wide
    folds = 0.0 if layer.hoops else _SWING * share * _waves(behind)
    radius = np.maximum(wide, reach) + _OFF + folds + _puffs(layer, share, behind)
    level = np.broadcast_to(heights[:, None], radius.shape)
    ends = _ends(garment, layer, axis, behind)
    if ends is not None:
        level = layer.height + (ends - layer.height) * share
    vertices = _around(axis, behind, radius, level)
    return vertices, _laid_out(vertices, behind, float(radius[-1].mean()))


def _evened(reach: Floats) -> Floats:
    """(rows, n) without steps from row to row, where the cloth below has edges; nowhere less than it was."""
    wide = np.pad(reach, ((_EVEN_ROWS, _EVEN_ROWS), (0, 0)), mode="edge")
    rows = np.arange(len(reach))
    mean = np.mean([wide[rows + k] for k in range(2 * _EVEN_ROWS + 1)], axis=0)
    return mean + np.maximum(reach - mean, 0.0).max(axis=0)


def _ends(garment: Garment, layer: Layer, axis: Array, behind: Floats) -> Floats | None:
    """(n,) where the cloth below ends in each direction, cm, where that is uneven: a hem in points."""
    if layer.opacity >= 1.0:
        return None
    points = garment.flat_positions[around_trunk(garment)]
    points = points[points[:, 1] < layer.height]
    ways = np.arctan2(points[:, 0] - axis[0], axis[1] - points[:, 2])
    found = []
    for way in behind:
        apart = np.abs((ways - way + np.pi) % (2 * np.pi) - np.pi)
        near = points[apart < np.radians(_BESIDE), 1]
        found.append(near.min() if len(near) else layer.low)
    ends = np.array(found)
    return ends if ends.max() - ends.min() > _UNEVEN else None


def _puffs(layer: Layer, share: Floats, behind: Floats) -> Floats:
    """(rows, n) how far out cloth stands that is gathered up in puffs, smaller ones below, cm."""
    if not layer.puffs:
        return np.zeros((len(share), len(behind)))
    sagging = share + _SAGS * (np.cos(behind) - 1.0)  # caught up higher at the sides
    rising = np.abs(np.sin(np.pi * layer.puffs * np.clip(sagging, 0.0, 1.0))) ** _PUFFED
    uneven = 1.0 - _CREASED * _waves(behind)
    return layer.puff * (1.0 - _LESS_BELOW * share) * rising * _at_sides(layer, behind) * uneven


def _at_sides(layer: Layer, behind: Floats) -> Floats:
    """(n,) from 1 in the middle of the back to 0 where what is gathered up ends beside it."""
    return np.cos(np.pi / 2 * behind / np.radians(layer.reach)).clip(0.0) ** _TO_SIDES


def _train(garment: Garment, layer: Layer, behind: Floats) -> tuple[Floats, Floats] | None:
    """The same of what leaves the skirt behind and lies on the floor."""
    levels = np.linspace(layer.height, layer.low, _ROWS)
    found = _reach(garment, levels, behind)
    if found is None:
        return None
    reach, axis = found
    # Down the skirt, then off it down to the floor, and on along this.
    leaves = layer.low + _LEAVES * (layer.height - layer.low)
    above = levels[levels > leaves][:, None]
    t = np.linspace(0.0, 1.0, _ROWS)[:, None]
    edge = np.clip((np.radians(layer.reach) - np.abs(behind)) / np.radians(_SEWN), 0.0, 1.0)
    off = _OFF * edge - _TUCKED * (1.0 - edge)

    def skirt(heights: Floats) -> Floats:
        return np.stack([np.interp(-heights[:, 0], -levels, column) for column in reach.T], axis=1)

    first, corner = skirt(np.array([[leaves]]))[0] + off, reach[-1] + off
    long = layer.behind * np.cos(np.pi / 2 * behind / np.radians(layer.reach)).clip(0.0) ** _POINTED
    legs = (1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t**2, t**3
    bend = first + _BENDS * (corner - first)
    radius = legs[0] * first + legs[1] * bend + legs[2] * (corner + _SLOPE * long) + legs[3] * (corner + long)
    below = _ABOVE_FLOOR + (leaves - _ABOVE_FLOOR) * (legs[0] + legs[1] * (1.0 - _BENDS))
    radius = np.maximum(radius, skirt(below) + off)
    waves = _waves(behind) * edge
    lying = 1.0 - below / leaves
    folds = _SWING * np.minimum(2 * t, 1.0) * (1.0 - lying) * waves
    ripples = _RIPPLE * t * lying * waves * np.minimum(long / 20.0, 1.0)
    radius = np.concatenate([skirt(above) + off, radius + folds])
    height = np.concatenate([np.broadcast_to(above, (len(above), len(behind))), below + ripples])
    vertices = _around(axis, behind, radius, height)
    return vertices, _laid_out(vertices, behind, float(reach[-1].mean()))


def _reach(garment: Garment, heights: Floats, behind: Floats) -> tuple[Floats, Floats] | None:
    """How far the cloth reaches at some heights.

    Returns:
        (rows, n) from its axis, in each direction, stretched over its folds, cm; (2,) x and z of the axis.
    """
    from scipy.spatial import ConvexHull, QhullError

    points = garment.flat_positions[around_trunk(garment)]
    ways = np.stack([np.sin(behind), -np.cos(behind)], axis=1)
    axis, rows = None, []
    for k, height in enumerate(heights):
        # At the waist the cloth above the seam tells: gathers below it stand off.
        low, high = (_AT_WAIST[0], _AT_WAIST[1]) if k == 0 else (-_SLAB, _SLAB)
        above = points[:, 1] - height
        near = points[(above >= low) & (above <= high)][:, [0, 2]]
        if len(near) < 8:
            rows.append(None)
            continue
        try:
            hull = ConvexHull(near)
        except QhullError:
            rows.append(None)
            continue
        if axis is None:
            axis = near[hull.vertices].mean(axis=0)
        rows.append(np.maximum(hull_reach(hull, axis, ways), 0.0))
    known = [k for k, row in enumerate(rows) if row is not None]
    if axis is None or not known:
        return None
    nearest = [min(known, key=lambda other: abs(other - k)) for k in range(len(rows))]
    reach = np.stack([row for k in nearest if (row := rows[k]) is not None])
    return reach, np.asarray(axis, float)


def _waves(behind: Floats) -> Floats:
    """(n,) folds from 0 to 1 around the body, no two alike."""
    return 0.5 + 0.3 * np.cos(_FOLDS * behind) + 0.2 * np.cos(_FINER * behind + 1.1)


def _around(axis: Array, behind: Floats, radius: Floats, height: Floats) -> Floats:
    """(rows, n, 3) points so far from an axis (2,), x to the left and z to the front."""
    return np.stack([axis[0] + radius * np.sin(behind), height, axis[1] - radius * np.cos(behind)], axis=-1)


def _laid_out(vertices: Floats, behind: Floats, radius: float) -> Floats:
    """(rows, n, 2) where on the cloth they lie: along it from above, and around at the hem, cm."""
    steps = np.linalg.norm(np.diff(vertices, axis=0), axis=-1)
    down = np.concatenate([np.zeros((1, steps.shape[1])), -np.cumsum(steps, axis=0)])
    return np.stack([np.broadcast_to(radius * behind, down.shape), down], axis=-1)
