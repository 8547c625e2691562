"""Wide trouser legs that were predicted through each other, moved apart.

Draped, one leg lies in front of the other or the other way round; the mean of both passes through itself.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import panel_regions

GAP_CM = 0.4
"""How far from the middle the inside of each leg is moved."""
OVERLAP_CM = 1.0
"""Legs that reach over the middle by less stay as they are."""
MOVED_PER_HIPS = 0.115
"""What lies further from the middle than this part of the hip girth, the axis of a leg, is not moved."""
_BIN_CM = 3.0
_FREE_CM = 8.0
"""What is sewn together down to less than this above its hem has no legs."""


def legs_apart(mesh: PatternMesh, vertices: Floats, *, hips: float) -> Floats | None:
    """Pushes the inside of each leg back over the middle, height by height, and what lies beside it less.

    Args:
        mesh: Of the garment; legs are panels of that region to the left and right of the middle.
        vertices: (v, 3) where it lies, cm.
        hips: Girth of the body's hips, cm.

    Returns:
        (v, 3) where it lies then, shorter across than it was cut; None where there are no legs, or they do
        not reach over the middle.
    """
    side = _sides(mesh)
    joined = side == 0
    if not (side == 1).any() or not (side == -1).any() or not joined.any():
        return None
    height, across = vertices[:, 1], vertices[:, 0] * np.where(np.isnan(side), 0.0, side)
    crotch = height[joined].min()
    legs = [(way, (side == way) & (height < crotch)) for way in (-1, 1)]
    if not all(leg.any() and crotch - height[leg].min() > _FREE_CM for _, leg in legs):
        return None
    moved = vertices.copy()
    reaches = False
    for way, leg in legs:
        inner = _inner_edge(height[leg], across[leg])
        reaches |= bool((inner < -OVERLAP_CM).any())
        inner = np.minimum(inner, GAP_CM)
        axis = MOVED_PER_HIPS * hips
        share = np.clip((across[leg] - inner) / (axis - inner), 0.0, 1.0)
        apart = np.where(across[leg] < axis, GAP_CM + share * (axis - GAP_CM), across[leg])
        moved[leg, 0] = way * np.maximum(across[leg], apart)
    return moved if reaches else None


def _sides(mesh: PatternMesh) -> Floats:
    """(v,) 1 on panels of the left leg, -1 of the right, 0 where both meet, nan on no leg."""
    regions = panel_regions(mesh.pattern)
    found = np.full((2, mesh.vertex_count), False)
    for k, panel in enumerate(mesh.pattern.panels):
        if regions[panel.name] == "leg":
            of_panel = mesh.flat_panel == k
            placed = panel.placement.apply(mesh.flat_vertices[of_panel])
            found[int(placed[:, 0].mean() > 0), mesh.weld[of_panel]] = True
    right, left = found
    return np.where(right | left, left.astype(float) - right, np.nan)


def _inner_edge(height: Floats, across: Floats) -> Floats:
    """(n,) how far in cloth reaches at each vertex's height or within a bin of it, cm."""
    bins: NDArray[np.int64] = np.floor((height - height.min()) / _BIN_CM).astype(np.int64)
    innermost = np.full(int(bins.max()) + 3, np.inf)
    np.minimum.at(innermost, bins + 1, across)
    near = np.minimum(np.minimum(innermost[:-2], innermost[1:-1]), innermost[2:])
    middles = height.min() + (np.arange(len(near)) + 0.5) * _BIN_CM
    return np.interp(height, middles, near)
