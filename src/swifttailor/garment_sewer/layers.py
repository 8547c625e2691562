"""What lies on what: the network puts collars into the bodice, and fronts that overlap into each other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.overlaps import overlapping_fronts

LIFTED_CM, TURNED_DOWN_CM = 0.6, 1.3
"""So far collars are lifted off the bodice that they lie on. Of those that are
turned down over a stand both are lifted by the latter, and what is turned down twice."""
_FALLS_RISE = 0.5
"""Part of the rise of the second lift, on the slope of the shoulders: with all of it what is turned down may
turn up again; with less than half it passes through what it lies on."""
OVERLAPPING_CM = 0.8
"""So far above the lower one the upper of two fronts that overlap is lifted."""
_AXIS_CM = 10.0
"""So far behind such fronts the axis stands that they are lifted away from."""
_BESIDE_CM, _LOWER_ONES = 5.0, 8
"""Of the lower front what lies so near to a vertex of the upper one counts, and so many vertices at most."""


def layers_lifted(garment: Garment, body: Body) -> Floats:
    """Collars and fronts moved off what they lie on, layer by layer.

    Args:
        garment: As the network put it.
        body: Collars are lifted away from it.

    Returns:
        (v, 3) its vertices, cm; those that a layer shares with another panel stay where they are.
    """
    mesh, vertices = garment.mesh, garment.vertices.copy()
    collars, falls = (np.array([n in p.name for p in mesh.pattern.panels]) for n in ("collar", "collar_fall"))
    lift = TURNED_DOWN_CM if falls.any() else LIFTED_CM
    for lifted in filter(np.any, (collars, falls)):
        alone = _alone(mesh, lifted)
        away = _away(body, vertices[alone])[1]
        if lifted is falls:
            away[:, 1] *= _FALLS_RISE
        vertices[alone] += lift * away
    for upper, lower in overlapping_vertices(mesh):
        vertices[upper] += _above(vertices[upper], vertices[lower])
    return vertices


def _above(upper: Floats, lower: Floats) -> Floats:
    """(n, 3) by how much vertices of the upper front have to move to lie above the lower one, cm.

    They move away from a vertical axis behind them, for between two legs no direction leads away from both.
    Of what is beside a vertex the most counts, and then the mean: cloth that is lifted raggedly curls.
    """
    from scipy.spatial import KDTree

    axis = np.array([0.0, min(upper[:, 2].min(), lower[:, 2].min()) - _AXIS_CM])
    around, beneath = upper[:, ::2] - axis, lower[:, ::2] - axis
    off, heights = np.linalg.norm(around, axis=1), np.append(np.linalg.norm(beneath, axis=1), -np.inf)
    scale = heights[:-1].mean()
    seen, under = (
        KDTree(np.stack([scale * np.arctan2(flat[:, 0], flat[:, 1]), points[:, 1]], axis=1))
        for flat, points in ((around, upper), (beneath, lower))
    )
    near = under.query(seen.data, k=min(_LOWER_ONES, len(lower)), distance_upper_bound=_BESIDE_CM)[1]
    lift = np.maximum(heights[near.reshape(len(upper), -1)].max(axis=1) + OVERLAPPING_CM - off, 0.0)
    beside = seen.query_ball_point(seen.data, _BESIDE_CM)
    lift = np.array([lift[one].max() for one in beside])
    lift = np.array([lift[one].mean() for one in beside])
    moved = np.zeros_like(upper)
    moved[:, ::2] = around * (lift / off)[:, None]
    return moved


def _alone(mesh: PatternMesh, chosen: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(v,) vertices that are of chosen panels (p,) alone."""
    alone = np.ones(mesh.vertex_count, dtype=bool)
    alone[mesh.weld[~chosen[mesh.flat_panel]]] = False
    return alone


def _away(body: Body, points: Floats) -> tuple[Floats, Floats]:
    """Distance (n,) from the body, cm, and the direction (n, 3) away from it."""
    return BodyDistance.of(body).sample(points, np.zeros(len(points), dtype=bool))


def overlapping_vertices(mesh: PatternMesh) -> list[tuple[NDArray[np.bool_], NDArray[np.bool_]]]:
    """Which vertices are of fronts that overlap (`overlapping_fronts`), the upper one first.

    Returns:
        Two masks (v,) for each pair; of fronts of a torso they have what lies below where these are sewn.
    """
    at = {panel.name: k for k, panel in enumerate(mesh.pattern.panels)}
    found = []
    for names in overlapping_fronts(mesh.pattern):
        flat = [mesh.flat_panel == at[name] for name in names]
        panels = [mesh.pattern.panels[at[name]] for name in names]
        placed = [p.placement.apply(mesh.flat_vertices[f]) for p, f in zip(panels, flat, strict=True)]
        alone = [_alone(mesh, np.array([name == n for n in at])) for name in names]
        sewn = np.isin(mesh.weld[flat[0]], mesh.weld[flat[1]])
        if sewn.any():
            end = placed[0][sewn, 1].min()
            for chosen, f, where in zip(alone, flat, placed, strict=True):
                below = np.zeros(mesh.vertex_count, dtype=bool)
                below[mesh.weld[f]] = where[:, 1] < end
                chosen &= below
        if all(chosen.any() for chosen in alone):
            found.append((alone[0], alone[1]))
    return found
