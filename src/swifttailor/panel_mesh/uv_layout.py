"""Places all panels side by side in the unit square, at one scale, as texture coordinates."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.pattern.check.covering import said_regions

if TYPE_CHECKING:
    from swifttailor.panel_mesh.pattern_mesh import PatternMesh


GUTTER = 0.008
"""Free space around each panel, as a share of the square's side."""
_CLEARLY = 0.1
"""So much more of a sleeve's first axis than of its second runs down the arm where it is described lying."""
_STRIPS = 48
"""Strip widths that are tried."""


def lay_out_uv(mesh: PatternMesh, *, sleeves_upright: bool = True) -> tuple[Array, float]:
    """Lays the panels out on shelves in the unit square; (0, 0) is the lower left corner.

    Every panel keeps its upright direction (the cloth's grain) and is seen from the right side of the cloth:
    panels whose loop runs clockwise in their own coordinates, and which are thus described from the wrong
    side, are mirrored in x. A texture therefore reads correctly on the outside of the garment everywhere.
    Sleeves, which GarmentCode describes lying, stand upright as well: stripes run around the arm.

    Args:
        mesh: Any pattern mesh.
        sleeves_upright: Whether they do; earlier versions laid them as they are described.

    Returns:
        UV (m, 2) of the flat vertices, and the centimetres of cloth per unit, the same in u and v.
    """
    if not len(mesh.flat_vertices):
        return np.zeros((0, 2)), 1.0
    points, panel = cut_from_cloth(mesh, sleeves_upright=sleeves_upright), mesh.flat_panel
    high = np.zeros((len(mesh.pattern.panels), 2))
    np.maximum.at(high, panel, points)
    corner, side = pack_square(high)
    return (points + corner[panel]) / side, side


def cut_from_cloth(mesh: PatternMesh, *, sleeves_upright: bool = True) -> Array:
    """The panels as they lie on the cloth, before they are laid side by side.

    Args:
        mesh: Any pattern mesh.
        sleeves_upright: See `lay_out_uv`.

    Returns:
        (m, 2) flat vertices, cm from the lower left corner of the box around their panel.
    """
    points, panel = np.array(mesh.flat_vertices, np.float64), mesh.flat_panel
    mirrored = _wound_clockwise(mesh)
    points[mirrored[panel], 0] *= -1.0
    if sleeves_upright:
        points = _stood_upright(mesh, points, mirrored)
    low = np.full((len(mesh.pattern.panels), 2), np.inf)
    np.minimum.at(low, panel, points)
    return points - low[panel]


def _stood_upright(mesh: PatternMesh, points: Array, mirrored: Array) -> Array:
    """The points with those of sleeves that are described along the arm turned, the shoulder up.

    Args:
        mesh: Any pattern mesh.
        points: (m, 2) flat vertices, cm.
        mirrored: (n,) which panels are mirrored in x.
    """
    regions = said_regions(mesh.pattern)
    turned = points.copy()
    for k, one in enumerate(mesh.pattern.panels):
        if regions.get(one.name) != "arm":
            continue
        turn, place = one.placement.matrix(), one.placement.translation[0]
        down_the_arm = np.array([1.0 if place >= 0 else -1.0, -1.0, 0.0]) / np.sqrt(2.0)
        along = turn[:, 0] @ down_the_arm
        if abs(along) <= abs(turn[:, 1] @ down_the_arm) + _CLEARLY:
            continue
        own = mesh.flat_panel == k
        x, y = points[own].T
        quarter = np.sign(along) * (-1.0 if mirrored[k] else 1.0)
        turned[own] = np.stack([quarter * y, -quarter * x], axis=1)
    return turned


def pack_square(sizes: Array) -> tuple[Array, float]:
    """Packs boxes on shelves, tallest first, into a square that is as small as a few trials can make it.

    Args:
        sizes: (n, 2) widths and heights, not negative.

    Returns:
        Lower left corners (n, 2) of the boxes and the side of the square. Around every box at least
        ``GUTTER`` of the side stays free.
    """
    widest = float(sizes.max(initial=0.0)) or 1.0
    area_side = float(np.sqrt(sizes.prod(axis=1).sum()))
    best: tuple[Array, float] | None = None
    for strip in np.geomspace(max(widest, area_side), max(widest, 2.0 * area_side) * 1.25, _STRIPS):
        gutter = GUTTER * float(strip) * 1.05
        corners, height = pack_shelves(sizes, float(strip) + 2 * gutter, gutter)
        width = float((corners[:, 0] + sizes[:, 0]).max()) + gutter
        side = max(width, height)
        gutter_kept = gutter >= GUTTER * side
        if gutter_kept and (best is None or side < best[1] * (1 - 1e-9)):
            best = corners, side
    if best is None:  # one shelf above the other is higher than any strip tried is wide
        gutter = GUTTER * 2 * float(sizes[:, 1].sum() + widest)
        corners, height = pack_shelves(sizes, widest + 2 * gutter, gutter)
        best = corners, max(float((corners[:, 0] + sizes[:, 0]).max()) + gutter, height)
    return best


def pack_shelves(sizes: Array, strip: float, gutter: float) -> tuple[Array, float]:
    """Packs boxes (n, 2) into a strip, tallest first, shelf upon shelf, `gutter` apart.

    Returns:
        Lower left corners (n, 2) and the height used, gutters included.
    """
    order = np.lexsort((np.arange(len(sizes)), -sizes[:, 0], -sizes[:, 1]))
    corners = np.zeros((len(sizes), 2))
    x, y, shelf = gutter, gutter, 0.0
    for k in order:
        width, height = sizes[k]
        if x > gutter and x + width + gutter > strip * (1 + 1e-12):
            x, y, shelf = gutter, y + shelf + gutter, 0.0
        corners[k] = x, y
        x += width + gutter
        shelf = max(shelf, height)
    return corners, y + shelf + gutter


def _wound_clockwise(mesh: PatternMesh) -> Array:
    """(n,) whether each panel's faces run clockwise in its own coordinates."""
    corners = np.asarray(mesh.flat_vertices, np.float64)[mesh.flat_faces]
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    return np.bincount(mesh.face_panel, area, len(mesh.pattern.panels)) < 0.0
