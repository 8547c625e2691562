"""Predicted garments whose cloth came out crumpled, let fall for a moment."""

from __future__ import annotations

from swifttailor.body import Body
from swifttailor.draping.fabric import Fabric
from swifttailor.errors import SimulationError
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.crumpling import CRUMPLED
from swifttailor.progress import StageProgress

VERY_CRUMPLED = 0.5
"""From this share on a garment falls for twice as long: circle skirts of more than a circle."""


def is_crumpled(garment: Garment) -> bool:
    """Whether so much of a garment's cloth was predicted too short that it has to be relaxed."""
    return _share(garment) > CRUMPLED


def _share(garment: Garment) -> float:
    return float(garment.report.get("sewing", {}).get("crumpled", 0.0))


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
        The garment. Where the cloth went to infinity it is as it was, and its report says so under
        ``not_relaxed``.
    """
    if not is_crumpled(garment):
        return garment
    from swifttailor.draping.compiled_code import COMPILE_NOTE, solver_is_compiled
    from swifttailor.draping.relax import FRAMES, relax

    say = progress or (lambda stage, share: None)
    if not solver_is_compiled():
        say(COMPILE_NOTE, 0.0)
    try:
        frames = 2 * FRAMES if _share(garment) > VERY_CRUMPLED else FRAMES
        return relax(garment, body=body, fabric=fabric, frames=frames, progress=progress)
    except SimulationError as error:
        return Garment(garment.mesh, garment.vertices, garment.report | {"not_relaxed": str(error)})
