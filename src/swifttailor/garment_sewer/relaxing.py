"""Predicted garments, let fall for a moment.

What the network predicts lies where the garment lies, but its seams ripple, its collars stand off, its wide
skirts are crumpled (`crumpling.py`) and its wide legs lie in each other (`legs_apart.py`). A moment of
physics makes cloth of it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Bools, Floats
from swifttailor.body import Body
from swifttailor.body.wearer import body_of
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.tied import Tie, tie_around
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.garment.trim_belts import belt_height
from swifttailor.garment.trunk_cloth import around_trunk
from swifttailor.garment_sewer.clear_of_feet import clear_of_feet
from swifttailor.garment_sewer.collars_above import collar_above
from swifttailor.garment_sewer.covering import cover_cleft
from swifttailor.garment_sewer.crumpling import CRUMPLED, smoothed_where_crumpled
from swifttailor.garment_sewer.flare_evened import flare_evened
from swifttailor.garment_sewer.layers import layers_lifted, overlapping_vertices
from swifttailor.garment_sewer.legs_apart import legs_apart
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pleats_laid import pleats_laid
from swifttailor.garment_sewer.sleeves_laid import sleeves_laid
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import panel_regions
from swifttailor.pattern.trims.placing import place_trims
from swifttailor.pattern.trims.shapes import Belt
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
OVERLAPPING_FRAMES = 40
"""So long fronts fall that overlap."""
PLEATED_FRAMES = 24
"""So long pleats fall after they were laid."""
SLEEVE_FRAMES = 20
"""So long sleeves fall that were laid around the arms."""
WIDE_FRAMES = 20
"""So long tops fall that hang free of the waist: as they were predicted, they stand out like bells."""
TIED_FRAMES = 30
"""So long garments fall that a belt draws in."""
FREE_CM = 2.4
"""Free is what lies farther from the body, in the median, between waist and hips."""
_BELOW_CROWN = 0.96
"""Hoods reach higher, as a part of the height."""
SMOOTHED_FRAMES = 8
"""For so long close garments are smoothed down before: their backs lie in rolls above the seat else."""
CLOSE_BEHIND_CM, _HALF_BACK_CM = 1.9, 16.0
"""Close is what lies no farther from the back, in the median, between the armpits and the hips."""
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
    begun = replace(garment, vertices=layers_lifted(garment, body))
    flared = flare_evened(begun, body)
    begun = begun if flared is None else replace(begun, vertices=flared)
    sleeves = sleeves_laid(begun.mesh, begun.vertices, body)
    if sleeves is not None:
        begun = replace(begun, vertices=sleeves)
    if overlapping_vertices(garment.mesh):
        frames = OVERLAPPING_FRAMES
    elif hangs_free(begun, body):
        frames = WIDE_FRAMES
    frames = frames if sleeves is None else max(frames, SLEEVE_FRAMES)
    pleated = pleats_laid(begun.mesh, begun.vertices, body)
    if pleated is not None:
        begun, frames = replace(begun, vertices=pleated), PLEATED_FRAMES
    elif crumpled > CRUMPLED:
        frames = max(frames, 2 * CRUMPLED_FRAMES if crumpled > VERY_CRUMPLED else CRUMPLED_FRAMES)
        smooth = _smoothed(begun, body)
    start = begun.vertices if smooth is None else smooth
    apart = legs_apart(begun.mesh, start, hips=body.measurements.hips)
    if apart is not None:
        frames, smooth = max(frames, APART_FRAMES), apart
    is_plain = pleated is None and smooth is None
    begun = replace(begun, vertices=clear_of_feet(begun.vertices, body))
    smooth = None if smooth is None else clear_of_feet(smooth, body)
    tie = belt_tie(begun, body)
    frames = frames if tie is None else max(frames, TIED_FRAMES)
    above = collar_above(begun.mesh, begun.vertices, body)
    smoothed = SMOOTHED_FRAMES if is_plain and lies_close_behind(begun.vertices, body) else 0
    try:
        fallen = relax(
            begun,
            body=body,
            fabric=fabric,
            frames=frames,
            smoothed=smoothed,
            grown_from=smooth,
            carefully=apart is not None,  # cloth that comes from between legs may be pulled through one
            holds=[hold for hold in (tie, above) if hold is not None],
            progress=progress,
        )
    except SimulationError as error:
        return replace(garment, report=garment.report | {"not_relaxed": str(error)})
    seconds = fallen.report["seconds"]
    if crumpled < CRUMPLED_ALL_OVER and _slipped(garment, fallen) > SLIPPED_CM:
        return replace(garment, report=garment.report | {"not_relaxed": _SLIPPED, "seconds": seconds})
    more = _crossings(garment.mesh, fallen.vertices) - MORE_CROSSINGS * len(garment.mesh.faces)
    if more > 0 and more > _crossings(garment.mesh, garment.vertices):
        return replace(garment, report=garment.report | {"not_relaxed": _TANGLED, "seconds": seconds})
    return replace(fallen, vertices=cover_cleft(fallen.mesh, fallen.vertices, body))


def belt_tie(garment: Garment, body: Body) -> Tie | None:
    """What draws in a garment that hangs from the shoulders and has a belt; None where nothing does."""
    belts = [piece for piece in place_trims(garment.pattern) if isinstance(piece, Belt) and piece.reach > 0.0]
    if not belts or belts[0].trim == "apron":
        return None
    trunk = np.unique(garment.mesh.weld[around_trunk(garment)])
    height = belt_height(garment, belts[0])
    return tie_around(garment.vertices, trunk, height, belts[0].width, body)


def hangs_free(garment: Garment, body: Body) -> bool:
    """Whether it is a top or a dress, say, that hangs from the shoulders well away from waist and hips.

    What has a hood does not: it would slip off the head.
    """
    levels, y = body.measurements, garment.vertices[:, 1]
    if not levels.armpit_level < y.max() < _BELOW_CROWN * levels.height:
        return False
    points = garment.vertices[(y < levels.waist_level) & (y > levels.hips_level) & ~_on_arms(garment.mesh)]
    if not len(points):
        return False
    distances, _ = BodyDistance.of(body).sample(points, np.zeros(len(points), dtype=bool))
    return float(np.median(distances)) > FREE_CM


def _on_arms(mesh: PatternMesh) -> Bools:
    """Which vertices belong to sleeves."""
    on_arm = np.array([region == "arm" for region in panel_regions(mesh.pattern).values()])
    sleeves = np.zeros(mesh.vertex_count, dtype=bool)
    sleeves[mesh.weld[on_arm[mesh.flat_panel]]] = True
    return sleeves


def _smoothed(garment: Garment, body: Body) -> Floats:
    """Smooth but for what it hangs from, sleeves and hoods, which slip when they are short for a while."""
    from swifttailor.draping.attachment import find_attachment

    mesh, levels = garment.mesh, body.measurements
    held = np.zeros(mesh.vertex_count, dtype=bool)
    held[find_attachment(mesh, levels).vertices] = True
    held[garment.vertices[:, 1] > levels.armpit_level] = True
    held |= _on_arms(mesh)
    return smoothed_where_crumpled(mesh, garment.vertices, held)


def lies_close_behind(vertices: Floats, body: Body) -> bool:
    """Whether it is a top or a dress, say, that follows the back."""
    levels = body.measurements
    x, y, z = vertices.T
    behind = (y < levels.armpit_level) & (y > levels.hips_level) & (z < 0) & (np.abs(x) < _HALF_BACK_CM)
    if not behind.any() or y.max() < levels.armpit_level:
        return False
    points = vertices[behind]
    distances, _ = BodyDistance.of(body).sample(points, np.zeros(len(points), dtype=bool))
    return float(np.median(distances)) < CLOSE_BEHIND_CM


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
