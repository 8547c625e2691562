"""Predicted garments whose cloth came out crumpled, let fall for a moment."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.draping.fabric import Fabric
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.crumpling import CrumpledGarment
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.progress import StageProgress

VERY_CRUMPLED = 0.5
"""From this share on a garment falls for twice as long: circle skirts of more than a circle."""
CRUMPLED_ALL_OVER = 0.35
"""Below this share little of a garment has to move, and what slips was right before: hoods, wide necks."""
SLIPPED_CM, UPPERMOST = 2.5, 0.1
"""So far the uppermost tenth of the vertices may fall on average."""
MORE_CROSSINGS = 0.01
"""So many more, per face, may an edge and a face cross than before: a fold that touches itself is better than
cloth that is too short all over."""
_SLIPPED = "It would have slipped down."
_TANGLED = "It would have passed through itself far more than as it was predicted."


def relaxed_where_crumpled(
    garment: Garment,
    *,
    body: Body | None = None,
    fabric: Fabric | str = "cotton",
    progress: StageProgress | None = None,
) -> Garment:
    """A garment as GarmentSewer made it, or after a moment of physics where it is crumpled.

    Args:
        garment: Of `GarmentSewer.decode`.
        body: What it is worn by; see `relax`.
        fabric: A `Fabric` or the name of a preset.
        progress: Called with the name of a stage and the share of it that is done.

    Returns:
        The garment. Where the cloth went to infinity, slipped down, or passes through itself in far more
        places than before, it is as it was, and its report says so under ``not_relaxed``.
    """
    if not isinstance(garment, CrumpledGarment) or garment.folded is None:
        return garment
    from swifttailor.draping.compiled_code import COMPILE_NOTE, solver_is_compiled
    from swifttailor.draping.relax import FRAMES, relax

    say = progress or (lambda stage, share: None)
    if not solver_is_compiled():
        say(COMPILE_NOTE, 0.0)
    frames = 2 * FRAMES if garment.report["sewing"]["crumpled"] > VERY_CRUMPLED else FRAMES
    folded = replace(garment, vertices=garment.folded, folded=None)
    try:
        relaxed = relax(folded, body=body, fabric=fabric, frames=frames, progress=progress)
    except SimulationError as error:
        return replace(garment, report=garment.report | {"not_relaxed": str(error)})
    seconds = relaxed.report["seconds"]
    if garment.report["sewing"]["crumpled"] < CRUMPLED_ALL_OVER and _slipped(garment, relaxed) > SLIPPED_CM:
        return replace(garment, report=garment.report | {"not_relaxed": _SLIPPED, "seconds": seconds})
    allowed = _crossings(garment.mesh, garment.vertices) + MORE_CROSSINGS * len(garment.mesh.faces)
    if _crossings(garment.mesh, relaxed.vertices) > allowed:
        return replace(garment, report=garment.report | {"not_relaxed": _TANGLED, "seconds": seconds})
    return relaxed


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
