"""Predicted garments, let fall for a moment.

What the network predicts lies where the garment lies, but its seams ripple, its collars stand off, its wide
skirts are crumpled (`crumpling.py`) and its wide legs lie in each other (`legs_apart.py`). A moment of
physics makes cloth of it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.body.wearer import body_of
from swifttailor.draping.fabric import Fabric
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.crumpling import CRUMPLED, smoothed_where_crumpled
from swifttailor.garment_sewer.legs_apart import legs_apart
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import panel_regions
from swifttailor.pattern.overlaps import overlapping_fronts
from swifttailor.progress import StageProgress

CRUMPLED_FRAMES = 20
"""For so many sixtieths of a second crumpled garments fall: wide skirts get most of their folds in these."""
VERY_CRUMPLED = 0.5
"""From this share on a garment falls for twice as long: circle skirts of more than a circle."""
CRUMPLED_ALL_OVER = 0.35
"""Below this share little of a garment has to move, and what slips was right before: hoods, wide necks."""
APART_FRAMES = 14
"""So long legs fall that were moved apart."""
SLIPPED_CM, UPPERMOST = 2.5, 0.1
"""So far the uppermost tenth of the vertices may fall on average."""
LIFTED_CM, TURNED_DOWN_CM = 0.6, 0.9
"""So far collars are lifted first: the network puts them into the bodice that they lie on. Of those that are
turned down over a stand both are lifted by the latter, and what is turned down twice."""
OVERLAPPING_CM, OVERLAPPING_FRAMES = 1.5, 24
"""So far above the lower one the upper of two fronts that overlap is lifted, and so long it falls."""
_AXIS_CM = 10.0
"""So far behind such fronts the axis stands that they are lifted away from."""
_BESIDE_CM, _LOWER_ONES = 5.0, 8
"""Of the lower front what lies so near to a vertex of the upper one counts, and so many vertices at most."""
MORE_CROSSINGS = 0.01
"""So many more, per face, may an edge and a face cross than before: a fold that touches itself is better than
cloth that is too short all over."""
_SLIPPED = "It would have slipped down."
_TANGLED = "It would have passed through itself far more than as it was predicted."


def relaxed(
    garment: Garment,
    *,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    progress: StageProgress | None = None,
) -> Garment:
    """A garment as GarmentSewer made it, after a moment of physics.

    Args:
        garment: Of `GarmentSewer.decode`.
        body: What it is worn by; see `relax`.
        fabric: A `Fabric` or the name of a preset.
        progress: Called with the name of a stage and the share of it that is done.

    Returns:
        The garment. Where the cloth went to infinity, slipped down, or passes through itself in far more
        places than before, it is as it was, and its report says so under ``not_relaxed``.
    """
    crumpled = garment.report.get("sewing", {}).get("crumpled")
    if crumpled is None:  # another network's
        return garment
    from swifttailor.draping.compiled_code import COMPILE_NOTE, solver_is_compiled
    from swifttailor.draping.relax import FRAMES, relax

    say = progress or (lambda stage, share: None)
    if not solver_is_compiled():
        say(COMPILE_NOTE, 0.0)
    body = body_of(garment.pattern.drafted_for) if body is None else body
    frames, smooth = FRAMES, None
    begun = replace(garment, vertices=_with_layers_lifted(garment, body))
    if _overlapping(garment.mesh):
        frames = OVERLAPPING_FRAMES
    if crumpled > CRUMPLED:
        frames = 2 * CRUMPLED_FRAMES if crumpled > VERY_CRUMPLED else CRUMPLED_FRAMES
        smooth = _smoothed(begun, body)
    start = begun.vertices if smooth is None else smooth
    apart = legs_apart(begun.mesh, start, hips=body.measurements.hips)
    if apart is not None:
        frames, smooth = max(frames, APART_FRAMES), apart
    try:
        fallen = relax(begun, body=body, fabric=fabric, frames=frames, grown_from=smooth, progress=progress)
    except SimulationError as error:
        return replace(garment, report=garment.report | {"not_relaxed": str(error)})
    seconds = fallen.report["seconds"]
    if crumpled < CRUMPLED_ALL_OVER and _slipped(garment, fallen) > SLIPPED_CM:
        return replace(garment, report=garment.report | {"not_relaxed": _SLIPPED, "seconds": seconds})
    allowed = _crossings(garment.mesh, garment.vertices) + MORE_CROSSINGS * len(garment.mesh.faces)
    if _crossings(garment.mesh, fallen.vertices) > allowed:
        return replace(garment, report=garment.report | {"not_relaxed": _TANGLED, "seconds": seconds})
    return fallen


def _with_layers_lifted(garment: Garment, body: Body) -> Floats:
    """(v, 3) its vertices, those of upper layers alone moved away from the body, layer by layer."""
    mesh, vertices = garment.mesh, garment.vertices.copy()
    collars, falls = (np.array([n in p.name for p in mesh.pattern.panels]) for n in ("collar", "collar_fall"))
    lift = TURNED_DOWN_CM if falls.any() else LIFTED_CM
    for lifted in filter(np.any, (collars, falls)):
        alone = _alone(mesh, lifted)
        vertices[alone] += lift * _away(body, vertices[alone])[1]
    for upper, lower in _overlapping(mesh):
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


def _overlapping(mesh: PatternMesh) -> list[tuple[NDArray[np.bool_], NDArray[np.bool_]]]:
    """Vertices (v,), (v,) of fronts that overlap, the upper first; of a torso, below where they are sewn."""
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


def _smoothed(garment: Garment, body: Body) -> Floats:
    """Smooth but for what it hangs from, sleeves and hoods, which slip when they are short for a while."""
    from swifttailor.draping.attachment import find_attachment

    mesh, levels = garment.mesh, body.measurements
    held = np.zeros(mesh.vertex_count, dtype=bool)
    held[find_attachment(mesh, levels).vertices] = True
    held[garment.vertices[:, 1] > levels.armpit_level] = True
    on_arm = np.array([region == "arm" for region in panel_regions(mesh.pattern).values()])
    held[mesh.weld[on_arm[mesh.flat_panel]]] = True
    return smoothed_where_crumpled(mesh, garment.vertices, held)


def _slipped(before: Garment, after: Garment) -> float:
    """How far the uppermost part of a garment fell, cm."""
    heights = before.vertices[:, 1]
    upper = heights >= np.quantile(heights, 1 - UPPERMOST)
    return float((heights - after.vertices[:, 1])[upper].mean())


def _crossings(mesh: PatternMesh, vertices: Floats) -> int:
    """Pairs of an edge and a face that cross."""
    from swifttailor.draping.intersections import self_intersections
    from swifttailor.panel_mesh.topology import edge_faces

    return self_intersections(vertices, edge_faces(mesh.faces)[0], mesh.faces)
